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

#include "engine/Alternatives.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "path/StateSpaces.h"

namespace ompl_mfa::engine
{
    namespace
    {
        class AlternativesTest : public ::testing::Test
        {
        protected:
            void add(double y)
            {
                alternatives_.add(test::planarPath(space_, {{0.0, 0.0}, {1.0, y}, {2.0, 0.0}}));
            }

            /* The heights of the middle states, which tell the paths kept apart. */
            std::set<double> kept() const
            {
                std::set<double> heights;
                for (std::size_t i = 0; i < alternatives_.size(); ++i)
                {
                    EXPECT_EQ(alternatives_[i].size(), 3U);
                    std::vector<double> values;
                    space_->copyToReals(values, alternatives_[i][1]);
                    heights.insert(values[1]);
                }
                return heights;
            }

            ompl::base::StateSpacePtr space_ = test::realVectorSpace(2);
            Alternatives alternatives_;
        };

        TEST_F(AlternativesTest, AreCopiesOfThePathsThatWereAdded)
        {
            EXPECT_EQ(alternatives_.size(), 0U);
            path::Waypoints path = test::planarPath(space_, {{0.0, 0.0}, {1.0, 0.5}, {2.0, 0.0}});
            alternatives_.add(path);
            path.clear();
            ASSERT_EQ(alternatives_.size(), 1U);
            EXPECT_EQ(kept(), (std::set<double>{0.5}));
        }

        TEST_F(AlternativesTest, ThreeAreKeptAndTheOldestMakesRoom)
        {
            for (const double y : {0.5, 1.0, 1.5})
            {
                add(y);
            }
            EXPECT_EQ(kept(), (std::set<double>{0.5, 1.0, 1.5}));
            add(2.0);
            EXPECT_EQ(kept(), (std::set<double>{1.0, 1.5, 2.0}));
            add(2.5);
            add(3.0);
            add(3.5);
            EXPECT_EQ(kept(), (std::set<double>{2.5, 3.0, 3.5}));
            EXPECT_EQ(alternatives_.size(), 3U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine
