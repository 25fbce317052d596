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

#include "planner/AcceptedValues.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace ompl_mfa::planner
{
    namespace
    {
        TEST(AcceptedValues, AnIntervalHasBothEndsAndAtMostOneNumberApart)
        {
            const AcceptedValues<unsigned int> sizes(4, 1, 10000, 0);
            for (const unsigned int size : {0U, 4U, 5U, 10000U})
            {
                EXPECT_TRUE(sizes.contains(size)) << size;
            }
            for (const unsigned int size : {1U, 3U, 10001U, 4294967295U})
            {
                EXPECT_FALSE(sizes.contains(size)) << size;
            }
            EXPECT_EQ(sizes.suggestion(), "0:1:10000");
            EXPECT_EQ(sizes.description(), "0, 4 to 10000");
        }

        TEST(AcceptedValues, NoIntervalHoldsWhatIsNoNumberOrInfinite)
        {
            const AcceptedValues<double> shares(-1.0, 0.125, 2.5);
            EXPECT_TRUE(shares.contains(-1.0));
            EXPECT_TRUE(shares.contains(2.5));
            for (const double value : {std::nextafter(-1.0, -2.0), std::nextafter(2.5, 3.0),
                                       std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL})
            {
                EXPECT_FALSE(shares.contains(value)) << value;
            }
            EXPECT_EQ(shares.suggestion(), "-1.0:0.125:2.5") << "OMPL reads 2 as an integer";
            EXPECT_EQ(shares.description(), "-1 to 2.5");
        }

        TEST(AcceptedValues, WordsAreComparedAsTheyAre)
        {
            const AcceptedValues<std::string> words({"none", "both"});
            EXPECT_TRUE(words.contains("none"));
            EXPECT_TRUE(words.contains("both"));
            for (const char *word : {"", "None", "bot", "none,both"})
            {
                EXPECT_FALSE(words.contains(word)) << word;
            }
            EXPECT_EQ(words.suggestion(), "none,both");
            EXPECT_EQ(words.description(), "none, both");
        }

        TEST(AcceptedValues, ARefusalNamesParameterValueAndWhatIsAccepted)
        {
            try
            {
                require(AcceptedValues<double>(0.0, 0.01, 2.0), "eta", 2.5);
                FAIL() << "accepted";
            }
            catch (const ompl::Exception &error)
            {
                EXPECT_STREQ(error.what(), "eta = 2.5: accepted is 0 to 2");
            }
        }

        TEST(AcceptedValues, NumbersAreWrittenAsPeopleWriteThem)
        {
            using Reals = AcceptedValues<double>;
            EXPECT_EQ(Reals::write(100000.0), "100000");
            EXPECT_EQ(Reals::write(0.001), "0.001");
            EXPECT_EQ(Reals::write(-0.1), "-0.1");
            EXPECT_EQ(Reals::write(0.0), "0");
            EXPECT_EQ(Reals::write(1e300), "1e+300");
            EXPECT_EQ(Reals::write(5e-324), "5e-324");
            EXPECT_EQ(Reals(0.001, 0.001, 1e5).suggestion(), "0.001:0.001:100000.0");
        }

        template <typename T>
        T readBack(T value)
        {
            T read{};
            EXPECT_TRUE(AcceptedValues<T>::read(AcceptedValues<T>::write(value), read)) << value;
            return read;
        }

        RC_GTEST_PROP(AcceptedValuesProperty, EveryFiniteNumberIsReadAsItWasWritten, (double value))
        {
            RC_PRE(std::isfinite(value));
            RC_ASSERT(readBack(value) == value);
        }

        RC_GTEST_PROP(AcceptedValuesProperty, EveryWholeNumberIsReadAsItWasWritten, (unsigned int value, bool on))
        {
            RC_ASSERT(readBack(value) == value);
            RC_ASSERT(readBack(on) == on);
        }

        RC_GTEST_PROP(AcceptedValuesProperty, NoTextIsReadInPart, (std::string text))
        {
            // a number followed by anything else is no number
            RC_PRE(!text.empty() && text.find_first_of("0123456789.eE") == std::string::npos);
            double real = 7.0;
            unsigned int whole = 7;
            RC_ASSERT(!AcceptedValues<double>::read("12" + text, real) && real == 7.0);
            RC_ASSERT(!AcceptedValues<unsigned int>::read("12" + text, whole) && whole == 7);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
