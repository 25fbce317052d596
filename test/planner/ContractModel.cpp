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

#include "planner/ContractModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>

#include "planner/DistanceGoal.h"
#include "planner/PatchGoal.h"
#include "planner/PlanningProblem.h"

namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        /* Points with 4.5 < x < 5.5 lie in a wall, if it is high enough. */
        const std::array<Point, 8> POINTS{{{1, 1}, {2, 2}, {1, 8}, {5, 1}, {9, 1}, {9, 9}, {3, 3}, {5, 5}}};

        /* Of the wall: none, two with a gap above it, and one that closes the way. */
        const std::array<double, 4> HEIGHTS{{-1.0, 3.0, 6.0, 11.0}};

        /* The values that a parameter accepts and rejects according to docs/planner.md. */
        struct Values
        {
            std::string name;
            std::vector<std::string> accepted;  ///< as they are read back
            std::vector<std::string> refused;
        };

        const std::vector<Values> &parameterValues()
        {
            static const std::vector<Values> VALUES{
                {"variant", {"mfa", "fa"}, {"", "MFA", "0"}},
                {"fireflies", {"0", "1"}, {"2", "off", ""}},
                {"firefly_moves", {"both", "equations", "detours"}, {"all", "", "EQUATIONS"}},
                {"population_size", {"0", "4", "9", "25"}, {"1", "2", "3", "10001", "-4"}},
                {"slices", {"1", "2", "7", "12"}, {"0", "1001", "x"}},
                {"generations", {"1", "3", "50", "100000"}, {"0", "100001", "1e3"}},
                {"gamma", {"0", "0.5", "100"}, {"100.5", "-1", "nan"}},
                {"alpha", {"0", "0.25", "1"}, {"1.01", "inf", "0,5"}},
                {"eta", {"0", "1", "2"}, {"2.5", "-0.1", ""}},
                {"guide", {"none", "trees", "roadmap", "both"}, {"all", "", "BOTH"}},
                {"recombination", {"0", "1"}, {"2", "no", ""}},
                {"tightening", {"0", "1"}, {"-1", "yes", "10"}},
                {"seed", {"0", "1", "7", "4294967295"}, {"-1", "4294967296", "1.5"}},
                {"strictness", {"1", "2", "8"}, {"0", "65", "x"}},
                {"threads", {"1", "2"}, {"0", "65", "two"}}};
            return VALUES;
        }

        /* The number of starts to add: none, now and then. */
        unsigned int startsOf(unsigned int a)
        {
            return a % 8 == 0 ? 0 : 1 + a % 3;
        }
    }  // namespace

    void Model::set(const std::string &name, const std::string &value)
    {
        RC_ASSERT(planner_.params().setParam(name, value));
        set_[name] = value;
    }

    void Model::setByText(const Command &command)
    {
        const Values &values = parameterValues()[command.a % parameterValues().size()];
        if (command.b % 4 != 0)
        {
            return set(values.name, values.accepted[command.b % values.accepted.size()]);
        }
        RC_ASSERT(!planner_.params().setParam(values.name, values.refused[command.b / 4 % values.refused.size()]));
    }

    void Model::setBySetter(const Command &command)
    {
        const std::vector<double> numbers{0, 1, 0.5, 2, 3, 4, 64, 65, 100, 100.5, 1001, 10001, 100001, -1};
        const double x = numbers[command.b % numbers.size()];
        const auto n = static_cast<unsigned int>(std::max(x, 0.0));
        const auto setting = [&](const std::string &name, bool accepted, const std::string &text, auto setter)
        {
            // large ones are only set as text: searching with them takes too long
            const bool large = n > 4 && (name == "population_size" || name == "slices" || name == "threads");
            if (accepted && large)
            {
                return;
            }
            bool thrown = false;
            try
            {
                setter();
            }
            catch (const ompl::Exception &)
            {
                thrown = true;
            }
            RC_ASSERT(thrown == !accepted);
            if (accepted)
            {
                set_[name] = text;
            }
        };
        std::ostringstream text;
        text << x;
        const std::string whole = std::to_string(n);
        const bool on = command.b % 2 == 0;
        const std::string guide = on ? "both" : "none";
        switch (command.a % 11)
        {
            case 0:
                return setting("population_size", n == 0 || (n >= 4 && n <= 10000), whole,
                               [&] { planner_.setPopulationSize(n); });
            case 1:
                return setting("slices", n >= 1 && n <= 1000, whole, [&] { planner_.setSlices(n); });
            case 2:
                return setting("generations", n >= 1 && n <= 100000, whole, [&] { planner_.setGenerations(n); });
            case 3:
                return setting("gamma", x >= 0 && x <= 100, text.str(), [&] { planner_.setGamma(x); });
            case 4:
                return setting("alpha", x >= 0 && x <= 1, text.str(), [&] { planner_.setAlpha(x); });
            case 5:
                return setting("eta", x >= 0 && x <= 2, text.str(), [&] { planner_.setEta(x); });
            case 6:
                return setting("guide", true, guide, [&] { planner_.setGuide(guide); });
            case 7:
                return setting("recombination", true, on ? "1" : "0", [&] { planner_.setRecombination(on); });
            case 8:
                return setting("tightening", true, on ? "1" : "0", [&] { planner_.setTightening(on); });
            case 9:
                return setting("fireflies", true, on ? "1" : "0", [&] { planner_.setFireflies(on); });
            default:
                return setting("threads", n >= 1 && n <= 64, whole, [&] { planner_.setThreads(n); });
        }
    }

    void Model::newGoal(unsigned int a, unsigned int b)
    {
        const Point &point = POINTS[b % POINTS.size()];
        kind_ = static_cast<Kind>(a % 5);
        switch (kind_)
        {
            case Kind::State:
            {
                const auto goal = std::make_shared<ob::GoalState>(problem_.si);
                goal->setState(state(point));
                goal_ = goal;
                break;
            }
            case Kind::States:
                goal_ = std::make_shared<ob::GoalStates>(problem_.si);
                addGoal(point);
                break;
            case Kind::Lazy:
                goal_ = std::make_shared<ob::GoalLazySamples>(
                    problem_.si, [](const ob::GoalLazySamples *, ob::State *) { return false; }, false);
                addGoal(point);
                break;
            case Kind::Region:
                goal_ = std::make_shared<test::DistanceGoal>(problem_.si, state(POINTS[4 + b % 3]).get(), 1.0);
                break;
            case Kind::Patch:
                // never in the wall: the planner would wait for valid samples
                goal_ =
                    std::make_shared<test::PatchGoal>(problem_.si, POINTS[4 + b % 3], 0.5, b % 2 == 0 ? 2 : 1000000);
                break;
        }
    }

    void Model::addGoal(const Point &point)
    {
        goal_->as<ob::GoalStates>()->addState(state(point).get());
    }

    /* A path through some of the points, which may be in the wall. */
    void Model::addHint(unsigned int a, unsigned int b)
    {
        og::PathGeometric path(problem_.si);
        for (unsigned int i = 0; i <= a % 5; ++i)
        {
            path.append(state(POINTS[(b + i * (1 + a / 5)) % POINTS.size()]).get());
        }
        planner_.addPathHint(path);
    }

    void Model::changeGoal(unsigned int a, unsigned int b)
    {
        const Point &point = POINTS[b % POINTS.size()];
        switch (kind_)
        {
            case Kind::State:
                goal_->as<ob::GoalState>()->setState(state(point));
                break;
            case Kind::States:
            case Kind::Lazy:
                goal_->as<ob::GoalStates>()->clear();
                for (unsigned int i = 0; i < a % 3; ++i)
                {
                    addGoal(POINTS[(b + i) % POINTS.size()]);
                }
                break;
            case Kind::Region:
                goal_->as<ob::GoalRegion>()->setThreshold(a % 2 == 0 ? 0.2 : 2.0);
                break;
            case Kind::Patch:
                if (a % 2 == 0)
                {
                    goal_->as<test::PatchGoal>()->side = b % 2 == 0 ? 0.1 : 0.9;
                }
                else
                {
                    goal_->as<test::PatchGoal>()->center = POINTS[4 + b % 3];
                }
                break;
        }
    }

    /* Another problem definition, with the same starts or others. */
    void Model::newProblemDefinition(bool same, unsigned int a, unsigned int b)
    {
        const auto next = std::make_shared<ob::ProblemDefinition>(problem_.si);
        for (unsigned int i = 0; same && i < problem_.pdef->getStartStateCount(); ++i)
        {
            next->addStartState(problem_.pdef->getStartState(i));
        }
        for (unsigned int i = 0; !same && i < startsOf(a); ++i)
        {
            next->addStartState(state(POINTS[(b + i) % 4]));
        }
        if (same || a % 8 != 7)
        {
            next->setGoal(goal_);
        }
        if (same)
        {
            next->setOptimizationObjective(problem_.pdef->getOptimizationObjective());
        }
        problem_.pdef = next;
        planner_.setProblemDefinition(next);
    }

    /* Changes that may concern the query or the world. */
    void Model::change(const Command &command)
    {
        mayRestart();
        switch (command.call)
        {
            case Call::NewProblemDefinition:
                return newProblemDefinition(false, command.a, command.b);
            case Call::ReplaceStarts:
                problem_.pdef->clearStartStates();
                for (unsigned int i = 0; i < startsOf(command.a); ++i)
                {
                    problem_.pdef->addStartState(state(POINTS[(command.b + i) % 4]));
                }
                return;
            case Call::NewGoal:
                restarts();
                newGoal(command.a, command.b);
                problem_.pdef->setGoal(goal_);
                return;
            case Call::NewObjective:
                problem_.pdef->setOptimizationObjective(
                    std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si));
                return;
            case Call::ChangeWorld:
                restarts();
                height_ = HEIGHTS[command.a % 4];
                return planner_.clear();
            case Call::Clear:
                restarts();
                return planner_.clear();
            case Call::ClearQuery:
                restarts();
                return planner_.clearQuery();
            case Call::ValidityChanged:
                restarts();
                height_ = HEIGHTS[command.a % 4];
                return planner_.validityChanged();
            default:
                return changeGoal(command.a, command.b);
        }
    }

    void Model::run(const Command &command)
    {
        switch (command.call)
        {
            case Call::SetByText:
            case Call::SetByText2:
                setByText(command);
                break;
            case Call::SetBySetter:
                setBySetter(command);
                break;
            case Call::SetGuidePlanner:
                guidePlanner_ = command.a % 2 == 0;
                planner_.setGuidePlanner(guidePlanner_ ? [](const ob::SpaceInformationPtr &si) -> ob::PlannerPtr
                                         { return std::make_shared<og::RRTConnect>(si); }
                                                       : ob::PlannerAllocator());
                break;
            case Call::SameQueryElsewhere:
                newProblemDefinition(true, command.a, command.b);
                break;
            case Call::NoProblemDefinition:
                hasProblem_ = false;
                planner_.setProblemDefinition(ob::ProblemDefinitionPtr());
                solve(command.b);
                hasProblem_ = true;
                planner_.setProblemDefinition(problem_.pdef);
                break;
            case Call::AddStart:
                problem_.pdef->addStartState(state(POINTS[command.a % 4]));
                searched_ = false;
                break;
            case Call::AddGoal:
                if (kind_ == Kind::States || kind_ == Kind::Lazy)
                {
                    addGoal(POINTS[command.a % POINTS.size()]);
                }
                searched_ = false;
                break;
            case Call::ChangeThreshold:
                if (const auto &objective = problem_.pdef->getOptimizationObjective())
                {
                    objective->setCostThreshold(ob::Cost(command.a % 2 == 0 ? 0.0 : 14.0));
                }
                break;
            case Call::AddHint:
                addHint(command.a, command.b);
                break;
            case Call::Setup:
                planner_.setup();
                break;
            case Call::GetPlannerData:
                expectPlannerData();
                break;
            case Call::Solve:
            case Call::Solve2:
            case Call::Solve3:
            case Call::Solve4:
            case Call::Solve5:
                solve(std::array<unsigned int, 5>{{1, 3, 40, 300, 1500}}[command.a % 5]);
                break;
            default:
                change(command);
        }
        std::map<std::string, std::string> now;
        planner_.params().getParams(now);
        RC_ASSERT(now == set_);
    }

    std::vector<const ob::State *> Model::listedGoals() const
    {
        std::vector<const ob::State *> states;
        if (kind_ == Kind::State)
        {
            states.push_back(goal_->as<ob::GoalState>()->getState());
        }
        if (kind_ == Kind::States || kind_ == Kind::Lazy)
        {
            for (unsigned int i = 0; i < goal_->as<ob::GoalStates>()->getStateCount(); ++i)
            {
                states.push_back(goal_->as<ob::GoalStates>()->getState(i));
            }
        }
        return states;
    }

    bool Model::isStart(const ob::State *state) const
    {
        for (unsigned int i = 0; i < problem_.pdef->getStartStateCount(); ++i)
        {
            if (problem_.si->equalStates(problem_.pdef->getStartState(i), state))
            {
                return true;
            }
        }
        return false;
    }

    bool Model::isGoal(const ob::State *state) const
    {
        return goal_->isSatisfied(state);
    }

    void Model::solve(unsigned int evaluations)
    {
        // whether the search is new, or may be new
        const bool begins = frozen_.empty();
        const bool mayBegin = begins || !kept_;
        const bool complete = hasProblem_ && problem_.pdef->getStartStateCount() > 0 && problem_.pdef->getGoal();
        problem_.pdef->clearSolutionPaths();
        ob::PlannerStatus status;
        bool thrown = false;
        try
        {
            status = planner_.solve(test::afterCalls(evaluations));
        }
        catch (const ompl::Exception &)
        {
            thrown = true;
        }
        if (complete && thrown)
        {
            RC_ASSERT(mayBegin && nothingSearches());
            restarts();
            return;
        }
        RC_ASSERT(thrown == !complete);
        if (thrown)
        {
            return;
        }
        RC_ASSERT(!begins || !nothingSearches());
        // if the query may have changed, the search may have the parameters of either
        if (mayBegin)
        {
            frozen_.push_back({set_, guidePlanner_});
        }
        if (expectRefusal(status, evaluations))
        {
            mayRestart();
            return;
        }
        expectAnswer(status);
        expectShares();
        kept_ = searched_ = true;
        expectPlannerData();
    }

    /* Whether there is nothing to plan; the status has to say why. */
    bool Model::expectRefusal(const ob::PlannerStatus &status, std::size_t evaluations) const
    {
        bool validStart = false;
        for (unsigned int i = 0; i < problem_.pdef->getStartStateCount(); ++i)
        {
            validStart = validStart || isValid(problem_.pdef->getStartState(i));
        }
        bool validGoal = kind_ == Kind::Region || kind_ == Kind::Patch;
        for (const ob::State *goal : listedGoals())
        {
            validGoal = validGoal || isValid(goal);
        }
        if (!validStart)
        {
            RC_ASSERT(status == ob::PlannerStatus::INVALID_START);
        }
        else if (!validGoal)
        {
            // a condition may leave no time to check all of them
            RC_ASSERT(status == ob::PlannerStatus::INVALID_GOAL ||
                      (status == ob::PlannerStatus::TIMEOUT && evaluations < listedGoals().size()));
        }
        return !validStart || !validGoal;
    }

    void Model::expectAnswer(const ob::PlannerStatus &status)
    {
        const auto &pdef = *problem_.pdef;
        const bool exact = status == ob::PlannerStatus::EXACT_SOLUTION;
        RC_ASSERT(pdef.hasExactSolution() == exact);
        if (kept_ && solved_)
        {
            RC_ASSERT(exact);
            RC_ASSERT(planner_.bestCost() <= cost_);
        }
        if (kept_)
        {
            RC_ASSERT(planner_.evaluations() >= evaluations_);
        }
        RC_ASSERT(exact == std::isfinite(planner_.bestCost()));
        solved_ = exact;
        cost_ = planner_.bestCost();
        evaluations_ = planner_.evaluations();
        if (!exact && status != ob::PlannerStatus::APPROXIMATE_SOLUTION)
        {
            RC_ASSERT(status == ob::PlannerStatus::TIMEOUT);
            RC_ASSERT(!pdef.hasSolution());
            return;
        }
        auto &path = problem_.path();
        const ob::State *end = path.getState(path.getStateCount() - 1);
        RC_ASSERT(path.check());
        RC_ASSERT(isStart(path.getState(0)));
        if (exact)
        {
            RC_ASSERT(isGoal(end));
            RC_ASSERT(std::abs(path.length() - cost_) <= 1e-9 * std::max(1.0, cost_));
            return;
        }
        double distance = 0.0;
        goal_->isSatisfied(end, &distance);
        RC_ASSERT(pdef.getSolutionDifference() == distance);
    }

    /* A part that was off when the query began has no share. */
    void Model::expectShares()
    {
        const std::map<std::string, double> shares = planner_.shares();
        const auto isWithout = [&](const Frozen &frozen)
        {
            const auto on = [&frozen](const std::string &name) { return frozen.parameters.at(name) == "1"; };
            const auto idle = [&shares](const std::string &part) { return shares.at(part) == 0.0; };
            const std::string &guide = frozen.parameters.at("guide");
            return (on("fireflies") || (idle("fireflies") && idle("recombination"))) &&
                   (on("recombination") || idle("recombination")) && (on("tightening") || idle("tightening")) &&
                   (guide == "both" || guide == "trees" || idle("trees")) &&
                   (guide == "both" || guide == "roadmap" || idle("roadmap")) &&
                   (frozen.guidePlanner || idle("guide planner"));
        };
        RC_ASSERT(std::any_of(frozen_.begin(), frozen_.end(), isWithout));
    }

    /* Starts and goals are those of the query, each once. */
    void Model::expectPlannerData() const
    {
        ob::PlannerData data(problem_.si);
        planner_.getPlannerData(data);
        if (!searched_ || !hasProblem_)
        {
            return;
        }
        for (unsigned int i = 0; i < data.numStartVertices(); ++i)
        {
            const ob::State *start = data.getStartVertex(i).getState();
            RC_ASSERT(isStart(start));
            for (unsigned int k = 0; k < i; ++k)
            {
                RC_ASSERT(!problem_.si->equalStates(data.getStartVertex(k).getState(), start));
            }
        }
        for (unsigned int i = 0; i < data.numGoalVertices(); ++i)
        {
            const ob::State *goal = data.getGoalVertex(i).getState();
            RC_ASSERT(isGoal(goal));
            for (unsigned int k = 0; k < i; ++k)
            {
                RC_ASSERT(!problem_.si->equalStates(data.getGoalVertex(k).getState(), goal));
            }
        }
    }
}  // namespace ompl_mfa::planner
