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

#include "planner/RangedParam.h"

#include <string>

#include <gtest/gtest.h>

#include "planner/ConsoleRecord.h"

namespace ompl_mfa::planner
{
    namespace
    {
        class RangedParamTest : public ::testing::Test
        {
        protected:
            RangedParam<double> parameter_{"share", AcceptedValues<double>(0.0, 0.1, 1.0),
                                           [this](const double &value) { value_ = value; }, [this] { return value_; }};
            double value_{0.5};
        };

        TEST_F(RangedParamTest, SetsAndReadsBack)
        {
            EXPECT_EQ(parameter_.getName(), "share");
            EXPECT_EQ(parameter_.getRangeSuggestion(), "0.0:0.1:1.0");
            EXPECT_TRUE(parameter_.setValue("0.25"));
            EXPECT_EQ(value_, 0.25);
            EXPECT_EQ(parameter_.getValue(), "0.25");
        }

        TEST_F(RangedParamTest, AValueOutOfRangeIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            EXPECT_FALSE(parameter_.setValue("1.5"));
            EXPECT_FALSE(parameter_.setValue("nan"));
            EXPECT_EQ(value_, 0.5);
            EXPECT_TRUE(console.mentions("share = 1.5: accepted is 0 to 1"));
        }

        TEST_F(RangedParamTest, ANegativeNumberIsNoLargeUnsignedOne)
        {
            unsigned int count = 3;
            RangedParam<unsigned int> parameter(
                "count", AcceptedValues<unsigned int>(0, 1, 4294967295),
                [&count](const unsigned int &value) { count = value; }, [&count] { return count; });
            const test::ConsoleRecord console;
            EXPECT_FALSE(parameter.setValue("-1"));
            EXPECT_EQ(count, 3U);
            EXPECT_TRUE(parameter.setValue("4294967295"));
        }

        TEST_F(RangedParamTest, AValueOfAnotherTypeIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            for (const char *value : {"", "much", "0.5x", "0,5"})
            {
                EXPECT_FALSE(parameter_.setValue(value)) << value;
            }
            EXPECT_EQ(value_, 0.5);
            EXPECT_TRUE(console.mentions("much"));
            EXPECT_TRUE(console.mentions("0 to 1"));
        }
    }  // namespace
}  // namespace ompl_mfa::planner
