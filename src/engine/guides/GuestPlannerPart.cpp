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

#include "engine/guides/GuestPlannerPart.h"

#include <algorithm>
#include <utility>

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Exception.h>

#include "engine/GoalDistance.h"
#include "path/CountingValidityChecker.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        /* Until there is a path, a turn lasts at least as long as all turns so far divided by this: a planner that
           restarts in each turn then still finishes, in a few times the work that it needs. */
        constexpr std::uint64_t FRUITLESS = 4;

        using Count = std::shared_ptr<std::atomic<std::uint64_t>>;

        class CountingValidator : public ob::MotionValidator
        {
        public:
            CountingValidator(const ob::SpaceInformationPtr &si, Count count)
              : MotionValidator(si)
              , user_(si)
              , count_(std::move(count))
            {
            }

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                const bool valid = user_->getMotionValidator()->checkMotion(from, to);
                *count_ += path::PathEvaluator::motionWork(*user_, {from, to}, valid);
                return valid;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> &lastValid) const override
            {
                const bool valid = user_->getMotionValidator()->checkMotion(from, to, lastValid);
                *count_ += path::PathEvaluator::motionWork(*user_, {from, to}, valid);
                return valid;
            }

        private:
            ob::SpaceInformationPtr user_;
            Count count_;
        };

        /* The user's space information for a planner whose work is counted. */
        class CountedSpaceInformation : public ob::SpaceInformation
        {
        public:
            CountedSpaceInformation(const ob::SpaceInformationPtr &user, const Count &count)
              : SpaceInformation(user->getStateSpace())
              , count_(count)
            {
                setStateValidityChecker(
                    std::make_shared<path::CountingValidityChecker>(user, user->getStateValidityChecker(), *count_));
                setMotionValidator(std::make_shared<CountingValidator>(user, count));
                setValidStateSamplerAllocator([user](const ob::SpaceInformation *)
                                              { return user->allocValidStateSampler(); });
                // the user's space information is set up already, and the space may be in use by other threads
                setup_ = true;
            }

        private:
            Count count_;
        };

        /* The known goal states, which any planner can sample; other states satisfy it if they satisfy the user's
           goal. */
        class KnownGoals : public ob::GoalStates
        {
        public:
            KnownGoals(const ob::SpaceInformationPtr &si, ob::GoalPtr goal)
              : GoalStates(si)
              , goal_(std::move(goal))
              , guard_(si->getStateSpace())
            {
                if (goal_->hasType(ob::GOAL_REGION))
                {
                    setThreshold(goal_->as<ob::GoalRegion>()->getThreshold());
                }
            }

            double distanceGoal(const ob::State *state) const override
            {
                double distance = 0.0;
                isSatisfied(state, &distance);
                return distance;
            }

            bool isSatisfied(const ob::State *state) const override
            {
                return isSatisfied(state, nullptr);
            }

            bool isSatisfied(const ob::State *state, double *distance) const override
            {
                return ompl_mfa::engine::isSatisfied(*goal_, guard_, state, distance);
            }

        private:
            ob::GoalPtr goal_;
            path::DubinsGuard guard_;
        };
    }  // namespace

    GuestPlannerPart::GuestPlannerPart(const SearchContext &context, const ob::PlannerAllocator &allocator)
      : GuidePart(PartKind::GuestPlanner, context)
      , evaluator_(context.evaluator())
      , checked_(std::make_shared<std::atomic<std::uint64_t>>(0))
      , si_(std::make_shared<CountedSpaceInformation>(evaluator_.spaceInformation(), checked_))
      , goals_(std::make_shared<KnownGoals>(si_, context.query.goal()))
      , pdef_(std::make_shared<ob::ProblemDefinition>(si_))
      , planner_(allocator(si_))
    {
        if (!planner_)
        {
            throw ompl::Exception("MFA", "the allocator of the guide planner returned no planner");
        }
        pdef_->setGoal(goals_);
        pdef_->setOptimizationObjective(evaluator_.objective());
        planner_->setProblemDefinition(pdef_);
    }

    Share GuestPlannerPart::firstShare() const
    {
        return {0.30, 0.30};
    }

    Share GuestPlannerPart::improvementShare(double /*seconds*/) const
    {
        return {0.20, 0.20};
    }

    Readiness GuestPlannerPart::readiness() const
    {
        const Query &query = context().query;
        const bool accepted = query.starts().size() > refusedStarts_ || query.goals().size() > refusedGoals_;
        return context().hasEnds() && accepted ? Readiness::Ready : Readiness::Idle;
    }

    void GuestPlannerPart::addEnds()
    {
        const Query &query = context().query;
        for (std::size_t i = pdef_->getStartStateCount(); i < query.starts().size(); ++i)
        {
            pdef_->addStartState(query.starts()[i]);
        }
        for (std::size_t i = goals_->getStateCount(); i < query.goals().size(); ++i)
        {
            goals_->addState(query.goals()[i]);
        }
    }

    ob::PlannerStatus GuestPlannerPart::run(std::uint64_t work)
    {
        *checked_ = 0;
        std::atomic<std::uint64_t> asked{0};
        const ob::PlannerTerminationCondition turnOver(
            [&]
            {
                if (++asked + *checked_ >= work)
                {
                    return true;
                }
                // planners with several threads evaluate it in all of them
                const std::lock_guard<std::mutex> lock(stopMutex_);
                return evaluator_.stopped();
            });
        if (!planner_->isSetup())
        {
            planner_->setup();
        }
        const ob::PlannerStatus status = planner_->solve(turnOver);
        const std::uint64_t done = asked + *checked_;
        evaluator_.addWork(asked);
        evaluator_.addChecks(*checked_);
        fruitless_ += done;
        returnedEarly_ = done < work && !evaluator_.stopped();
        return status;
    }

    void GuestPlannerPart::restart()
    {
        planner_->clear();
        pdef_->clearSolutionPaths();
        fresh_ = true;
        taken_.reset();
    }

    bool GuestPlannerPart::search(double /*bound*/, std::uint64_t work, path::Waypoints &path)
    {
        if (readiness() == Readiness::Idle)
        {
            return false;
        }
        addEnds();
        const bool fresh = std::exchange(fresh_, false);
        const ob::PlannerStatus status = run(pdef_->hasExactSolution() ? work : std::max(work, fruitless_ / FRUITLESS));
        const bool found = takePath(path);
        if (found)
        {
            fruitless_ = 0;
        }
        if (!returnedEarly_)
        {
            return found;
        }
        const bool searched = status == ob::PlannerStatus::TIMEOUT ||
                              status == ob::PlannerStatus::APPROXIMATE_SOLUTION ||
                              status == ob::PlannerStatus::EXACT_SOLUTION;
        // a planner that already had a turn may only be unable to continue
        if (!searched && fresh)
        {
            refusedStarts_ = context().query.starts().size();
            refusedGoals_ = context().query.goals().size();
        }
        restart();
        return found;
    }

    bool GuestPlannerPart::takePath(path::Waypoints &path)
    {
        if (!pdef_->hasExactSolution())
        {
            return false;
        }
        const auto found = std::dynamic_pointer_cast<og::PathGeometric>(pdef_->getSolutionPath());
        if (!found || found->getStateCount() < 2)
        {
            return false;
        }
        path.clear();
        for (const ob::State *state : found->getStates())
        {
            path.append(state);
        }
        const ob::Cost cost = evaluator_.cost(path);
        if ((taken_ && !evaluator_.objective()->isCostBetterThan(cost, *taken_)) || !holds(path))
        {
            return false;
        }
        taken_ = cost;
        return true;
    }

    bool GuestPlannerPart::holds(const path::Waypoints &path)
    {
        const Query &query = context().query;
        const auto &space = evaluator_.spaceInformation()->getStateSpace();
        bool begins = false;
        for (std::size_t i = 0; i < query.starts().size(); ++i)
        {
            begins = begins || space->equalStates(path.front(), query.starts()[i]);
        }
        if (!begins || !goals_->isSatisfied(path.back()))
        {
            return false;
        }
        for (std::size_t i = 0; i < path.size(); ++i)
        {
            if (!space->satisfiesBounds(path[i]))
            {
                return false;
            }
        }
        return evaluator_.checkPath(path);
    }
}  // namespace ompl_mfa::engine::guides
