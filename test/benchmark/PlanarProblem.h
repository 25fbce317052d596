#ifndef OMPL_MFA_TEST_BENCHMARK_PLANAR_PROBLEM_
#define OMPL_MFA_TEST_BENCHMARK_PLANAR_PROBLEM_

#include <cmath>
#include <memory>

#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

namespace ompl_mfa_test
{
    /* The square [0, 10]^2 without a disc around its centre; clearance is exact. */
    class DiscChecker : public ompl::base::StateValidityChecker
    {
    public:
        DiscChecker(const ompl::base::SpaceInformationPtr &si, double radius)
          : ompl::base::StateValidityChecker(si)
          , radius_(radius)
        {
        }

        bool isValid(const ompl::base::State *state) const override
        {
            return clearance(state) > 0.0;
        }

        double clearance(const ompl::base::State *state) const override
        {
            const auto &x = *state->as<ompl::base::RealVectorStateSpace::StateType>();
            return std::hypot(x[0] - 5.0, x[1] - 5.0) - radius_;
        }

    private:
        double radius_;
    };

    /* From (1, 5) to (9, 5) around the disc. */
    inline ompl::geometric::SimpleSetupPtr planarProblem(double radius = 2.0)
    {
        const auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
        space->setBounds(0.0, 10.0);
        auto setup = std::make_shared<ompl::geometric::SimpleSetup>(space);
        const auto &si = setup->getSpaceInformation();
        setup->setStateValidityChecker(std::make_shared<DiscChecker>(si, radius));
        setup->setOptimizationObjective(std::make_shared<ompl::base::PathLengthOptimizationObjective>(si));
        ompl::base::ScopedState<> start(space);
        ompl::base::ScopedState<> goal(space);
        start[0] = 1.0;
        start[1] = 5.0;
        goal[0] = 9.0;
        goal[1] = 5.0;
        setup->setStartAndGoalStates(start, goal);
        return setup;
    }

    /* Length of the shortest path of planarProblem(): two tangents and an arc. */
    inline double planarOptimum(double radius = 2.0)
    {
        const double tangent = std::sqrt(16.0 - radius * radius);
        return 2.0 * tangent + radius * 2.0 * std::asin(radius / 4.0);
    }
}  // namespace ompl_mfa_test

#endif
