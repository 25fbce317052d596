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

#ifndef OMPL_MFA_TEST_PLANNER_PLANNING_PROBLEM_
#define OMPL_MFA_TEST_PLANNER_PLANNING_PROBLEM_

/* Small problems whose answers are known, and planners for them. */

#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/planner/MFA.h"
#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ompl_mfa::test
{
    inline double coordinate(const ompl::base::State *state, unsigned int i)
    {
        return state->as<ompl::base::RealVectorStateSpace::StateType>()->values[i];
    }

    /** \brief The planner under test: with its defaults, or the paper's algorithm alone. */
    enum class PlannerVariant
    {
        Default,
        Paper
    };

    struct VariantName
    {
        template <typename Info>
        std::string operator()(const Info &info) const
        {
            return info.param == PlannerVariant::Paper ? "Paper" : "Default";
        }
    };

    inline void set(MFA &planner, const std::string &parameter, const std::string &value)
    {
        if (!planner.params().setParam(parameter, value))
        {
            throw std::invalid_argument(parameter + " = " + value);
        }
    }

    /** \brief A planner with a swarm small enough for many runs. */
    inline std::shared_ptr<MFA> makePlanner(const ompl::base::SpaceInformationPtr &si, PlannerVariant variant,
                                            std::uint32_t seed = 7)
    {
        auto planner = std::make_shared<MFA>(si);
        set(*planner, "population_size", "20");
        set(*planner, "slices", "5");
        set(*planner, "generations", "20");
        set(*planner, "seed", std::to_string(seed));
        if (variant == PlannerVariant::Paper)
        {
            // exactly the paper's algorithm; a planner may lack some of these parameters
            if (planner->params().hasParam("guide"))
            {
                set(*planner, "guide", "none");
            }
            for (const char *part : {"recombination", "tightening"})
            {
                if (planner->params().hasParam(part))
                {
                    set(*planner, part, "0");
                }
            }
        }
        return planner;
    }

    /** \brief One start and one goal among obstacles, counting calls of the validity checker. */
    struct PlanningProblem
    {
        CountingProblem counted;
        ompl::base::SpaceInformationPtr si;
        ompl::base::ProblemDefinitionPtr pdef;

        PlanningProblem(const ompl::base::StateSpacePtr &space,
                        const std::function<bool(const ompl::base::State *)> &isValid, const std::vector<double> &start,
                        const std::vector<double> &goal)
          : counted(space, isValid)
          , si(counted.si)
          , pdef(std::make_shared<ompl::base::ProblemDefinition>(si))
        {
            pdef->setStartAndGoalStates(state(start), state(goal));
        }

        ompl::base::ScopedState<> state(const std::vector<double> &values) const
        {
            ompl::base::ScopedState<> result(si->getStateSpace());
            result = values;
            return result;
        }

        std::shared_ptr<MFA> planner(PlannerVariant variant, std::uint32_t seed = 7) const
        {
            auto result = makePlanner(si, variant, seed);
            result->setProblemDefinition(pdef);
            return result;
        }

        ompl::geometric::PathGeometric &path() const
        {
            return *pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
        }

        /** \brief The cost that the problem definition reports for its best solution. */
        double reportedCost() const
        {
            ompl::base::PlannerSolution solution(nullptr);
            pdef->getSolution(solution);
            return solution.cost_.value();
        }
    };

    /** \brief The square [0, 10]^2 with a wall 4.5 < x < 5.5 that leaves a gap above y = \e top.

        From (1, 1) to (9, 1) the shortest path goes over the corners of the wall. */
    inline std::unique_ptr<PlanningProblem> wallProblem(double top = 6.0)
    {
        return std::make_unique<PlanningProblem>(
            realVectorSpace(2, 0.0, 10.0),
            [top](const ompl::base::State *s)
            { return coordinate(s, 0) <= 4.5 || coordinate(s, 0) >= 5.5 || coordinate(s, 1) >= top; },
            std::vector<double>{1.0, 1.0}, std::vector<double>{9.0, 1.0});
    }

    /** \brief The length of the shortest path of wallProblem. */
    inline double wallOptimum(double top = 6.0)
    {
        return 2.0 * std::hypot(3.5, top - 1.0) + 1.0;
    }

    /** \brief The wall without a gap: the goal cannot be reached. */
    inline std::unique_ptr<PlanningProblem> closedProblem()
    {
        return wallProblem(11.0);
    }

    inline std::unique_ptr<PlanningProblem> freeProblem()
    {
        return wallProblem(-1.0);
    }

    /** \brief True from its \e n-th evaluation on. */
    inline ompl::base::PlannerTerminationCondition afterCalls(std::uint64_t n)
    {
        auto calls = std::make_shared<std::uint64_t>(0);
        return ompl::base::PlannerTerminationCondition([calls, n] { return ++*calls >= n; });
    }

    /** \brief True once \e pdef has an exact solution, or after a minute, when something is badly wrong. */
    inline ompl::base::PlannerTerminationCondition untilExact(const ompl::base::ProblemDefinitionPtr &pdef)
    {
        return ompl::base::plannerOrTerminationCondition(
            ompl::base::PlannerTerminationCondition([pdef] { return pdef->hasExactSolution(); }),
            ompl::base::timedPlannerTerminationCondition(60.0));
    }
}  // namespace ompl_mfa::test

#endif
