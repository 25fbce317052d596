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

#include "engine/fireflies/GoalSearch.h"

#include <cmath>
#include <limits>
#include <utility>

#include "engine/Streams.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* The coordinate box around the origin that contains the whole space. */
        Eigen::VectorXd reachAlong(const path::StateChart &chart, const ob::State *origin, double sign)
        {
            Eigen::VectorXd reach(chart.dimension());
            for (Eigen::Index i = 0; i < chart.positionDimension(); ++i)
            {
                const double r = chart.reach(origin, sign * Eigen::VectorXd::Unit(chart.dimension(), i));
                reach[i] = sign * (std::isfinite(r) ? r : chart.space()->getMaximumExtent());
            }
            reach.tail(chart.rotationDimension()) = sign * chart.rotationReach();
            return reach;
        }

        FireflyOptimizer::Settings searchSettings()
        {
            FireflyOptimizer::Settings settings;
            settings.populationSize = 30;
            return settings;
        }
    }  // namespace

    GoalSearch::GoalSearch(const path::StateChartPtr &chart, const ob::SpaceInformationPtr &si, ob::GoalPtr goal,
                           const ob::State *origin, std::uint64_t seed)
      : chart_(chart)
      , si_(si)
      , goal_(std::move(goal))
      , origin_(chart->space())
      , satisfying_(chart->space())
      , state_(si->allocState())
      , seed_(seed)
      , fireflies_(searchSettings(), reachAlong(*chart, origin, -1.0), reachAlong(*chart, origin, 1.0),
                   streamSeed(seed, Stream::Epoch))
    {
        origin_.append(origin);
    }

    GoalSearch::~GoalSearch()
    {
        si_->freeState(state_);
    }

    Brightness GoalSearch::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/)
    {
        chart_->displace(origin_.front(), x, state_);
        double distance = 0.0;
        const bool satisfied = goal_->isSatisfied(state_, &distance);
        if (satisfied && si_->isValid(state_))
        {
            if (satisfying_.empty())
            {
                satisfying_.append(state_);
            }
            return {0.0, 0.0};
        }
        return {std::max(distance, std::numeric_limits<double>::min()), 0.0};
    }

    bool GoalSearch::advance(const FireflyOptimizer::StopCondition &stop, path::Waypoints &found)
    {
        satisfying_.clear();
        // a swarm that has converged away from the goal does not leave
        if (fireflies_.generation() >= fireflies_.settings().generations)
        {
            earlierEvaluations_ += fireflies_.evaluations();
            fireflies_ = FireflyOptimizer(fireflies_.settings(), fireflies_.lower(), fireflies_.upper(),
                                          streamSeed(seed_, Stream::Epoch, ++epoch_));
        }
        fireflies_.step(*this, [&] { return !satisfying_.empty() || stop(); });
        if (satisfying_.empty())
        {
            return false;
        }
        found.append(satisfying_.front());
        return true;
    }
}  // namespace ompl_mfa::engine::fireflies
