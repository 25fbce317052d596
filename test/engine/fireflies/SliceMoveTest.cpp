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

#include "engine/fireflies/SliceMove.h"

#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Seven fireflies in the plane and a move of which all random numbers are known. */
        class SliceMoveTest : public ::testing::Test
        {
        protected:
            SliceMoveTest()
            {
                move_.brighter = 5;
                move_.others = {1, 4, 2, 3};
                move_.best = 6;
                move_.worst = 0;
                move_.beta = 0.75;
                move_.step = 2.0;
                move_.direction = Eigen::Vector2d(0.5, -1.0);
                move_.lambda = {0.3, 0.6, 0.9};
                move_.mask = Eigen::Vector2d(1.0, 1.0);
            }

            Eigen::VectorXd displacement(SliceMove::Equation equation, double phase = 0.5)
            {
                move_.equation = equation;
                return move_.displacement([this](std::size_t i) { return fireflies_[i]; }, phase);
            }

            /* The firefly that moves is the zero vector. */
            std::vector<Eigen::Vector2d> fireflies_{{7.0, 1.0},  {0.0, 2.0},  {-1.0, 5.0}, {3.0, 3.0},
                                                    {4.0, -2.0}, {-6.0, 8.0}, {1.0, 0.5}};
            SliceMove move_;
        };

        void expectNear(const Eigen::VectorXd &value, double x, double y)
        {
            EXPECT_NEAR(value[0], x, 1e-12);
            EXPECT_NEAR(value[1], y, 1e-12);
        }

        TEST_F(SliceMoveTest, AttractionMovesTowardTheBrighterOneAndByHalfAWave)
        {
            // in the middle of the window the wave has its full height
            expectNear(displacement(SliceMove::Equation::Attraction), 0.75 * -6.0 + 2.0 * 0.5, 0.75 * 8.0 - 2.0);
            // sin(pi / 6) = 1/2
            expectNear(displacement(SliceMove::Equation::Attraction, 1.0 / 6.0), 0.75 * -6.0 + 0.5, 0.75 * 8.0 - 1.0);
            // and none at its ends
            expectNear(displacement(SliceMove::Equation::Attraction, 1.0), 0.75 * -6.0, 0.75 * 8.0);
        }

        TEST_F(SliceMoveTest, MutationAddsTwoDifferencesToAnotherFirefly)
        {
            expectNear(displacement(SliceMove::Equation::Mutation), 0.0 + 0.3 * (4.0 + 1.0) + 0.6 * (-1.0 - 3.0),
                       2.0 + 0.3 * (-2.0 - 5.0) + 0.6 * (5.0 - 3.0));
        }

        TEST_F(SliceMoveTest, BestMutationAddsTheDifferenceOfBestAndWorst)
        {
            const Eigen::VectorXd mutation = displacement(SliceMove::Equation::Mutation);
            expectNear(displacement(SliceMove::Equation::BestMutation), mutation[0] + 0.9 * (1.0 - 7.0),
                       mutation[1] + 0.9 * (0.5 - 1.0));
        }

        TEST_F(SliceMoveTest, WorstMovesBetweenTheWorstAndTheBest)
        {
            expectNear(displacement(SliceMove::Equation::Worst), 0.3 * 7.0 + 0.6 * (1.0 - 7.0),
                       0.3 * 1.0 + 0.6 * (0.5 - 1.0));
        }

        TEST_F(SliceMoveTest, CoordinatesThatTheMaskLeavesOutStay)
        {
            for (const auto equation : {SliceMove::Equation::Attraction, SliceMove::Equation::Mutation,
                                        SliceMove::Equation::BestMutation, SliceMove::Equation::Worst})
            {
                move_.mask = Eigen::Vector2d(1.0, 1.0);
                const Eigen::VectorXd all = displacement(equation);
                move_.mask = Eigen::Vector2d(0.0, 1.0);
                expectNear(displacement(equation), 0.0, all[1]);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
