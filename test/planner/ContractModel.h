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

#ifndef OMPL_MFA_TEST_PLANNER_CONTRACT_MODEL_
#define OMPL_MFA_TEST_PLANNER_CONTRACT_MODEL_

/* A simple model of what docs/planner.md promises: statuses, paths, parameters and what is known of a query. */

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "planner/PlanningProblem.h"

namespace ompl_mfa::planner
{
    namespace ob = ompl::base;

    using Point = std::array<double, 2>;

    enum class Call
    {
        SetByText,
        SetByText2,
        SetBySetter,
        SetGuidePlanner,
        SameQueryElsewhere,
        NewProblemDefinition,
        NoProblemDefinition,
        AddStart,
        ReplaceStarts,
        NewGoal,
        ChangeGoal,
        ChangeGoal2,
        AddGoal,
        NewObjective,
        ChangeThreshold,
        ChangeWorld,
        Clear,
        ClearQuery,
        ValidityChanged,
        AddHint,
        Setup,
        GetPlannerData,
        Solve,
        Solve2,
        Solve3,
        Solve4,
        Solve5,
        Count
    };

    struct Command
    {
        Call call{};
        unsigned int a{0};
        unsigned int b{0};
    };

    std::ostream &operator<<(std::ostream &out, const Command &command);

    using Parameters = std::map<std::string, std::string>;

    /* The planner, its problem and the model's knowledge of both. */
    class Model
    {
    public:
        Model()
        {
            std::map<std::string, std::string> defaults;
            planner_.params().getParams(defaults);
            set_ = defaults;
            set("population_size", "9");
            set("slices", "5");
            newGoal(0, 4);
            problem_.pdef->setGoal(goal_);
            planner_.setProblemDefinition(problem_.pdef);
        }

        void run(const Command &command);

    private:
        enum class Kind
        {
            State,
            States,
            Lazy,
            Region,
            Patch
        };

        ob::ScopedState<> state(const Point &point) const
        {
            return problem_.state({point[0], point[1]});
        }

        bool isValid(const ob::State *state) const
        {
            return problem_.si->isValid(state);
        }

        void set(const std::string &name, const std::string &value);
        void setBySetter(const Command &command);
        void setByText(const Command &command);
        void newGoal(unsigned int a, unsigned int b);
        void changeGoal(unsigned int a, unsigned int b);
        void addGoal(const Point &point);
        void addHint(unsigned int a, unsigned int b);
        void newProblemDefinition(bool same, unsigned int a, unsigned int b);
        void change(const Command &command);
        void solve(unsigned int evaluations);
        bool expectRefusal(const ob::PlannerStatus &status, std::size_t evaluations) const;
        void expectAnswer(const ob::PlannerStatus &status);
        void expectShares();
        void expectPlannerData() const;
        bool isStart(const ob::State *state) const;
        bool isGoal(const ob::State *state) const;
        std::vector<const ob::State *> listedGoals() const;

        /* Whether a search that starts now has no part that finds paths. */
        bool nothingSearches() const
        {
            return set_.at("fireflies") == "0" && set_.at("guide") == "none" && !guidePlanner_;
        }

        /* The next solve() may have a new query or new settings. */
        void mayRestart()
        {
            kept_ = false;
            searched_ = false;
        }

        void restarts()
        {
            mayRestart();
            frozen_.clear();
        }

        double height_{6.0};
        test::PlanningProblem problem_{test::realVectorSpace(2, 0.0, 10.0),
                                       [this](const ob::State *s)
                                       {
                                           const double x = test::coordinate(s, 0);
                                           return x <= 4.5 || x >= 5.5 || test::coordinate(s, 1) >= height_;
                                       },
                                       {1.0, 1.0},
                                       {9.0, 1.0}};
        MFA planner_{problem_.si};
        Kind kind_{};
        ob::GoalPtr goal_;
        bool hasProblem_{true};
        bool guidePlanner_{false};

        struct Frozen
        {
            Parameters parameters;
            bool guidePlanner;
        };

        Parameters set_;              ///< as they were last set
        std::vector<Frozen> frozen_;  ///< the search has one of these
        bool kept_{false};            ///< nothing has happened that may make the next solve() restart
        bool searched_{false};        ///< the last relevant call was a solve() that searched
        bool solved_{false};          ///< whether it found a path
        double cost_{0.0};
        std::uint64_t evaluations_{0};
    };
}  // namespace ompl_mfa::planner

#endif
