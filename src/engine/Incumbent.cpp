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

#include "engine/Incumbent.h"

#include <utility>

#include "path/CostBounds.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    Incumbent::Incumbent(ob::OptimizationObjectivePtr objective, const ob::StateSpacePtr &space,
                         std::atomic<double> &cost)
      : objective_(std::move(objective))
      , path_(space)
      , partial_(space)
      , cost_(cost)
    {
        cost_.store(std::numeric_limits<double>::infinity(), std::memory_order_relaxed);
    }

    bool Incumbent::hasFinitePath() const
    {
        return hasPath() && objective_->isFinite(ob::Cost(cost()));
    }

    double Incumbent::bound() const
    {
        return !hasPath() || hasFinitePath() ? cost() : path::worstFiniteCost(*objective_);
    }

    bool Incumbent::improvedBy(double cost) const
    {
        return path_.empty() || objective_->isCostBetterThan(ob::Cost(cost), ob::Cost(this->cost()));
    }

    bool Incumbent::offer(const path::Waypoints &path, double cost, std::optional<PartKind> origin)
    {
        if (!improvedBy(cost))
        {
            return false;
        }
        path_ = path;
        cost_.store(cost, std::memory_order_relaxed);
        ++improvements_;
        origin_ = origin;
        return true;
    }

    bool Incumbent::offerPartial(const path::Waypoints &path, std::size_t count, const ob::State *last, double distance)
    {
        if (!(distance < partialDistance_))
        {
            return false;
        }
        partial_.clear();
        for (std::size_t i = 0; i < count; ++i)
        {
            partial_.append(path[i]);
        }
        partial_.append(last);
        partialDistance_ = distance;
        return true;
    }
}  // namespace ompl_mfa::engine
