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

#include "benchmark/ObjectiveFactory.h"

#include <cmath>
#include <limits>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <gtest/gtest.h>

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        /* Valid everywhere; the clearance is x, and infinite above 5. */
        class ClearanceIsX : public ob::StateValidityChecker
        {
        public:
            using StateValidityChecker::StateValidityChecker;

            bool isValid(const ob::State * /*state*/) const override
            {
                return true;
            }

            double clearance(const ob::State *state) const override
            {
                const double x = state->as<ob::RealVectorStateSpace::StateType>()->values[0];
                return x > 5.0 ? std::numeric_limits<double>::infinity() : x;
            }
        };

        class ObjectiveFactory : public testing::Test
        {
        protected:
            ObjectiveFactory()
            {
                auto space = std::make_shared<ob::RealVectorStateSpace>(2);
                space->setBounds(0.0, 10.0);
                si_ = std::make_shared<ob::SpaceInformation>(space);
                si_->setStateValidityChecker(std::make_shared<ClearanceIsX>(si_));
                si_->setup();
            }

            ob::OptimizationObjectivePtr make(ObjectiveKind kind) const
            {
                ProblemConfig problem;
                problem.objective = kind;
                return makeObjective(si_, problem);
            }

            double cost(const ob::OptimizationObjectivePtr &objective, double x0, double y0, double x1, double y1) const
            {
                ob::ScopedState<ob::RealVectorStateSpace> from(si_);
                ob::ScopedState<ob::RealVectorStateSpace> to(si_);
                from[0] = x0;
                from[1] = y0;
                to[0] = x1;
                to[1] = y1;
                ompl::geometric::PathGeometric path(si_, from.get(), to.get());
                return path.cost(objective).value();
            }

            ob::SpaceInformationPtr si_;
        };

        TEST_F(ObjectiveFactory, NoObjectiveWhereTheConfigNamesNone)
        {
            EXPECT_FALSE(makeObjective(si_, ProblemConfig()));
        }

        TEST_F(ObjectiveFactory, EachNameIsItsOwnObjective)
        {
            EXPECT_NEAR(cost(make(ObjectiveKind::Length), 1, 1, 4, 5), 5.0, 1e-12);
            EXPECT_TRUE(
                std::dynamic_pointer_cast<ob::MaximizeMinClearanceObjective>(make(ObjectiveKind::MaxMinClearance)));
            EXPECT_NEAR(cost(make(ObjectiveKind::MechanicalWork), 1, 1, 4, 5), 5.0 * 1e-5, 1e-9)
                << "OMPL weighs length by 1e-5";
        }

        TEST_F(ObjectiveFactory, ProximityIsTheIntegralOfOneOverOnePlusClearance)
        {
            ProblemConfig problem;
            problem.objective = ObjectiveKind::Weighted;
            problem.objectiveWeights = {{ObjectiveKind::Proximity, 1.0}};
            const auto objective = makeObjective(si_, problem);
            EXPECT_NEAR(cost(objective, 0, 0, 4, 0), std::log(5.0), 5e-3);
            EXPECT_NEAR(cost(objective, 6, 0, 6, 8), 0.0, 1e-12) << "nothing is near where the clearance is infinite";
        }

        TEST_F(ObjectiveFactory, WeightsScaleAndAddTheirTerms)
        {
            ProblemConfig problem;
            problem.objective = ObjectiveKind::Weighted;
            problem.objectiveWeights = {{ObjectiveKind::Length, 2.0}, {ObjectiveKind::Proximity, 3.0}};
            EXPECT_NEAR(cost(makeObjective(si_, problem), 0, 0, 4, 0), 2.0 * 4.0 + 3.0 * std::log(5.0), 1e-2);
        }

        TEST_F(ObjectiveFactory, ThresholdIsTheConfigs)
        {
            ProblemConfig problem;
            problem.objective = ObjectiveKind::Length;
            problem.objectiveThreshold = 7.5;
            EXPECT_EQ(makeObjective(si_, problem)->getCostThreshold().value(), 7.5);
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
