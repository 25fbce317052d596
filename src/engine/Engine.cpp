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

#include "engine/Engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>

#include "engine/GoalDistance.h"
#include "engine/TurnMeter.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Least and greatest budget of a turn, in units of PathEvaluator::work(). */
        constexpr std::uint64_t SHORTEST_TURN = 400;
        constexpr std::uint64_t LONGEST_TURN = 8000;

        /* Paths that are kept for swarms which have not begun; the last ones. */
        constexpr std::size_t MAX_FIRST_FIREFLIES = 20;

        /* Pause when no part is ready. */
        constexpr std::chrono::milliseconds IDLE(1);

        /* Sets the evaluator's stop condition for this search and resets it when the search ends, also by an
           exception. */
        class StopConditionScope
        {
        public:
            StopConditionScope(path::PathEvaluator &evaluator, const ob::PlannerTerminationCondition &ptc)
              : evaluator_(evaluator)
            {
                evaluator_.setStopCondition([&ptc] { return ptc(); });
            }

            ~StopConditionScope()
            {
                evaluator_.setStopCondition({});
            }

            StopConditionScope(const StopConditionScope &) = delete;
            StopConditionScope &operator=(const StopConditionScope &) = delete;

        private:
            path::PathEvaluator &evaluator_;
        };

        ob::OptimizationObjectivePtr objectiveOf(const ob::Planner &planner)
        {
            if (const auto &objective = planner.getProblemDefinition()->getOptimizationObjective())
            {
                return objective;
            }
            OMPL_INFORM("%s: No optimization objective specified. Defaulting to optimizing path length.",
                        planner.getName().c_str());
            return std::make_shared<ob::PathLengthOptimizationObjective>(planner.getSpaceInformation());
        }
    }  // namespace

    Engine::Engine(const ob::Planner &owner, const path::StateChartPtr &chart, const SearchSettings &settings,
                   std::uint64_t seed, const ob::PlannerAllocator &guest, SearchProgress &progress)
      : context_(owner, chart, objectiveOf(owner), settings, seed, progress)
      , bounds_(chart->bounds())
      , parts_(makeParts(context_, guest))
      , straightMotions_(context_, parts_.guided)
      , hints_(context_, parts_.mender.get(), parts_.refiner != nullptr)
      , proof_(context_)
      , answer_(makeAnswerMaker(context_))
    {
        context_.evaluator().setPartialPathEvent(
            [this](const path::Waypoints &path, std::size_t motion, const ob::State *lastValid)
            { offerPartial(path, motion, lastValid); });
        for (const auto &part : parts_.parts)
        {
            sharing_.add(part->firstShare());
        }
    }

    Engine::~Engine() = default;

    void Engine::inherit(Engine &predecessor, bool sameValidity)
    {
        SearchContext &earlier = predecessor.context_;
        // costs other than length may depend on the world, like validity
        const bool sameCosts =
            context_.query.hasObjectiveOf(earlier.query) && (sameValidity || context_.evaluator().bounds().certain());
        const Heritage heritage{context_.chart->space() == earlier.chart->space() && bounds_ == predecessor.bounds_,
                                sameValidity, sameCosts};
        for (const auto &part : parts_.parts)
        {
            for (const auto &other : predecessor.parts_.parts)
            {
                if (part->kind() == other->kind())
                {
                    part->inherit(*other, heritage);
                }
            }
        }
        if (earlier.incumbent.hasPath())
        {
            hints_.add(earlier.incumbent.path(), PathHints::Source::BestPath);
        }
        if (earlier.answer.hasPath() && !earlier.answer.path().equals(earlier.incumbent.path()))
        {
            hints_.add(earlier.answer.path(), PathHints::Source::BestPath);
        }
        for (std::size_t i = 0; i < earlier.pool.size(); ++i)
        {
            if (earlier.pool[i].cost != earlier.incumbent.cost())
            {
                hints_.add(earlier.pool[i].path, PathHints::Source::Population);
            }
        }
        for (std::size_t i = 0; i < predecessor.hints_.size(); ++i)
        {
            hints_.add(predecessor.hints_.path(i), predecessor.hints_.source(i));
        }
        context_.firstFireflies = earlier.firstFireflies;
    }

    void Engine::addHint(path::Waypoints path)
    {
        std::vector<path::Waypoints> &fireflies = context_.firstFireflies;
        if (fireflies.size() >= MAX_FIRST_FIREFLIES)
        {
            fireflies.erase(fireflies.begin());
        }
        fireflies.push_back(path);
        if (parts_.mender)
        {
            hints_.add(std::move(path), PathHints::Source::User);
        }
    }

    bool Engine::canContinue(const ob::ProblemDefinition &pdef, const ob::PlannerTerminationCondition &ptc)
    {
        return context_.chart->bounds() == bounds_ && !context_.query.differsFrom(pdef) && pathHolds(ptc);
    }

    bool Engine::pathHolds(const ob::PlannerTerminationCondition &ptc)
    {
        Incumbent &incumbent = context_.incumbent;
        const bool exact = incumbent.hasPath();
        const path::Waypoints &path = exact ? incumbent.path() : incumbent.partialPath();
        if (path.empty())
        {
            return true;
        }
        if (exact && !context_.query.isAnsweredBy(path))
        {
            return false;
        }
        if (!exact)
        {
            double distance = 0.0;
            isSatisfied(*context_.query.goal(), context_.chart->guard(), path.back(), &distance);
            incumbent.setPartialDistance(distance);
        }
        path::PathEvaluator &evaluator = context_.evaluator();
        const StopConditionScope stopCondition(evaluator, ptc);
        const path::Waypoints &answer = context_.answer.path();
        const bool valid =
            evaluator.stopped() || (holds(path) && (answer.equals(path) || holds(answer))) || evaluator.interrupted();
        if (!valid)
        {
            OMPL_INFORM("%s: The path of an earlier solve() is not valid any more; the search restarts",
                        context_.owner.getName().c_str());
        }
        return valid;
    }

    bool Engine::holds(const path::Waypoints &path)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        return path.empty() || (evaluator.checkState(path.front()) && evaluator.checkPath(path));
    }

    ob::PlannerStatus::StatusType Engine::search(ob::PlannerInputStates &inputs,
                                                 const ob::PlannerTerminationCondition &ptc,
                                                 const std::function<void()> &mayPublish)
    {
        const StopConditionScope stopCondition(context_.evaluator(), ptc);
        const auto status = context_.query.begin(inputs, ptc, context_.spaceInformation());
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
        {
            return status;
        }
        mayPublish_ = mayPublish;
        mayPublish_();
        while (!finished(ptc))
        {
            iterate(inputs, ptc);
        }
        answer_->giveUp();
        return status;
    }

    bool Engine::finished(const ob::PlannerTerminationCondition &ptc)
    {
        if (ptc())
        {
            return true;
        }
        if (!context_.incumbent.hasPath())
        {
            return false;
        }
        const bool satisfied = meetsThreshold(context_.incumbent);
        if (!satisfied && !proof_.holds())
        {
            return false;
        }
        // only a path that is returned ends the search
        answer_->update(true);
        mayPublish_();
        if (meetsThreshold(context_.answer))
        {
            return true;
        }
        // nothing is better than the incumbent, so the search cannot improve the answer either
        return !satisfied || proof_.holds();
    }

    bool Engine::meetsThreshold(const Incumbent &path) const
    {
        return path.hasPath() && context_.objective().isSatisfied(ob::Cost(path.cost()));
    }

    void Engine::updateAnswer()
    {
        answer_->update(meetsThreshold(context_.incumbent));
        mayPublish_();
        const Incumbent &answer = context_.answer;
        if (answer.hasPath() && context_.incumbent.improvedBy(answer.cost()))
        {
            // tightened at the finer resolution
            offer({answer.path(), ob::Cost(answer.cost()), Proposal::Stage::Raw, answer.origin(), false});
        }
    }

    void Engine::iterate(ob::PlannerInputStates &inputs, const ob::PlannerTerminationCondition &ptc)
    {
        context_.query.poll(inputs);
        tryStraightMotions();
        considerPending();
        tryHints();
        updatePhase();
        std::vector<Readiness> readiness;
        for (const auto &part : parts_.parts)
        {
            readiness.push_back(part->readiness());
        }
        const auto next = sharing_.next(readiness);
        if (!next)
        {
            answer_->giveUp();
            mayPublish_();
            std::this_thread::sleep_for(IDLE);  // until starts or goals arrive
        }
        if (!next || finished(ptc))
        {
            return;
        }
        takeTurn(*next);
        updateAnswer();
    }

    void Engine::tryStraightMotions()
    {
        for (bool found = true; found;)
        {
            Findings findings(context_.chart->space());
            straightMotions_.advance(findings);
            found = !findings.paths.empty();
            consider(findings);
        }
    }

    void Engine::tryHints()
    {
        Findings findings(context_.chart->space());
        hints_.advance(findings);
        consider(findings);
    }

    void Engine::considerPending()
    {
        for (Proposal &proposal : std::exchange(pending_, {}))
        {
            consider(std::move(proposal));
        }
    }

    void Engine::takeTurn(std::size_t number)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        SearchPart &part = *parts_.parts[number];
        const SearchSettings &settings = context_.settings;
        const TurnMeter meter(evaluator, settings.seed != 0 ? 1e-6 * settings.stateCheckTime : 0.0);
        turn_ = number;
        gains_.assign(parts_.parts.size(), 0.0);
        Findings findings(context_.chart->space());
        // turns grow with the work done so far, so that the overhead of starting a turn stays small
        part.advance(std::clamp(evaluator.work() / 20, SHORTEST_TURN, LONGEST_TURN), findings);
        // the part that found a path pays for its tightening
        consider(findings);
        const double spent = meter.spent();
        context_.progress.addTime(part.kind(), spent);
        sharing_.record(number, spent, gains_);
        updatePhase();
    }

    void Engine::consider(Findings &findings)
    {
        for (std::size_t i = 0; i < findings.goals.size(); ++i)
        {
            context_.query.addGoal(findings.goals[i]);
        }
        for (const Proposal &draft : findings.drafts)
        {
            context_.pool.add(draft.path, draft.cost->value(), false, context_.incumbent.cost());
        }
        for (Proposal &proposal : findings.paths)
        {
            consider(std::move(proposal));
        }
    }

    /* A raw path is far from the best of its homotopy class, so it is tightened before it is compared. */
    void Engine::consider(Proposal proposal)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        Incumbent &incumbent = context_.incumbent;
        if (!proposal.cost)
        {
            proposal.cost = evaluator.cost(proposal.path);
            if (evaluator.interrupted())
            {
                proposal.cost.reset();
                pending_.push_back(std::move(proposal));
                return;
            }
            ++context_.progress.evaluations;
        }
        if (!proposal.draft)
        {
            offer(proposal);
        }
        if (meetsThreshold(context_.answer))
        {
            return;
        }
        if (parts_.refiner == nullptr || (proposal.stage != Proposal::Stage::Raw && !proposal.draft))
        {
            return;
        }
        proposal = parts_.refiner->refine(std::move(proposal), ob::Cost(incumbent.bound()));
        if (!proposal.draft)
        {
            offer(proposal);
        }
        updateAnswer();
        context_.pool.add(proposal.path, proposal.cost->value(), !proposal.draft, incumbent.cost());
    }

    bool Engine::offer(const Proposal &proposal)
    {
        Incumbent &incumbent = context_.incumbent;
        const bool first = !incumbent.hasPath();
        const double before = incumbent.cost();
        if (!incumbent.offer(proposal.path, proposal.cost->value(), proposal.origin))
        {
            return false;
        }
        if (first)
        {
            context_.evaluator().setPartialPathEvent({});
        }
        for (const auto &part : parts_.parts)
        {
            part->improved(proposal);
        }
        context_.pool.prune(incumbent.cost());
        context_.pool.add(incumbent.path(), incumbent.cost(), true, incumbent.cost());
        if (improving_)
        {
            credit(proposal.origin,
                   std::min(1.0, std::abs(before - incumbent.cost()) / std::max(std::abs(before), 1e-12)));
        }
        // a path that is to be tightened is published as it is only if it is the first
        if (first || meetsThreshold(incumbent) || !answer_->isActive())
        {
            updateAnswer();
        }
        return true;
    }

    /* Credits both the part whose turn it is and the part that found the path which was improved. */
    void Engine::credit(std::optional<PartKind> origin, double gain)
    {
        for (std::size_t i = 0; i < gains_.size(); ++i)
        {
            if (i == turn_ || origin == parts_.parts[i]->kind())
            {
                gains_[i] += gain;
            }
        }
    }

    /* Once there is a path of finite cost, whatever found it, the parts use their improvement shares. */
    void Engine::updatePhase()
    {
        if (improving_ || !context_.incumbent.hasFinitePath())
        {
            return;
        }
        improving_ = true;
        const double soFar = context_.progress.time();
        sharing_ = TurnSharing();
        for (const auto &part : parts_.parts)
        {
            sharing_.add(part->improvementShare(soFar));
        }
    }

    /* The segment of the motion up to the last valid state is discretised by itself and may not be valid. */
    void Engine::offerPartial(const path::Waypoints &path, std::size_t motion, const ob::State *lastValid)
    {
        double distance = 0.0;
        isSatisfied(*context_.query.goal(), context_.chart->guard(), lastValid, &distance);
        if (distance < context_.incumbent.partialDistance() &&
            context_.evaluator().checkMotion(path[motion], lastValid))
        {
            context_.incumbent.offerPartial(path, motion + 1, lastValid, distance);
        }
    }

    void Engine::explain(SearchGraph &graph) const
    {
        for (const auto &part : parts_.parts)
        {
            part->explain(graph);
        }
        if (context_.incumbent.hasPath())
        {
            graph.addPath(context_.incumbent.path());
        }
        if (context_.answer.hasPath())
        {
            graph.addPath(context_.answer.path());
        }
    }
}  // namespace ompl_mfa::engine
