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

#ifndef OMPL_MFA_TEST_PLANNER_QUERIES_FIXTURE_
#define OMPL_MFA_TEST_PLANNER_QUERIES_FIXTURE_

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/PlannerStatus.h>
#include <ompl/geometric/PathGeometric.h>

#include "planner/PlanningProblem.h"

namespace ompl_mfa::planner
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    class Queries : public ::testing::TestWithParam<test::PlannerVariant>
    {
    protected:
        ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc)
        {
            planner_ = problem_->planner(GetParam());
            return planner_->solve(ptc);
        }

        ob::PlannerStatus solve()
        {
            return solve(test::untilExact(problem_->pdef));
        }

        /* The solution as the problem definition has it. */
        og::PathGeometric &path() const
        {
            return *problem_->pdef->getSolutionPath()->as<og::PathGeometric>();
        }

        const ob::State *pathEnd() const
        {
            return path().getState(path().getStateCount() - 1);
        }

        void expectExact(const ob::PlannerStatus &status)
        {
            ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(problem_->pdef->hasExactSolution());
            EXPECT_TRUE(path().check());
            EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(pathEnd()));
        }

        std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        std::shared_ptr<MFA> planner_;
    };
}  // namespace ompl_mfa::planner

#endif
