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

#include "engine/Streams.h"

#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/util/RandomNumbers.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        constexpr Stream STREAMS[] = {Stream::Trees,         Stream::Roadmap,         Stream::Tightening,
                                      Stream::NewTightening, Stream::DraftTightening, Stream::BestDraft,
                                      Stream::Repair,        Stream::PathSwarm,       Stream::SwarmTightening,
                                      Stream::LocalTrees,    Stream::Swarm,           Stream::Detours,
                                      Stream::GoalSearch,    Stream::Mending,         Stream::Successor,
                                      Stream::Strict,        Stream::StrictTightening};

        std::string name(std::uint64_t run, Stream stream, std::uint64_t index)
        {
            return "run " + std::to_string(run) + ", stream " + std::to_string(static_cast<int>(stream)) + ", index " +
                   std::to_string(index);
        }

        TEST(Streams, OfOneRunAndOfItsNeighboursBeginWithDifferentNumbers)
        {
            // the swarms of a run have separate streams, one for each epoch
            std::map<double, std::string> first;
            const auto expectNew = [&first](std::uint64_t seed, const std::string &owner)
            {
                const auto [other, isNew] = first.emplace(RandomSource(seed).uniform(), owner);
                EXPECT_TRUE(isNew) << owner << " draws the same as " << other->second;
            };
            for (const std::uint64_t run : {1U, 2U, 8U, 1001U})
            {
                for (const Stream stream : STREAMS)
                {
                    for (std::uint64_t index = 0; index < 30; ++index)
                    {
                        const std::uint64_t seed = streamSeed(run, stream, index);
                        expectNew(seed, name(run, stream, index));
                        for (std::uint64_t epoch = 0; epoch < 4; ++epoch)
                        {
                            expectNew(streamSeed(seed, Stream::Epoch, epoch),
                                      name(run, stream, index) + ", epoch " + std::to_string(epoch));
                        }
                        expectNew(streamSeed(seed, Stream::Recombination),
                                  name(run, stream, index) + ", recombination");
                    }
                }
            }
            EXPECT_EQ(first.size(), 4U * std::size(STREAMS) * 30U * 6U);
        }

        /* Another number gives other results of a seeded run: those that were published could not be repeated. A new
           stream takes a number that no other has or had. */
        TEST(Streams, KeepTheirNumbers)
        {
            const std::pair<Stream, std::uint64_t> numbers[] = {{Stream::Trees, 0},
                                                                {Stream::Roadmap, 1},
                                                                {Stream::Tightening, 2},
                                                                {Stream::NewTightening, 3},
                                                                {Stream::Swarm, 6},
                                                                {Stream::Detours, 7},
                                                                {Stream::GoalSearch, 8},
                                                                {Stream::Epoch, 9},
                                                                {Stream::Recombination, 10},
                                                                {Stream::DraftTightening, 11},
                                                                {Stream::BestDraft, 12},
                                                                {Stream::Repair, 13},
                                                                {Stream::PathSwarm, 14},
                                                                {Stream::SwarmTightening, 15},
                                                                {Stream::LocalTrees, 16},
                                                                {Stream::Strict, 17},
                                                                {Stream::StrictTightening, 18},
                                                                {Stream::Mending, 19},
                                                                {Stream::Successor, 20}};
            for (const auto &[stream, number] : numbers)
            {
                EXPECT_EQ(static_cast<std::uint64_t>(stream), number);
                EXPECT_EQ(streamSeed(7, stream, 3), deriveSeed(7, number, 3));
            }
            EXPECT_EQ(std::size(numbers), std::size(STREAMS) + 2);  // and the two of a swarm
            EXPECT_EQ(streamSeed(1, Stream::Swarm, 2), 4176234653059138083U);
        }

        using Point = std::pair<double, double>;

        /* The states that a run with one guide alone checks, without those on the straight motion from start to
           goal. */
        std::set<Point> statesOfARun(const std::string &guide, std::uint32_t seed)
        {
            std::set<Point> states;
            test::PlanningProblem problem(
                test::realVectorSpace(2, 0.0, 10.0),
                [&states](const ob::State *state)
                {
                    if (test::coordinate(state, 1) != 1.0)
                    {
                        states.emplace(test::coordinate(state, 0), test::coordinate(state, 1));
                    }
                    return test::coordinate(state, 0) <= 4.5 || test::coordinate(state, 0) >= 5.5;
                },
                {1.0, 1.0}, {9.0, 1.0});
            const auto planner = problem.planner(test::PlannerVariant::Default, seed);
            test::set(*planner, "guide", guide);
            // before the first turn of the fireflies, whose paths share the corners of the square
            planner->solve(test::afterCalls(800));
            return states;
        }

        TEST(Streams, GuidesOfNeighbouringRunsDrawDifferentStates)
        {
            std::set<Point> seen;
            for (const std::uint32_t seed : {5U, 6U, 12U})
            {
                for (const char *guide : {"trees", "roadmap"})
                {
                    unsigned int common = 0;
                    const std::set<Point> states = statesOfARun(guide, seed);
                    EXPECT_GT(states.size(), 300U);
                    for (const Point &state : states)
                    {
                        common += seen.insert(state).second ? 0 : 1;
                    }
                    EXPECT_EQ(common, 0U) << guide << " of seed " << seed;
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine
