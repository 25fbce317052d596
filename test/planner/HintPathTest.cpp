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

#include "planner/HintPath.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Exception.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        og::PathGeometric randomPath(const ob::StateSpacePtr &space, unsigned int count)
        {
            og::PathGeometric path(std::make_shared<ob::SpaceInformation>(space));
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> state(space);
            for (unsigned int i = 0; i < count; ++i)
            {
                sampler->sampleUniform(state.get());
                path.append(state.get());
            }
            return path;
        }

        std::string refusal(const og::PathGeometric &path, const ob::StateSpacePtr &space)
        {
            try
            {
                hintOf(path, space, "planner");
            }
            catch (const ompl::Exception &exception)
            {
                return exception.what();
            }
            return "";
        }

        class HintPath : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, HintPath, ::testing::ValuesIn(test::supportedSpaces()), test::SpaceName());

        TEST_P(HintPath, HasTheStatesOfThePathInTheSameOrAnEqualSpace)
        {
            const auto space = GetParam().make();
            for (const auto &from : {space, GetParam().make()})
            {
                const og::PathGeometric path = randomPath(from, 5);
                const path::Waypoints hint = hintOf(path, space, "planner");
                ASSERT_EQ(hint.size(), 5U);
                for (unsigned int i = 0; i < 5; ++i)
                {
                    std::vector<double> expected;
                    std::vector<double> values;
                    from->copyToReals(expected, path.getState(i));
                    space->copyToReals(values, hint[i]);
                    EXPECT_EQ(values, expected);
                }
            }
        }

        TEST_P(HintPath, OfASpaceOfAnotherStructureIsRefused)
        {
            const auto space = GetParam().make();
            for (const test::NamedSpace &other : test::supportedSpaces())
            {
                const auto from = other.make();
                std::vector<int> a;
                std::vector<int> b;
                space->computeSignature(a);
                from->computeSignature(b);
                EXPECT_EQ(refusal(randomPath(from, 2), space).empty(), a == b) << other.name;
            }
        }

        TEST(HintPaths, NumbersThatAreNotFiniteAreRefused)
        {
            const auto space = test::se2Space();
            for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL})
            {
                for (unsigned int i = 0; i < 3; ++i)
                {
                    og::PathGeometric path = randomPath(space, 4);
                    *space->getValueAddressAtIndex(path.getState(2), i) = wrong;
                    EXPECT_NE(refusal(path, space).find("state 2 "), std::string::npos);
                }
            }
        }

        TEST(HintPaths, OfNoStatesAreRefused)
        {
            const auto space = test::se2Space();
            EXPECT_NE(refusal(randomPath(space, 0), space), "");
            EXPECT_EQ(refusal(randomPath(space, 1), space), "");
        }

        TEST(HintPaths, TheRefusalNamesBothSpaces)
        {
            const auto from = test::realVectorSpace(3);
            const auto space = test::realVectorSpace(2);
            from->setName("workshop");
            space->setName("office");
            const std::string text = refusal(randomPath(from, 2), space);
            EXPECT_NE(text.find("workshop"), std::string::npos);
            EXPECT_NE(text.find("office"), std::string::npos);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
