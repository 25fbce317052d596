#ifndef OMPL_MFA_BENCHMARK_POSITION_TASK_SPACE_
#define OMPL_MFA_BENCHMARK_POSITION_TASK_SPACE_

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/geometric/planners/rrt/TSRRT.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_mfa
{
    /** \brief The task space that TSRRT explores: the position in R^n, SE2, SE3 and the car spaces on SE2. */
    class PositionTaskSpace : public ompl::geometric::TaskSpaceConfig
    {
    public:
        /** \brief Throws ompl::Exception when the space of \e si has no position. */
        explicit PositionTaskSpace(const ompl::base::SpaceInformationPtr &si);

        int getDimension() const override;

        void project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> position) const override;

        void sample(Eigen::Ref<Eigen::VectorXd> position) const override;

        /** \brief A state at \e position whose orientation is drawn anew; TSRRT interpolates towards it. */
        bool lift(const Eigen::Ref<Eigen::VectorXd> &position, const ompl::base::State *seed,
                  ompl::base::State *state) const override;

    private:
        const ompl::base::StateSpace *space_;
        ompl::base::RealVectorBounds bounds_;
        ompl::base::StateSamplerPtr sampler_;
        mutable ompl::RNG rng_;
    };
}  // namespace ompl_mfa

#endif
