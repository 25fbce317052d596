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

#include "engine/fireflies/Swarms.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/SearchProblem.h"
#include "path/StateSpaces.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        constexpr unsigned int POPULATION = 20;

        Swarms::Options paperOptions()
        {
            Swarms::Options options;
            options.coordinates = Swarm::Coordinates::Offsets;
            options.pool = options.bounded = false;
            options.fireflies.populationSize = POPULATION;
            return options;
        }

        class SwarmsTest : public ::testing::Test
        {
        protected:
            SwarmsTest()
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            static void flyOneGeneration(Swarms &swarms)
            {
                ASSERT_NE(swarms.active(), nullptr);
                while (!swarms.fly(1000))
                {
                }
            }

            /* Whether one of the fireflies has these states, up to rounding. */
            bool isAmong(const path::Waypoints &path, const std::vector<path::Waypoints> &fireflies) const
            {
                for (const path::Waypoints &firefly : fireflies)
                {
                    double farthest = firefly.size() == path.size() ? 0.0 : 1.0;
                    for (std::size_t i = 0; i < path.size() && farthest < 1e-6; ++i)
                    {
                        farthest = std::max(farthest, search_.si->distance(path[i], firefly[i]));
                    }
                    if (farthest < 1e-6)
                    {
                        return true;
                    }
                }
                return false;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            test::SearchProblem search_{problem_->pdef};
        };

        TEST_F(SwarmsTest, BeginWithTheBrightestFirefliesOfAnEarlierSearch)
        {
            Swarms earlier(search_.context, paperOptions());
            flyOneGeneration(earlier);
            const std::vector<path::Waypoints> brightest = earlier.currentPaths();
            ASSERT_EQ(brightest.size(), POPULATION);
            test::SearchProblem next(problem_->pdef, 6);
            next.begin();
            Swarms alone(next.context, paperOptions());
            flyOneGeneration(alone);
            Swarms heir(next.context, paperOptions());
            heir.inherit(earlier);
            flyOneGeneration(heir);
            for (std::size_t i = 0; i < POPULATION / 5; ++i)
            {
                EXPECT_TRUE(isAmong(brightest[i], heir.currentPaths())) << i;
                EXPECT_FALSE(isAmong(brightest[i], alone.currentPaths())) << i;
            }
        }

        TEST_F(SwarmsTest, BeginWithHintsThatCrossAllSlices)
        {
            const auto &space = problem_->si->getStateSpace();
            for (int i = 0; i < 30; ++i)
            {
                search_.context.firstFireflies.push_back(test::planarPath(space, {{1, 1}, {5, 6.0 + 0.1 * i}, {9, 1}}));
            }
            // these do not, and do no harm
            search_.context.firstFireflies.insert(search_.context.firstFireflies.begin(), 3,
                                                  test::planarPath(space, {{2, 2}, {3, 3}}));
            search_.context.firstFireflies.push_back(test::planarPath(space, {{5, 5}}));
            Swarms swarms(search_.context, paperOptions());
            flyOneGeneration(swarms);
            // some have moved since
            unsigned int found = 0;
            for (std::size_t i = 3; i < 33; ++i)
            {
                path::Waypoints onSlices(space);
                ASSERT_TRUE(swarms.current()->frame().crossings(search_.context.firstFireflies[i], onSlices));
                found += isAmong(onSlices, swarms.currentPaths()) ? 1 : 0;
            }
            EXPECT_GE(found, POPULATION / 4);
            EXPECT_EQ(swarms.currentPaths().size(), POPULATION);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
