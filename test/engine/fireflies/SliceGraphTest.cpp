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

#include "engine/fireflies/SliceGraph.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        double coordinate(const ob::State *state, unsigned int i)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[i];
        }

        /* The higher the target state, the lower the cost of a motion, down to negative ones; OMPL's default heuristic
           does not allow for that. */
        class Earning : public ob::OptimizationObjective
        {
        public:
            using OptimizationObjective::OptimizationObjective;

            ob::Cost stateCost(const ob::State *) const override
            {
                return identityCost();
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(si_->distance(from, to) - 4.0 * coordinate(to, 1));
            }
        };

        /* From (-8, 0) to (8, 0) over three slices, with candidates at the heights -6, -3, 0, 3, 6 on each. */
        class SliceGraphTest : public ::testing::Test
        {
        protected:
            ob::ScopedState<> state(double x, double y) const
            {
                ob::ScopedState<> result(space_);
                result[0] = x;
                result[1] = y;
                return result;
            }

            bool search(const ob::OptimizationObjectivePtr &objective, double bound)
            {
                evaluator_ = std::make_unique<path::PathEvaluator>(problem_.si, objective);
                path::Waypoints known(space_);
                for (const auto &[x, y] : std::vector<std::pair<double, double>>{
                         {-8.0, 0.0}, {-4.0, 3.0}, {0.0, 3.0}, {4.0, 3.0}, {8.0, 0.0}})
                {
                    known.append(state(x, y).get());
                }
                // bounds come from paths that were found
                EXPECT_GT(evaluator_->cost(known).value(), bound - 1e-6);
                SliceGraph graph(frame_, *evaluator_);
                for (std::size_t k = 0; k < frame_.slices(); ++k)
                {
                    for (const double y : {-6.0, -3.0, 0.0, 3.0, 6.0})
                    {
                        graph.addCandidate(k, state(-4.0 + 4.0 * static_cast<double>(k), y).get());
                    }
                }
                return graph.search(bound, 100000, path_);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            // a wall across the straight path
            test::CountingProblem problem_{
                space_, [](const ob::State *s) { return std::abs(coordinate(s, 0)) > 1.0 || coordinate(s, 1) > 1.0; }};
            SliceFrame frame_ = SliceFrame::straight(std::make_shared<const path::StateChart>(space_),
                                                     state(-8.0, 0.0).get(), state(8.0, 0.0).get(), 4);
            std::unique_ptr<path::PathEvaluator> evaluator_;
            path::Waypoints path_{space_};
        };

        TEST_F(SliceGraphTest, FindsTheShortestValidWayThroughTheCandidates)
        {
            ASSERT_TRUE(search(std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si), 18.0 + 1e-9));
            ASSERT_EQ(path_.size(), 5U);
            EXPECT_TRUE(evaluator_->checkPath(path_));
            EXPECT_EQ(coordinate(path_[2], 1), 3.0);
            EXPECT_NEAR(evaluator_->cost(path_).value(), 4.0 + 5.0 + 5.0 + 4.0, 1e-9);
        }

        TEST_F(SliceGraphTest, FindsNothingThatIsNoBetterThanTheBound)
        {
            EXPECT_FALSE(search(std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si), 17.9));
        }

        TEST_F(SliceGraphTest, PrunesNothingWhereCostsBeatTheHeuristic)
        {
            // along the top: 6 upward and downward on slopes of 4, and three states of height 6
            const double best = 2.0 * std::hypot(4.0, 6.0) + 8.0 - 4.0 * 18.0;
            ASSERT_TRUE(search(std::make_shared<Earning>(problem_.si), best + 1.0));
            EXPECT_NEAR(evaluator_->cost(path_).value(), best, 1e-9);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
