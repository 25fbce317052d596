#include "ompl_mfa/planner/InformedSampler.h"

#include <cmath>
#include <limits>
#include <utility>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

#include "ompl_mfa/path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        constexpr unsigned int TRIES = 20;

        /* Whether the distance of the space is never below the Euclidean distance of all its scaled positions together:
           true of OMPL's own spaces, unknown of a space that a user derived from them. */
        bool boundedByPositions(const ob::StateSpace &space)
        {
            if (isExactly<ob::RealVectorStateSpace, ob::SO2StateSpace, ob::SO3StateSpace>(space))
                return true;
            if (!isExactly<ob::CompoundStateSpace, ob::SE2StateSpace, ob::SE3StateSpace, ob::DubinsStateSpace,
                           ob::ReedsSheppStateSpace>(space))
                return false;
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            const bool curved = isExactly<ob::DubinsStateSpace, ob::ReedsSheppStateSpace>(space);
            for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
            {
                const double weight = compound.getSubspaceWeight(i);
                if (weight <= 0.0 || (curved && weight > 1.0) || !boundedByPositions(*compound.getSubspace(i)))
                    return false;
            }
            return true;
        }
    }  // namespace

    InformedSampler::InformedSampler(StateChartPtr chart, const CostBounds &bounds, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , bounds_(bounds)
      , rng_(seed)
      , direct_(chart_->positionDimension() > 1 && boundedByPositions(*chart_->space()) && bounds_.certain())
      , focus1_(chart_->positionDimension())
      , focus2_(chart_->positionDimension())
      , values_(chart_->positionDimension())
    {
    }

    bool InformedSampler::samplePositions(const ob::State *start, const ob::State *goal, double bound, ob::State *state)
    {
        chart_->positions(start, focus1_);
        chart_->positions(goal, focus2_);
        if (!hyperspheroid_ || focus1_ != hyperspheroidFocus1_ || focus2_ != hyperspheroidFocus2_)
        {
            hyperspheroid_ = std::make_shared<ompl::ProlateHyperspheroid>(static_cast<unsigned int>(focus1_.size()),
                                                                          focus1_.data(), focus2_.data());
            hyperspheroidFocus1_ = focus1_;
            hyperspheroidFocus2_ = focus2_;
        }
        if (bound <= hyperspheroid_->getMinTransverseDiameter())
            return false;
        hyperspheroid_->setTransverseDiameter(bound);
        for (unsigned int k = 0; k < TRIES; ++k)
        {
            rng_.uniformProlateHyperspheroid(hyperspheroid_, values_.data());
            if (chart_->setPositions(values_, state))
                return true;
        }
        return false;
    }

    bool InformedSampler::sample(const ob::State *start, const ob::State *goal, double bound, ob::State *state)
    {
        if (std::isinf(bound))
        {
            chart_->sampleUniform(rng_, state);
            return true;
        }
        for (unsigned int k = 0; k < TRIES; ++k)
        {
            if (!direct_)
                chart_->sampleUniform(rng_, state);
            else if (samplePositions(start, goal, bound, state))
                chart_->sampleRotations(rng_, state);
            else
                continue;
            if (bounds_.canBeat(start, state, goal, bound))
                return true;
        }
        return false;
    }
}  // namespace ompl_mfa
