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
#include <limits>
#include <queue>
#include <random>
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

    TEST(WorldList, NamesThatMatchNothingAreRefused)
    {
        EXPECT_THROW(selectWorlds("no such world"), InputError);
        EXPECT_THROW(selectWorlds("("), InputError);
    }
}  // namespace ompl_mfa::anytime
