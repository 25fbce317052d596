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

#include "anytime/WorldList.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <queue>
#include <random>
#include <regex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        const char *const OWN_WORLDS = "^(circles|wall|double|dividing|random|arm)";

        bool isFree(const Problem &problem, const std::vector<double> &reals)
        {
            ob::ScopedState<> state(problem.si);
            problem.si->getStateSpace()->copyFromReals(state.get(), reals);
            return problem.si->isValid(state.get());
        }

        /* Shortest path over a grid with eight neighbours a point: from 0 to 8.3% above the optimum, and a little more
           for turns that miss the grid. */
        double gridOptimum(const Problem &problem)
        {
            constexpr int N = 500;
            const auto at = [](int ix, int iy) { return iy * (N + 1) + ix; };
            std::vector<char> free(std::size_t{N + 1} * (N + 1));
            for (int iy = 0; iy <= N; ++iy)
            {
                for (int ix = 0; ix <= N; ++ix)
                {
                    free[at(ix, iy)] =
                        isFree(problem, {static_cast<double>(ix) / N, static_cast<double>(iy) / N}) ? 1 : 0;
                }
            }
            const auto indexOf = [&](const ob::State *state)
            {
                std::vector<double> reals;
                problem.si->getStateSpace()->copyToReals(reals, state);
                return at(static_cast<int>(std::lround(reals[0] * N)), static_cast<int>(std::lround(reals[1] * N)));
            };
            const int start = indexOf(problem.pdef->getStartState(0));
            const int goal = indexOf(problem.pdef->getGoal()->as<ob::GoalState>()->getState());
            std::vector<double> distance(free.size(), std::numeric_limits<double>::infinity());
            using Entry = std::pair<double, int>;
            std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
            distance[start] = 0.0;
            queue.emplace(0.0, start);
            while (!queue.empty())
            {
                const auto [length, index] = queue.top();
                queue.pop();
                if (length > distance[index])
                {
                    continue;
                }
                const int ix = index % (N + 1);
                const int iy = index / (N + 1);
                for (int dy = -1; dy <= 1; ++dy)
                {
                    for (int dx = -1; dx <= 1; ++dx)
                    {
                        if (ix + dx < 0 || ix + dx > N || iy + dy < 0 || iy + dy > N || !free[at(ix + dx, iy + dy)])
                        {
                            continue;
                        }
                        const int next = at(ix + dx, iy + dy);
                        const double longer = length + std::hypot(dx, dy) / N;
                        if (longer < distance[next])
                        {
                            distance[next] = longer;
                            queue.emplace(longer, next);
                        }
                    }
                }
            }
            return distance[goal];
        }

        std::vector<double> randomReals(std::mt19937 &engine, const ob::RealVectorBounds &bounds)
        {
            std::vector<double> reals;
            for (std::size_t i = 0; i < bounds.low.size(); ++i)
            {
                reals.push_back(std::uniform_real_distribution<double>(bounds.low[i], bounds.high[i])(engine));
            }
            return reals;
        }
    }  // namespace

    TEST(WorldList, EveryWorldIsWorthPlanningIn)
    {
        std::set<std::string> names;
        for (const auto &world : selectWorlds(OWN_WORLDS))
        {
            EXPECT_TRUE(names.insert(world.name).second) << world.name << " twice";
            const auto problem = world.make();
            const ob::State *start = problem.pdef->getStartState(0);
            const ob::State *goal = problem.pdef->getGoal()->as<ob::GoalState>()->getState();
            EXPECT_TRUE(problem.si->isValid(start)) << world.name;
            EXPECT_TRUE(problem.si->isValid(goal)) << world.name;
            EXPECT_FALSE(problem.si->checkMotion(start, goal)) << world.name << ": the straight line is free";
            if (world.optimum)
            {
                EXPECT_GT(world.optimum(), problem.si->distance(start, goal)) << world.name;
            }
        }
        EXPECT_EQ(names.size(), 20U);
    }

    TEST(WorldList, AWorldIsTheSameEachTime)
    {
        std::mt19937 engine(3);
        for (const auto &world : selectWorlds(OWN_WORLDS))
        {
            const auto first = world.make();
            const auto second = world.make();
            const auto &bounds = first.si->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
            int free = 0;
            for (int i = 0; i < 1000; ++i)
            {
                const auto reals = randomReals(engine, bounds);
                ASSERT_EQ(isFree(first, reals), isFree(second, reals)) << world.name;
                free += isFree(first, reals) ? 1 : 0;
            }
            EXPECT_GT(free, 20) << world.name << ": hardly any room";
            EXPECT_LT(free, 1000) << world.name << ": no obstacle to be found";
            EXPECT_EQ(first.checker->checks(), 2000U);
        }
    }

    TEST(WorldList, OptimaInThePlaneAgreeWithAGrid)
    {
        for (const auto &world : selectWorlds("_2d_"))
        {
            const double grid = gridOptimum(world.make());
            EXPECT_GT(grid, world.optimum() * (1.0 - 1e-3)) << world.name;
            EXPECT_LT(grid, world.optimum() * 1.1) << world.name;
        }
    }

    TEST(WorldList, OptimaOfMoreDimensionsLieInThePlane)
    {
        std::mt19937 engine(4);
        for (const char *kind : {"wall_gap_4d_1", "wall_gap_8d_1", "double_enclosure_4d_1", "dividing_walls_4d_1"})
        {
            const auto world = selectWorlds(std::string("^") + kind).front();
            const auto planar = selectWorlds("^" + world.family.substr(0, world.family.size() - 2) + "2d").front();
            EXPECT_EQ(world.optimum(), planar.optimum());
            const auto problem = world.make();
            const auto section = planar.make();
            for (int i = 0; i < 3000; ++i)
            {
                std::vector<double> reals =
                    randomReals(engine, section.si->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds());
                const bool free = isFree(section, reals);
                reals.resize(problem.si->getStateDimension(), 0.5);
                EXPECT_EQ(isFree(problem, reals), free) << kind;
            }
        }
    }

    TEST(WorldList, TheBestClassAmongCirclesIsNarrow)
    {
        for (const std::uint64_t seed : {3, 7, 8})
        {
            EXPECT_GT(circleOptimum(seed, 0.004), 1.02 * circleOptimum(seed, 0.0)) << seed;
        }
        for (const std::uint64_t seed : {1, 2, 4, 5, 6})
        {
            EXPECT_FALSE(hasNarrowCircles(seed)) << "the suite has the first seeds that have a narrow gap";
        }
    }

    TEST(WorldList, StoredReferencesHoldInTheirWorlds)
    {
        std::ifstream in(OMPL_MFA_SOURCE_DIR "/benchmarks/anytime/references.jsonl");
        ASSERT_TRUE(in);
        const auto worlds = allWorlds();
        std::size_t exact = 0;
        for (std::string line; std::getline(in, line);)
        {
            const auto reference = nlohmann::json::parse(line);
            const auto world =
                std::find_if(worlds.begin(), worlds.end(),
                             [&](const auto &candidate) { return candidate.name == reference["world"]; });
            if (world == worlds.end())
            {
                EXPECT_EQ(reference["world"].get<std::string>().rfind("omplapp_", 0), 0U)
                    << reference["world"] << ": no such world";
                continue;
            }
            if (reference["path"].empty())
            {
                ++exact;
                EXPECT_NEAR(reference["cost"].get<double>(), world->optimum(), 1e-9) << world->name;
                continue;
            }
            const auto problem = world->make();
            ompl::geometric::PathGeometric path(problem.si);
            ob::ScopedState<> state(problem.si);
            for (const auto &reals : reference["path"])
            {
                problem.si->getStateSpace()->copyFromReals(state.get(), reals);
                path.append(state.get());
            }
            EXPECT_TRUE(path.check()) << world->name;
            EXPECT_NEAR(path.length(), reference["cost"].get<double>(), 1e-6 * path.length()) << world->name;
        }
        EXPECT_EQ(exact, 12U);
    }

    namespace
    {
        std::vector<std::string> namesOf(const std::vector<World> &worlds)
        {
            std::vector<std::string> names;
            std::transform(worlds.begin(), worlds.end(), std::back_inserter(names),
                           [](const World &world) { return world.name; });
            return names;
        }

        std::string refusalOf(const std::string &name)
        {
            try
            {
                generatedWorlds({name});
            }
            catch (const InputError &error)
            {
                return error.what();
            }
            return "";
        }
    }  // namespace

    TEST(GeneratedWorlds, AreThoseOfTheSuiteWhereItHasThem)
    {
        std::mt19937 engine(5);
        for (const auto &world : selectWorlds(OWN_WORLDS))
        {
            const World generated = generatedWorlds({world.name}).at(0);
            EXPECT_EQ(generated.name, world.name);
            EXPECT_EQ(generated.family, world.family);
            ASSERT_EQ(static_cast<bool>(generated.optimum), static_cast<bool>(world.optimum)) << world.name;
            if (world.optimum)
            {
                EXPECT_EQ(generated.optimum(), world.optimum());
            }
            const auto first = world.make();
            const auto second = generated.make();
            const auto &bounds = first.si->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
            for (int i = 0; i < 300; ++i)
            {
                const auto reals = randomReals(engine, bounds);
                ASSERT_EQ(isFree(first, reals), isFree(second, reals)) << world.name;
            }
        }
    }

    TEST(GeneratedWorlds, HaveOtherObstaclesWithAnotherSeed)
    {
        const std::vector<std::pair<std::string, unsigned int>> families = {{"wall_gap_3d", 3},
                                                                            {"double_enclosure_2d", 2},
                                                                            {"dividing_walls_16d", 16},
                                                                            {"random_boxes_2d", 2},
                                                                            {"random_boxes_4d", 4},
                                                                            {"random_boxes_8d", 8},
                                                                            {"random_boxes_16d", 16},
                                                                            {"arm_2", 2},
                                                                            {"arm_7", 7},
                                                                            {"arm_16", 16}};
        std::mt19937 engine(6);
        for (const auto &[family, dimension] : families)
        {
            const auto worlds = generatedWorlds({family + "_101", family + "_102"});
            ASSERT_EQ(worlds.size(), 2U);
            EXPECT_EQ(worlds[0].family, family);
            const auto first = worlds[0].make();
            const auto second = worlds[1].make();
            EXPECT_EQ(first.si->getStateDimension(), dimension);
            EXPECT_TRUE(first.si->isValid(first.pdef->getStartState(0))) << family;
            EXPECT_TRUE(first.si->isValid(first.pdef->getGoal()->as<ob::GoalState>()->getState())) << family;
            const auto &bounds = first.si->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
            int different = 0;
            for (int i = 0; i < 20000; ++i)
            {
                const auto reals = randomReals(engine, bounds);
                different += isFree(first, reals) != isFree(second, reals) ? 1 : 0;
            }
            EXPECT_GT(different, 0) << family;
        }
    }

    TEST(GeneratedWorlds, AreWorthPlanningIn)
    {
        std::vector<std::string> names;
        for (const char *family : {"wall_gap_5d", "double_enclosure_3d", "dividing_walls_6d", "random_boxes_2d",
                                   "random_boxes_4d", "random_boxes_16d", "arm_2", "arm_16"})
        {
            for (int seed = 110; seed < 120; ++seed)
            {
                names.push_back(std::string(family) + "_" + std::to_string(seed));
            }
        }
        for (const World &world : generatedWorlds(names))
        {
            const auto problem = world.make();
            const ob::State *start = problem.pdef->getStartState(0);
            const ob::State *goal = problem.pdef->getGoal()->as<ob::GoalState>()->getState();
            EXPECT_TRUE(problem.si->isValid(start)) << world.name;
            EXPECT_TRUE(problem.si->isValid(goal)) << world.name;
            EXPECT_FALSE(problem.si->checkMotion(start, goal)) << world.name;
        }
    }

    TEST(GeneratedWorlds, ThatAreKnownToBeWorthNothingAreRefused)
    {
        EXPECT_EQ(refusalOf("random_boxes_2d_7"),
                  "--generated 'random_boxes_2d_7': there is no path from start to goal; "
                  "the next seed that will do is 9");
        EXPECT_EQ(gridOptimum(boxWorld("random_boxes", 2, 7).make()), std::numeric_limits<double>::infinity());
        EXPECT_EQ(refusalOf("random_boxes_2d_9"), "");
        EXPECT_EQ(refusalOf("circles_narrow_2d_4"),
                  "--generated 'circles_narrow_2d_4': the shortest path squeezes "
                  "through no narrow gap; the next seed that will do is 7");
    }

    TEST(GeneratedWorlds, NamesOfNoWorldAreRefused)
    {
        for (const char *name : {"", "random_boxes", "random_boxes_8d", "random_boxes_8_101", "random_boxes_3d_1",
                                 "random_boxes_8d_0", "random_boxes_8d_01", "random_boxes_8d_4294967296",
                                 "random_boxes_8d_1 ", "random_boxes_99999999999d_1", "wall_gap_17d_1", "wall_gap_1d_1",
                                 "arm_7d_1", "arm_1_1", "circles_narrow_4d_3", "own_rooms", "no_such_2d_1"})
        {
            EXPECT_NE(refusalOf(name).find(std::string("--generated '") + name + "'"), std::string::npos) << name;
        }
        EXPECT_NE(refusalOf("random_boxes_3d_1").find("2, 4, 8, 16"), std::string::npos);
        EXPECT_EQ(refusalOf("random_boxes_8d_4294967295"), "");
    }

    TEST(GeneratedWorlds, AreRunAloneUnlessThereIsAPattern)
    {
        using Names = std::vector<std::string>;
        const Names generated{"arm_7_5", "wall_gap_2d_1", "arm_7_5"};
        EXPECT_EQ(namesOf(selectWorlds("", generated)), (Names{"arm_7_5", "wall_gap_2d_1"}));
        EXPECT_EQ(namesOf(selectWorlds("^wall_gap_[24]", generated)),
                  (Names{"arm_7_5", "wall_gap_2d_1", "wall_gap_4d_1"}));
        EXPECT_EQ(namesOf(selectWorlds("^arm", {})), (Names{"arm_7_1", "arm_12_1"}));
        EXPECT_EQ(selectWorlds("", {}).size(), allWorlds().size());
        const std::vector<std::filesystem::path> configs{std::string(OMPL_MFA_SOURCE_DIR) +
                                                         "/benchmarks/configs/circle_field.cfg"};
        EXPECT_EQ(namesOf(selectWorlds("", {}, configs)), (Names{"circle_field"}));
        EXPECT_EQ(namesOf(selectWorlds("^arm_7", {}, configs)), (Names{"circle_field", "arm_7_1"}));
        EXPECT_EQ(namePattern("", {"arm_7_5"}, configs), "^arm_7_5$|^circle_field$");
    }

    TEST(GeneratedWorlds, AreReportedWithTheOthers)
    {
        using Names = std::vector<std::string>;
        const Names suite = namesOf(allWorlds());
        EXPECT_FALSE(std::regex_search("arm_7_55", std::regex(namePattern("", {"arm_7_5"}))));
        for (const std::string pattern : {"", "^wall_gap_[24]", "arm|boxes"})
        {
            for (const Names &generated : {Names{}, Names{"arm_7_5"}, Names{"arm_7_5", "wall_gap_2d_9"}})
            {
                const Names selected = namesOf(selectWorlds(pattern, generated));
                const std::regex expression(namePattern(pattern, generated));
                for (const std::string &name : suite)
                {
                    const bool isSelected = std::find(selected.begin(), selected.end(), name) != selected.end();
                    EXPECT_EQ(std::regex_search(name, expression), isSelected) << name;
                }
                for (const std::string &name : generated)
                {
                    EXPECT_TRUE(std::regex_search(name, expression)) << name;
                }
            }
        }
    }

    TEST(WorldList, NamesThatMatchNothingAreRefused)
    {
        EXPECT_THROW(selectWorlds("no such world"), InputError);
        EXPECT_THROW(selectWorlds("("), InputError);
    }
}  // namespace ompl_mfa::anytime
