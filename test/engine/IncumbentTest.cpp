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

#include "engine/Incumbent.h"

#include <atomic>
#include <limits>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        class IncumbentTest : public ::testing::Test
        {
        protected:
            IncumbentTest()
            {
                path_.resize(3);
                for (std::size_t i = 0; i < 3; ++i)
                {
                    path_[i]->as<ob::RealVectorStateSpace::StateType>()->values[0] = static_cast<double>(i);
                }
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(1);
            ob::SpaceInformationPtr si_ = std::make_shared<ob::SpaceInformation>(space_);
            std::atomic<double> shown_{3.0};
            Incumbent incumbent_{std::make_shared<ob::PathLengthOptimizationObjective>(si_), space_, shown_};
            path::Waypoints path_{space_};
        };

        TEST_F(IncumbentTest, KnowsNothingAtFirst)
        {
            EXPECT_FALSE(incumbent_.hasPath());
            EXPECT_FALSE(incumbent_.hasFinitePath());
            EXPECT_EQ(incumbent_.cost(), NEVER);
            EXPECT_EQ(shown_, NEVER);
            EXPECT_EQ(incumbent_.bound(), NEVER);
            EXPECT_EQ(incumbent_.improvements(), 0U);
            EXPECT_EQ(incumbent_.origin(), std::nullopt);
            EXPECT_TRUE(incumbent_.partialPath().empty());
            EXPECT_EQ(incumbent_.partialDistance(), NEVER);
            EXPECT_TRUE(incumbent_.improvedBy(1e300));
        }

        TEST_F(IncumbentTest, KeepsTheBetterPath)
        {
            EXPECT_TRUE(incumbent_.offer(path_, 5.0));
            path_.resize(2);
            EXPECT_FALSE(incumbent_.offer(path_, 5.0));
            EXPECT_FALSE(incumbent_.offer(path_, 6.0));
            EXPECT_EQ(incumbent_.path().size(), 3U);
            EXPECT_TRUE(incumbent_.offer(path_, 4.0));
            EXPECT_EQ(incumbent_.path().size(), 2U);
            EXPECT_EQ(incumbent_.cost(), 4.0);
            EXPECT_EQ(shown_, 4.0);
            EXPECT_EQ(incumbent_.bound(), 4.0);
            EXPECT_EQ(incumbent_.improvements(), 2U);
        }

        TEST_F(IncumbentTest, TheObjectiveSaysWhatIsBetter)
        {
            Incumbent incumbent(std::make_shared<ob::MaximizeMinClearanceObjective>(si_), space_, shown_);
            EXPECT_TRUE(incumbent.offer(path_, 1.0));
            EXPECT_TRUE(incumbent.improvedBy(2.0));
            EXPECT_FALSE(incumbent.improvedBy(0.5));
        }

        TEST_F(IncumbentTest, KeepsThePartialPathThatEndsNearest)
        {
            EXPECT_TRUE(incumbent_.offerPartial(path_, 1, path_[1], 3.0));
            EXPECT_EQ(incumbent_.partialPath().size(), 2U);
            EXPECT_FALSE(incumbent_.offerPartial(path_, 2, path_[2], 3.0));
            EXPECT_TRUE(incumbent_.offerPartial(path_, 2, path_[2], 1.0));
            EXPECT_EQ(incumbent_.partialPath().size(), 3U);
            EXPECT_EQ(incumbent_.partialDistance(), 1.0);
            EXPECT_FALSE(incumbent_.hasPath());
        }

        TEST_F(IncumbentTest, RemembersWhoFoundTheBestPath)
        {
            incumbent_.offer(path_, 5.0, PartKind::Trees);
            EXPECT_EQ(incumbent_.origin(), PartKind::Trees);
            incumbent_.offer(path_, 6.0, PartKind::Roadmap);
            EXPECT_EQ(incumbent_.origin(), PartKind::Trees) << "a path that is not kept";
            incumbent_.offer(path_, 4.0);
            EXPECT_EQ(incumbent_.origin(), std::nullopt);
        }

        TEST_F(IncumbentTest, WhatBeatsAPathOfInfiniteCostIsAnyFiniteNumber)
        {
            incumbent_.offer(path_, NEVER);
            EXPECT_TRUE(incumbent_.hasPath());
            EXPECT_FALSE(incumbent_.hasFinitePath());
            EXPECT_EQ(incumbent_.bound(), std::numeric_limits<double>::max());
            EXPECT_TRUE(incumbent_.improvedBy(1e300));
            Incumbent clearance(std::make_shared<ob::MaximizeMinClearanceObjective>(si_), space_, shown_);
            clearance.offer(path_, -NEVER);
            EXPECT_EQ(clearance.bound(), std::numeric_limits<double>::lowest());
        }

        TEST_F(IncumbentTest, TheGoalOfThePartialPathMayMove)
        {
            incumbent_.offerPartial(path_, 1, path_[1], 1.0);
            EXPECT_FALSE(incumbent_.offerPartial(path_, 2, path_[2], 2.0));
            incumbent_.setPartialDistance(3.0);
            EXPECT_TRUE(incumbent_.offerPartial(path_, 2, path_[2], 2.0));
        }
    }  // namespace
}  // namespace ompl_mfa::engine
