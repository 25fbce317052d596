/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#include "engine/guides/InformedSampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <typeinfo>
#include <utility>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

#include "path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        constexpr unsigned int TRIES = 20;

        /* Whether the space's distance is never less than the Euclidean distance of all its scaled positions together.
           True for OMPL's own spaces, unknown for types derived from them. */
        bool boundedByPositions(const ob::StateSpace &space)
        {
            if (path::isExactly<ob::RealVectorStateSpace, ob::SO2StateSpace, ob::SO3StateSpace>(space))
            {
                return true;
            }
            if (!path::isExactly<ob::CompoundStateSpace, ob::SE2StateSpace, ob::SE3StateSpace, ob::DubinsStateSpace,
                                 ob::ReedsSheppStateSpace>(space))
            {
                return false;
            }
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            const bool curved = path::isExactly<ob::DubinsStateSpace, ob::ReedsSheppStateSpace>(space);
            for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
            {
                const double weight = compound.getSubspaceWeight(i);
                if (weight <= 0.0 || (curved && weight > 1.0) || !boundedByPositions(*compound.getSubspace(i)))
                {
                    return false;
                }
            }
            return true;
        }

        /* Whether the user has set a sampler on the space or on a subspace. OMPL does not report it, but the allocated
           sampler is then of another type than the default one. */
        bool hasSamplerOfUser(const ob::StateSpace &space)
        {
            const ob::StateSamplerPtr set = space.allocStateSampler();
            const ob::StateSamplerPtr byDefault = space.allocDefaultStateSampler();
            if (set && byDefault)
            {
                const ob::StateSampler &a = *set;
                const ob::StateSampler &b = *byDefault;
                if (typeid(a) != typeid(b))
                {
                    return true;
                }
            }
            if (!space.isCompound())
            {
                return false;
            }
            const auto &parts = space.as<ob::CompoundStateSpace>()->getSubspaces();
            return std::any_of(parts.begin(), parts.end(), [](const auto &part) { return hasSamplerOfUser(*part); });
        }
    }  // namespace

    InformedSampler::InformedSampler(path::StateChartPtr chart, const path::CostBounds &bounds, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , bounds_(bounds)
      , rng_(seed)
      , users_(hasSamplerOfUser(*chart_->space()) ? chart_->space()->allocStateSampler() : nullptr)
      , direct_(chart_->positionDimension() > 1 && boundedByPositions(*chart_->space()) && bounds_.certain())
      , lowerBound_(std::numeric_limits<double>::quiet_NaN())
      , pairs_(bounds)
      , bound_(std::numeric_limits<double>::infinity())
      , focus1_(chart_->positionDimension())
      , focus2_(chart_->positionDimension())
      , values_(chart_->positionDimension())
      , hyperspheroids_(std::max<Eigen::Index>(2, chart_->positionDimension()))
    {
    }

    /* Ends that were excluded by one bound are included again under a worse one. */
    void InformedSampler::takeUpEnds(const path::Waypoints &starts, const path::Waypoints &goals, double bound)
    {
        pairs_.update(starts, goals);
        const bool falling =
            !std::isinf(bound_) && !bounds_.objective()->isCostBetterThan(ob::Cost(bound_), ob::Cost(bound));
        if (!falling || starts.size() < takenStarts_ || goals.size() < takenGoals_)
        {
            starts_.clear();
            goals_.clear();
            takenStarts_ = takenGoals_ = 0;
        }
        for (; takenStarts_ < starts.size(); ++takenStarts_)
        {
            starts_.push_back(static_cast<std::uint32_t>(takenStarts_));
        }
        for (; takenGoals_ < goals.size(); ++takenGoals_)
        {
            goals_.push_back(static_cast<std::uint32_t>(takenGoals_));
        }
        bound_ = bound;
    }

    /* Ends that cannot be on a better path are excluded when they are drawn. */
    bool InformedSampler::pickPair(double bound, std::uint32_t &start, std::uint32_t &goal)
    {
        const auto pick = [this](std::vector<std::uint32_t> &ends, const auto &canBeat, std::uint32_t &end)
        {
            while (!ends.empty())
            {
                const auto last = static_cast<int>(ends.size()) - 1;
                const auto k = static_cast<std::size_t>(last > 0 ? rng_.uniformInt(0, last) : 0);
                end = ends[k];
                if (canBeat(end))
                {
                    return true;
                }
                ends[k] = ends.back();
                ends.pop_back();
            }
            return false;
        };
        return pick(
                   starts_, [&](std::uint32_t i) { return pairs_.startCanBeat(i, bound); }, start) &&
               pick(
                   goals_, [&](std::uint32_t j) { return pairs_.goalCanBeat(j, bound); }, goal);
    }

    bool InformedSampler::samplePositions(const path::Waypoints &starts, std::uint32_t start,
                                          const path::Waypoints &goals, std::uint32_t goal, double bound,
                                          ob::State *state)
    {
        chart_->positions(starts[start], focus1_);
        chart_->positions(goals[goal], focus2_);
        const auto &hyperspheroid = hyperspheroids_.of(goal * starts.size() + start, focus1_, focus2_);
        if (bound <= hyperspheroid->getMinTransverseDiameter())
        {
            return false;
        }
        hyperspheroid->setTransverseDiameter(bound);
        for (unsigned int k = 0; k < TRIES; ++k)
        {
            rng_.uniformProlateHyperspheroid(hyperspheroid, values_.data());
            if (chart_->setPositions(values_, state))
            {
                return true;
            }
        }
        return false;
    }

    void InformedSampler::sampleByUser(ob::State *state)
    {
        users_->sampleUniform(state);
        chart_->space()->enforceBounds(state);
    }

    bool InformedSampler::sample(const path::Waypoints &starts, const path::Waypoints &goals, double bound,
                                 ob::State *state)
    {
        const bool byUser = users_ && usersTurn_;
        usersTurn_ = !usersTurn_;
        lowerBound_ = std::numeric_limits<double>::quiet_NaN();
        if (std::isinf(bound))
        {
            byUser ? sampleByUser(state) : chart_->sampleUniform(rng_, state);
            return true;
        }
        takeUpEnds(starts, goals, bound);
        for (unsigned int k = 0; k < TRIES; ++k)
        {
            std::uint32_t start = 0;
            std::uint32_t goal = 0;
            if (!pickPair(bound, start, goal))
            {
                return false;
            }
            if (byUser)
            {
                sampleByUser(state);
            }
            else if (!direct_)
            {
                chart_->sampleUniform(rng_, state);
            }
            else if (samplePositions(starts, start, goals, goal, bound, state))
            {
                chart_->sampleRotations(rng_, state);
            }
            else
            {
                continue;
            }
            lowerBound_ =
                bounds_.combine(bounds_.lowerBoundTo(starts[start], state), bounds_.lowerBoundFrom(state, goals[goal]));
            if (bounds_.canBeat(lowerBound_, bound))
            {
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::guides
