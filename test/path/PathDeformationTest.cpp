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

#include "path/PathDeformation.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* The plane [-10, 10]^2 with a disc of radius 2 in its middle. */
        class PathDeformationTest : public ::testing::Test
        {
        protected:
            static bool outsideDisc(const ob::State *state)
            {
                const double *x = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return x[0] * x[0] + x[1] * x[1] > 4.0;
            }

            Waypoints path(const std::vector<std::pair<double, double>> &points) const
            {
                return test::planarPath(space_, points);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, outsideDisc};
            PathEvaluator evaluator_{problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
        };

        TEST_F(PathDeformationTest, PathsOnTheSameSideAreOfOneClass)
        {
            EXPECT_TRUE(seemDeformable(evaluator_, path({{-8, 0}, {0, 4}, {8, 0}}),
                                       path({{-8, 0}, {-4, 6}, {4, 6}, {8, 0}}), 7));
        }

        TEST_F(PathDeformationTest, PathsOnEitherSideAreNot)
        {
            EXPECT_FALSE(
                seemDeformable(evaluator_, path({{-8, 0}, {0, 4}, {8, 0}}), path({{-8, 0}, {0, -4}, {8, 0}}), 7));
        }

        TEST_F(PathDeformationTest, APathIsOfItsOwnClassWhateverItsVertices)
        {
            const Waypoints few = path({{-8, 0}, {0, 4}, {8, 0}});
            EXPECT_TRUE(seemDeformable(evaluator_, few, few, 9));
            EXPECT_TRUE(seemDeformable(evaluator_, few, path({{-8, 0}, {-8, 0}, {-4, 2}, {0, 4}, {8, 0}}), 9));
        }
    }  // namespace
}  // namespace ompl_mfa::path
