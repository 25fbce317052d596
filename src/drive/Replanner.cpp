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

#include "drive/Replanner.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathSimplifier.h>

#include "drive/Clock.h"
#include "ompl_mfa/planner/MFA.h"

namespace ompl_mfa::drive
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;
    }  // namespace

    Replanner::Replanner(const benchmark::ProblemFactory &factory, const benchmark::PlannerSpec &spec)
      : setup_(factory.create(spec))
    {
        setup_->setup();
    }

    const ob::State *Replanner::goal() const
    {
        return setup_->getGoal()->as<ob::GoalState>()->getState();
    }

    double Replanner::cost(const og::PathGeometric &path) const
    {
        const auto &objective = setup_->getOptimizationObjective();
        return objective ? path.cost(objective).value() : path.length();
    }

    void Replanner::prepare(const ob::State *start, bool worldChanged)
    {
        const ob::ScopedState<> place(setup_->getStateSpace(), start);
        const ob::ProblemDefinitionPtr &problem = setup_->getProblemDefinition();
        problem->clearSolutionPaths();
        problem->clearStartStates();
        problem->addStartState(place);
        if (isFirst_)
        {
            isFirst_ = false;
            return;
        }
        auto *mfa = dynamic_cast<MFA *>(setup_->getPlanner().get());
        if (mfa == nullptr)
        {
            setup_->getPlanner()->clear();
        }
        else if (worldChanged)
        {
            mfa->validityChanged();
        }
        else
        {
            mfa->clearQuery();
        }
    }

    Answer Replanner::plan(const ob::State *start, bool worldChanged, double seconds)
    {
        Answer answer;
        const Clock::time_point begin = Clock::now();
        const ob::ProblemDefinitionPtr &problem = setup_->getProblemDefinition();
        const ob::PlannerPtr &planner = setup_->getPlanner();
        const auto notice = [&answer, begin]
        {
            if (std::isinf(answer.firstTime))
            {
                answer.firstTime = secondsSince(begin);
            }
        };
        problem->setIntermediateSolutionCallback(
            [notice](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost) { notice(); });
        prepare(start, worldChanged);
        planner->solve(ob::timedPlannerTerminationCondition(seconds));
        problem->setIntermediateSolutionCallback({});
        if (!problem->hasExactSolution())
        {
            answer.firstTime = std::numeric_limits<double>::infinity();
            answer.time = secondsSince(begin);
            return answer;
        }
        notice();
        answer.path = *problem->getSolutionPath()->as<og::PathGeometric>();
        if (!planner->getSpecs().optimizingPaths)
        {
            og::PathSimplifier simplifier(setup_->getSpaceInformation(), problem->getGoal(),
                                          setup_->getOptimizationObjective());
            og::PathGeometric simpler = *answer.path;
            simplifier.simplify(simpler, std::max(0.0, seconds - secondsSince(begin)));
            if (simpler.check())
            {
                answer.path = simpler;
            }
        }
        answer.time = secondsSince(begin);
        return answer;
    }

    std::vector<og::PathGeometric> Replanner::swarm(std::size_t most) const
    {
        const auto *mfa = dynamic_cast<const MFA *>(setup_->getPlanner().get());
        std::vector<og::PathGeometric> paths = mfa != nullptr ? mfa->getSwarmPaths() : std::vector<og::PathGeometric>();
        if (paths.size() > most)
        {
            paths.erase(paths.begin() + static_cast<std::ptrdiff_t>(most), paths.end());
        }
        return paths;
    }
}  // namespace ompl_mfa::drive
