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

#include "planner/SolutionPublisher.h"

#include <algorithm>

#include <ompl/geometric/PathGeometric.h>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    void SolutionPublisher::begin(const ob::ProblemDefinitionPtr &pdef)
    {
        pdef_ = pdef;
        const auto solutions = pdef->getSolutions();
        const bool has =
            std::any_of(solutions.begin(), solutions.end(),
                        [this](const ob::PlannerSolution &solution) { return solution.path_ == published_; });
        if (has)
        {
            return;
        }
        published_.reset();
        schedule_.reset();
    }

    bool SolutionPublisher::isPublished(const engine::SearchContext &context) const
    {
        return published_ && improvement_ == context.answer.improvements();
    }

    void SolutionPublisher::publishIfDue(const engine::SearchContext &context, const ob::Planner &planner,
                                         SearchLock &lock)
    {
        if (context.answer.hasPath() && !isPublished(context) &&
            schedule_.due(context.answer.cost(), context.evaluator().work()))
        {
            publish(context, planner, lock);
        }
    }

    void SolutionPublisher::publish(const engine::SearchContext &context, const ob::Planner &planner, SearchLock &lock)
    {
        const engine::Incumbent &answer = context.answer;
        const ob::Cost cost(answer.cost());
        auto path = std::make_shared<og::PathGeometric>(context.spaceInformation());
        answer.path().appendTo(*path);
        ob::PlannerSolution solution(path);
        solution.setPlannerName(planner.getName());
        solution.setOptimized(context.evaluator().objective(), cost, context.objective().isSatisfied(cost));
        pdef_->addSolutionPath(solution);
        schedule_.published(cost.value(), context.evaluator().work());
        published_ = path;
        improvement_ = answer.improvements();
        const auto callback = pdef_->getIntermediateSolutionCallback();
        if (!callback)
        {
            return;
        }
        // the callback may wait for a thread that calls getPlannerData
        const SearchLock::Release release(lock);
        callback(&planner, answer.path().pointers(), cost);
    }

    ob::PlannerStatus SolutionPublisher::finish(const engine::SearchContext &context, const ob::Planner &planner,
                                                SearchLock &lock)
    {
        const engine::Incumbent &incumbent = context.incumbent;
        if (context.answer.hasPath())
        {
            if (!isPublished(context))
            {
                publish(context, planner, lock);
            }
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (incumbent.partialPath().size() < 2)
        {
            return ob::PlannerStatus::TIMEOUT;
        }
        auto path = std::make_shared<og::PathGeometric>(context.spaceInformation());
        incumbent.partialPath().appendTo(*path);
        ob::PlannerSolution solution(path);
        solution.setPlannerName(planner.getName());
        solution.setApproximate(incumbent.partialDistance());
        pdef_->addSolutionPath(solution);
        return ob::PlannerStatus::APPROXIMATE_SOLUTION;
    }
}  // namespace ompl_mfa::planner
