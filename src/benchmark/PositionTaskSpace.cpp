#include "benchmark/PositionTaskSpace.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_mfa
{
    namespace
    {
        ompl::base::RealVectorBounds positionBounds(const ompl::base::StateSpace *space)
        {
            if (const auto *vectors = dynamic_cast<const ompl::base::RealVectorStateSpace *>(space))
                return vectors->getBounds();
            if (const auto *planar = dynamic_cast<const ompl::base::SE2StateSpace *>(space))
                return planar->getBounds();
            if (const auto *spatial = dynamic_cast<const ompl::base::SE3StateSpace *>(space))
                return spatial->getBounds();
            throw ompl::Exception("the state space '" + space->getName() + "' has no position to explore");
        }
    }  // namespace

    PositionTaskSpace::PositionTaskSpace(const ompl::base::SpaceInformationPtr &si)
      : space_(si->getStateSpace().get())
      , bounds_(positionBounds(space_))
      , sampler_(space_->allocDefaultStateSampler())
    {
    }

    int PositionTaskSpace::getDimension() const
    {
        return static_cast<int>(bounds_.low.size());
    }

    void PositionTaskSpace::project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> position) const
    {
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
            position[i] = *space_->getValueAddressAtIndex(state, i);
    }

    void PositionTaskSpace::sample(Eigen::Ref<Eigen::VectorXd> position) const
    {
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
            position[i] = rng_.uniformReal(bounds_.low[i], bounds_.high[i]);
    }

    bool PositionTaskSpace::lift(const Eigen::Ref<Eigen::VectorXd> &position, const ompl::base::State * /*seed*/,
                                 ompl::base::State *state) const
    {
        sampler_->sampleUniform(state);
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
            *space_->getValueAddressAtIndex(state, i) = position[i];
        return true;
    }
}  // namespace ompl_mfa
