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

#include "ompl_mfa/benchmark/PlannerFactory.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"
#include "benchmark/ProblemSpace.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;
        using test::inputErrorOf;

        template <typename Space>
        ob::SpaceInformationPtr inSpace(const std::shared_ptr<Space> &space)
        {
            auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            return si;
        }

        ob::SpaceInformationPtr square()
        {
            ProblemConfig problem;
            problem.space = StateSpaceKind::R2;
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(10.0);
            return inSpace(makeStateSpace(problem, bounds));
        }

        template <typename Space>
        ob::SpaceInformationPtr carSpace()
        {
            auto space = std::make_shared<Space>(0.5);
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(1.0);
            space->setBounds(bounds);
            return inSpace(space);
        }

        PlannerSpec spec(const std::string &type, std::vector<ConfigEntry> parameters = {})
        {
            return {type, "", "a.cfg:9", std::move(parameters), {}};
        }

        std::string errorOf(const std::string &type, const std::string &key, const std::string &value)
        {
            return inputErrorOf([&] { createPlanner(square(), spec(type, {{key, value, "a.cfg:10"}})); });
        }

        TEST(PlannerFactory, MakesEveryPlannerItNames)
        {
            const auto names = plannerNames();
            EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
            const auto si = square();
            for (const auto &name : names)
            {
                const ob::PlannerPtr planner = createPlanner(si, spec(name));
                ASSERT_TRUE(planner) << name;
                EXPECT_EQ(planner->getName(), plannerTitle(name)) << name;
            }
        }

        TEST(PlannerFactory, KnowsThePlannersOfTheBenchmarkProgramAndThoseItDrops)
        {
            const auto names = plannerNames();
            for (const char *name : {"rrtconnect", "lazyrrt",    "lazyprm",
                                     "kpiece",     "bkpiece",    "lbkpiece",
                                     "est",        "biest",      "projest",
                                     "sbl",        "prm",        "rrt",
                                     "rrtxstatic", "bitstar",    "abitstar",
                                     "aitstar",    "stride",     "pdst",
                                     "rrtstar",    "prmstar",    "lazyprmstar",
                                     "spars",      "spars2",     "sst",
                                     "lbtrrt",     "lazylbtrrt", "trrt",
                                     "fmt",        "bfmt",       "anytimepathshortening",
                                     "aps",        "cforest",    "informedrrtstar",
                                     "sorrtstar",  "rrtsharp",   "tsrrt",
                                     "bitrrt",     "prrt",       "psbl",
                                     "rlrt",       "birlrt",     "qrrt",
                                     "mfa",        "mfa_paper",  "fa_paper"})
            {
                EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
            }
        }

        bool solvesSquareWithWall(const std::string &name)
        {
            const auto si = square();
            si->setStateValidityChecker(
                [](const ob::State *state)
                {
                    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    return std::abs(values[0] - 5.0) > 0.5 || values[1] > 6.0;
                });
            si->setup();
            auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(si);
            ob::ScopedState<> goal(si);
            start[0] = 2.0;
            goal[0] = 8.0;
            start[1] = goal[1] = 3.0;
            pdef->setStartAndGoalStates(start, goal, 0.5);
            const ob::PlannerPtr planner = createPlanner(si, spec(name));
            planner->setProblemDefinition(pdef);
            planner->setup();
            for (int attempt = 0; attempt < 50 && !pdef->hasSolution(); ++attempt)
            {
                planner->solve(0.1);
            }
            return pdef->hasSolution();
        }

        /* Each planner in its own process: assertions of OMPL 1.5.2's LazyLBTRRT and AIT* fail occasionally. */
        TEST(PlannerFactory, EveryPlannerSolvesASquareWithAWall)
        {
            for (const auto &name : plannerNames())
            {
                const pid_t child = ::fork();
                ASSERT_GE(child, 0);
                if (child == 0)
                {
                    ::_exit(solvesSquareWithWall(name) ? 0 : 1);
                }
                int status = 0;
                ASSERT_EQ(::waitpid(child, &status, 0), child);
                const bool mayAbort = name == "lazylbtrrt" || name == "aitstar";
                EXPECT_TRUE((WIFEXITED(status) && WEXITSTATUS(status) == 0) || (mayAbort && WIFSIGNALED(status)))
                    << name << " ended with " << status;
            }
        }

        TEST(PlannerFactory, SetsNameAndParameters)
        {
            PlannerSpec wanted = spec("rrtstar", {{"range", "0.25", "a.cfg:10"}, {"Goal_Bias", "0.5", "a.cfg:11"}});
            wanted.name = "RRT*";
            wanted.parameters.push_back({"tree_pruning", "on", "a.cfg:12"});
            const auto planner = std::dynamic_pointer_cast<ompl::geometric::RRTstar>(createPlanner(square(), wanted));
            ASSERT_TRUE(planner);
            EXPECT_EQ(planner->getName(), "RRT*");
            EXPECT_EQ(planner->getRange(), 0.25);
            EXPECT_EQ(planner->getGoalBias(), 0.5);
            EXPECT_TRUE(planner->getTreePruning());
        }

        TEST(PlannerFactory, ParametersOfOnePlannerDoNotReachTheNext)
        {
            const auto si = square();
            createPlanner(si, spec("rrtstar", {{"goal_bias", "0.5", "a.cfg:10"}}));
            const auto next = createPlanner(si, spec("rrtstar"));
            EXPECT_EQ(next->as<ompl::geometric::RRTstar>()->getGoalBias(), 0.05);
        }

        TEST(PlannerFactory, UnknownParametersNameTheNearestOne)
        {
            const std::string expected =
                "a.cfg:10: goal_bais = 0.1: unknown parameter of planner 'rrt'; did you mean 'goal_bias'?";
            EXPECT_EQ(errorOf("rrt", "goal_bais", "0.1").substr(0, expected.size()), expected);
            EXPECT_EQ(errorOf("mfa", "population", "20"),
                      "a.cfg:10: population = 20: unknown parameter of planner 'mfa'; did you mean 'population_size'?");
        }

        TEST(PlannerFactory, ValuesAreOfTheParametersType)
        {
            EXPECT_EQ(errorOf("rrt", "range", "12abc"), "a.cfg:10: range = 12abc: expected a finite number");
            EXPECT_NE(errorOf("rrt", "range", "nan"), "");
            EXPECT_NE(errorOf("rrt", "range", ""), "");
            EXPECT_EQ(errorOf("prm", "max_nearest_neighbors", "-1"),
                      "a.cfg:10: max_nearest_neighbors = -1: expected a whole number of at least 0");
            EXPECT_NE(errorOf("prm", "max_nearest_neighbors", "8.5"), "");
            EXPECT_NE(errorOf("prm", "max_nearest_neighbors", "1e3"), "");
            EXPECT_NE(errorOf("prm", "max_nearest_neighbors", "99999999999"), "");
            EXPECT_EQ(errorOf("rrtstar", "tree_pruning", "2"),
                      "a.cfg:10: tree_pruning = 2: expected one of 0, 1, false, true, no, yes, off, on");
            EXPECT_NE(errorOf("mfa", "population_size", "-1"), "");
            EXPECT_NE(errorOf("mfa", "population_size", "many"), "");
            EXPECT_EQ(errorOf("mfa", "variant", "pso"), "a.cfg:10: variant = pso: accepted is mfa, fa");
        }

        TEST(PlannerFactory, FractionsStayBelowOneAndLengthsAboveZero)
        {
            EXPECT_EQ(errorOf("rrt", "goal_bias", "1.5"), "a.cfg:10: goal_bias = 1.5: out of the range 0.:.05:1.");
            EXPECT_EQ(errorOf("rrt", "range", "-1"), "a.cfg:10: range = -1: out of the range 0.:1.:10000.");
            EXPECT_EQ(errorOf("rrt", "range", "20000"), "") << "OMPL's ranges are suggestions";
            EXPECT_EQ(errorOf("spars", "max_failures", "10000"), "") << "as in OMPL's own Barriers.cfg";
        }

        TEST(PlannerFactory, RangesOfTheFireflyPlannersAreLimits)
        {
            EXPECT_EQ(errorOf("mfa", "gamma", "1000"), "a.cfg:10: gamma = 1000: accepted is 0 to 100");
            EXPECT_EQ(errorOf("mfa_paper", "population_size", "10001"),
                      "a.cfg:10: population_size = 10001: accepted is 0, 4 to 10000");
            EXPECT_EQ(errorOf("mfa", "population_size", "3"),
                      "a.cfg:10: population_size = 3: accepted is 0, 4 to 10000");
            EXPECT_EQ(errorOf("mfa", "population_size", "0"), "");
            EXPECT_EQ(errorOf("mfa", "slices", "twelve"), "a.cfg:10: slices = twelve: accepted is 1 to 1000");
            EXPECT_EQ(errorOf("mfa", "seed", "4294967295"), "");
            EXPECT_NE(errorOf("mfa", "seed", "4294967296"), "");
        }

        TEST(PlannerFactory, SwitchesAreTrueAndFalse)
        {
            const auto valueOf = [](const std::string &type, const std::string &key, const std::string &value)
            {
                std::string text;
                createPlanner(square(), spec(type, {{key, value, "a.cfg:10"}}))->params().getParam(key, text);
                return text;
            };
            const std::vector<std::pair<std::string, std::string>> switches = {
                {"mfa", "tightening"}, {"mfa_paper", "recombination"}, {"rrtstar", "tree_pruning"}};
            for (const auto &[type, key] : switches)
            {
                for (const char *on : {"true", "True", "TRUE", "1", "yes", "on"})
                {
                    EXPECT_EQ(valueOf(type, key, on), "1") << type << " " << on;
                }
                for (const char *off : {"false", "False", "FALSE", "0", "no", "off"})
                {
                    EXPECT_EQ(valueOf(type, key, off), "0") << type << " " << off;
                }
                for (const char *wrong : {"2", "maybe", "-1", "1.0", ""})
                {
                    EXPECT_EQ(errorOf(type, key, wrong), "a.cfg:10: " + key + " = " + wrong +
                                                             ": expected one of 0, 1, false, true, no, yes, off, on");
                }
            }
        }

        TEST(PlannerFactory, WhatIsRefusedIsSaidOnce)
        {
            testing::internal::CaptureStderr();
            EXPECT_NE(errorOf("mfa", "population_size", "3"), "");
            EXPECT_NE(errorOf("mfa", "alpha", "2"), "");
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "OMPL's console";
        }

        TEST(PlannerFactory, UnknownAndUnavailablePlannersAreRefused)
        {
            const auto si = square();
            EXPECT_EQ(inputErrorOf([&] { createPlanner(si, spec("rrtconect")); }),
                      "a.cfg:9: unknown planner 'rrtconect'; did you mean 'rrtconnect'?");
            EXPECT_EQ(inputErrorOf([&] { createPlanner(si, spec("thunder")); }),
                      "a.cfg:9: planner 'thunder' is not available: it needs a database of experiences");
        }

        TEST(PlannerFactory, PlannersThatDoNotWorkInASpaceAreRefused)
        {
            const auto part = std::make_shared<ob::SO3StateSpace>();
            const auto rotations = inSpace(std::make_shared<ob::CompoundStateSpace>(
                std::vector<ob::StateSpacePtr>{part, part}, std::vector<double>{1.0, 1.0}));
            for (const char *name : {"kpiece", "sbl", "pdst", "projest", "lbkpiece"})
            {
                EXPECT_NE(inputErrorOf([&] { createPlanner(rotations, spec(name)); }).find("projection"),
                          std::string::npos)
                    << name;
            }
            EXPECT_NE(inputErrorOf([&] { createPlanner(rotations, spec("tsrrt")); }), "");

            const auto dubins = carSpace<ob::DubinsStateSpace>();
            const auto reedsShepp = carSpace<ob::ReedsSheppStateSpace>();
            for (const char *name : {"prm", "prmstar", "biest", "sbl", "spars"})
            {
                EXPECT_NE(inputErrorOf([&] { createPlanner(dubins, spec(name)); }).find("backwards"), std::string::npos)
                    << name;
                EXPECT_TRUE(createPlanner(reedsShepp, spec(name))) << name;
            }
            EXPECT_NE(inputErrorOf([&] { createPlanner(dubins, spec("lazylbtrrt")); }), "");
            EXPECT_TRUE(createPlanner(dubins, spec("rrtconnect")));
        }

        TEST(PlannerFactory, ParametersHaveTypesRangesAndDefaults)
        {
            const auto parameters = plannerParameters("rrtstar");
            const auto find = [&parameters](const std::string &name)
            {
                return *std::find_if(parameters.begin(), parameters.end(),
                                     [&name](const auto &parameter) { return parameter.name == name; });
            };
            EXPECT_EQ(find("goal_bias").type, "real");
            EXPECT_EQ(find("goal_bias").range, "0.:.05:1.");
            EXPECT_EQ(std::stod(find("goal_bias").defaultValue), 0.05);
            EXPECT_EQ(find("tree_pruning").type, "bool");
            EXPECT_EQ(find("number_sampling_attempts").type, "unsigned");
        }

        TEST(PlannerFactory, EveryRangeOfTheFireflyPlannersIsReadable)
        {
            const std::string number = "[0-9.]+(e[+-][0-9]+)?";
            const std::regex range(number + ":" + number + ":" + number + "|\\w+(,\\w+)+");
            for (const char *name : {"mfa", "mfa_paper", "fa_paper"})
            {
                for (const auto &parameter : plannerParameters(name))
                {
                    EXPECT_TRUE(std::regex_match(parameter.range, range)) << name << "." << parameter.name;
                }
            }
        }

        TEST(PlannerFactory, ThePapersPlannersAreNothingButTheSwarm)
        {
            for (const char *name : {"mfa_paper", "fa_paper"})
            {
                for (const auto &parameter : plannerParameters(name))
                {
                    if (parameter.name == "guide")
                    {
                        EXPECT_EQ(parameter.defaultValue, "none") << name;
                    }
                    if (parameter.name == "recombination" || parameter.name == "tightening")
                    {
                        EXPECT_EQ(parameter.defaultValue, "0") << name;
                    }
                }
            }
        }

        TEST(PlannerFactory, SeedsPlannersThatHaveASeed)
        {
            const auto mfa = createPlanner(square(), spec("mfa"));
            seedPlanner(*mfa, 77);
            std::string seed;
            ASSERT_TRUE(mfa->params().getParam("seed", seed));
            EXPECT_EQ(seed, "77");
            const auto rrt = createPlanner(square(), spec("rrt"));
            EXPECT_NO_THROW(seedPlanner(*rrt, 77));
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
