#include "ompl_mfa/benchmark/ProblemSpace.h"

#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateProjections.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

namespace ompl_mfa
{
    namespace
    {
        namespace ob = ompl::base;

        template <typename Space>
        ob::StateSpacePtr bounded(const std::shared_ptr<Space> &space, const ob::RealVectorBounds &bounds)
        {
            space->setBounds(bounds);
            return space;
        }

        /* All coordinates as they are. OMPL's own choices are an identity that aborts in 1.5.2 (its vector is taken to
           be as long as its size in bytes) and, above two dimensions, random directions. */
        void registerIdentityProjection(const ob::StateSpacePtr &space)
        {
            std::vector<unsigned int> components(space->getDimension());
            std::iota(components.begin(), components.end(), 0U);
            space->registerDefaultProjection(
                std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(space, components));
        }

        /* OMPL wants angles in [-pi, pi] and aborts on others. */
        double normalisedAngle(double angle)
        {
            return std::remainder(angle, boost::math::constants::two_pi<double>());
        }
    }  // namespace

    unsigned int positionDimension(StateSpaceKind kind)
    {
        return kind == StateSpaceKind::R3 || kind == StateSpaceKind::SE3 ? 3 : 2;
    }

    ob::StateSpacePtr makeStateSpace(const ProblemConfig &problem, const ob::RealVectorBounds &bounds)
    {
        const double radius = problem.turningRadius;
        ob::StateSpacePtr space;
        switch (problem.space)
        {
            case StateSpaceKind::R2:
            case StateSpaceKind::R3:
                space = bounded(std::make_shared<ob::RealVectorStateSpace>(positionDimension(problem.space)), bounds);
                registerIdentityProjection(space);
                return space;
            case StateSpaceKind::DUBINS:
                return bounded(std::make_shared<ob::DubinsStateSpace>(radius), bounds);
            case StateSpaceKind::DUBINS_SYMMETRIC:
                return bounded(std::make_shared<ob::DubinsStateSpace>(radius, true), bounds);
            case StateSpaceKind::REEDS_SHEPP:
                return bounded(std::make_shared<ob::ReedsSheppStateSpace>(radius), bounds);
            case StateSpaceKind::SE2:
                space = bounded(std::make_shared<ob::SE2StateSpace>(), bounds);
                break;
            case StateSpaceKind::SE3:
                space = bounded(std::make_shared<ob::SE3StateSpace>(), bounds);
                break;
        }
        if (problem.rotationWeight)
            space->as<ob::CompoundStateSpace>()->setSubspaceWeight(1, *problem.rotationWeight);
        return space;
    }

    ob::ScopedState<> makeState(const ob::StateSpacePtr &space, StateSpaceKind kind, const ConfigPose &pose)
    {
        ob::ScopedState<> state(space);
        const double position[] = {pose.x, pose.y, pose.z};
        for (unsigned int i = 0; i < positionDimension(kind); ++i)
            *space->getValueAddressAtIndex(state.get(), i) = position[i];
        if (kind == StateSpaceKind::SE3)
            state->as<ob::SE3StateSpace::StateType>()->rotation().setAxisAngle(pose.axis[0], pose.axis[1], pose.axis[2],
                                                                               normalisedAngle(pose.theta));
        else if (kind != StateSpaceKind::R2 && kind != StateSpaceKind::R3)
            state->as<ob::SE2StateSpace::StateType>()->setYaw(normalisedAngle(pose.theta));
        return state;
    }

    std::string describePose(StateSpaceKind kind, const ConfigPose &pose)
    {
        std::ostringstream out;
        out << "(" << pose.x << ", " << pose.y;
        if (positionDimension(kind) == 3)
            out << ", " << pose.z;
        if (kind != StateSpaceKind::R2 && kind != StateSpaceKind::R3)
            out << ", theta " << pose.theta;
        out << ")";
        return out.str();
    }
}  // namespace ompl_mfa
