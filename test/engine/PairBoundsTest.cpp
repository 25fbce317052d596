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

#include "engine/PairBounds.h"

#include <cstdint>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        constexpr double ANY = std::numeric_limits<double>::infinity();

        /* Path length on a line; a goal costs minus ten times its distance beyond 5. Counts its calls. */
        class CountedLength : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCostHeuristic(const ob::State *from, const ob::State *to) const override
            {
                ++asked;
                return motionCost(from, to);
            }

            ob::Cost terminalCost(const ob::State *state) const override
            {
                const double x = state->as<ob::RealVectorStateSpace::StateType>()->values[0];
                return ob::Cost(x > 5.0 ? -10.0 * x : 0.0);
            }

            mutable std::uint64_t asked{0};
        };

        class PairBoundsTest : public ::testing::Test
        {
        protected:
            void append(path::Waypoints &states, double x)
            {
                ob::ScopedState<> state(space_);
                state[0] = x;
                states.append(state.get());
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(1, 0.0, 1000.0);
            ob::SpaceInformationPtr si_ = std::make_shared<ob::SpaceInformation>(space_);
            std::shared_ptr<CountedLength> objective_ = std::make_shared<CountedLength>(si_);
            path::CostBounds bounds_{si_, objective_};
            PairBounds pairs_{bounds_};
            path::Waypoints starts_{space_};
            path::Waypoints goals_{space_};
        };

        TEST_F(PairBoundsTest, TellWhichEndsCanBeOnABetterPath)
        {
            append(starts_, 0.0);
            append(starts_, 4.0);
            append(goals_, 2.0);
            append(goals_, 10.0);
            pairs_.update(starts_, goals_);
            // from 4 to 10: 6 - 100
            EXPECT_TRUE(pairs_.goalCanBeat(1, -93.9));
            EXPECT_FALSE(pairs_.goalCanBeat(1, -94.0));
            EXPECT_FALSE(pairs_.goalCanBeat(0, 2.0));
            EXPECT_TRUE(pairs_.startCanBeat(1, -93.9));
            EXPECT_FALSE(pairs_.startCanBeat(0, -90.0));
            EXPECT_TRUE(pairs_.startCanBeat(0, ANY));
            EXPECT_TRUE(pairs_.isBest(-94.0, starts_, goals_));
            EXPECT_FALSE(pairs_.isBest(2.0, starts_, goals_));
            // a cost below all bounds proves nothing
            EXPECT_FALSE(pairs_.isBest(-95.0, starts_, goals_));
        }

        TEST_F(PairBoundsTest, TakeUpEndsThatComeLater)
        {
            append(starts_, 0.0);
            append(goals_, 2.0);
            pairs_.update(starts_, goals_);
            EXPECT_TRUE(pairs_.isBest(2.0, starts_, goals_));
            append(goals_, 10.0);
            EXPECT_FALSE(pairs_.isBest(2.0, starts_, goals_));
            EXPECT_TRUE(pairs_.goalCanBeat(1, -1000.0));
            pairs_.update(starts_, goals_);
            EXPECT_TRUE(pairs_.isBest(-90.0, starts_, goals_));
            append(starts_, 9.0);
            pairs_.update(starts_, goals_);
            EXPECT_TRUE(pairs_.isBest(-99.0, starts_, goals_));
            starts_.clear();
            append(starts_, 1.0);
            pairs_.update(starts_, goals_);
            EXPECT_TRUE(pairs_.isBest(-91.0, starts_, goals_));
        }

        TEST_F(PairBoundsTest, AskForEachPairOnce)
        {
            for (int i = 0; i < 30; ++i)
            {
                append(starts_, i);
            }
            for (int j = 0; j < 1000; ++j)
            {
                append(goals_, j);
            }
            for (int turn = 0; turn < 1000; ++turn)
            {
                const std::uint64_t before = objective_->asked;
                pairs_.update(starts_, goals_);
                EXPECT_LE(objective_->asked - before, 2100U);
                for (std::size_t j = 0; j < goals_.size(); ++j)
                {
                    pairs_.goalCanBeat(j, -5000.0);
                }
            }
            EXPECT_EQ(objective_->asked, 30000U);
            EXPECT_TRUE(pairs_.isBest(970.0 - 9990.0, starts_, goals_));
        }

        TEST_F(PairBoundsTest, ThatTurnedOutWrongGiveNothingUpAndProveNothing)
        {
            append(starts_, 0.0);
            append(goals_, 2.0);
            pairs_.update(starts_, goals_);
            EXPECT_FALSE(pairs_.goalCanBeat(0, 1.0));
            bounds_.observePath(starts_[0], goals_[0], ob::Cost(1.0));
            ASSERT_FALSE(bounds_.admissible());
            EXPECT_TRUE(pairs_.goalCanBeat(0, 1.0));
            EXPECT_FALSE(pairs_.isBest(2.0, starts_, goals_));
        }
    }  // namespace
}  // namespace ompl_mfa::engine
