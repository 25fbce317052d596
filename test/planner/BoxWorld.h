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

#ifndef OMPL_MFA_TEST_PLANNER_BOX_WORLD_
#define OMPL_MFA_TEST_PLANNER_BOX_WORLD_

/* A world that tests change between two solves. */

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"

namespace ompl_mfa::test
{
    struct Box
    {
        double left, right, bottom, top;

        bool contains(double x, double y) const
        {
            return x > left && x < right && y > bottom && y < top;
        }
    };

    /** \brief The square [0, 10]^2 with boxes that the tests add and remove; from (1, 5) to (9, 5). */
    struct BoxWorld
    {
        std::vector<Box> boxes;
        PlanningProblem problem{realVectorSpace(2, 0.0, 10.0),
                                [this](const ompl::base::State *s)
                                {
                                    return std::none_of(boxes.begin(), boxes.end(),
                                                        [s](const Box &box)
                                                        { return box.contains(coordinate(s, 0), coordinate(s, 1)); });
                                },
                                {1.0, 5.0},
                                {9.0, 5.0}};

        ompl::geometric::PathGeometric &path() const
        {
            return problem.path();
        }

        /** \brief Whether the reported solution is valid now, from the present start to the present goal, and of the
           reported cost. */
        void expectSolution(const MFA &planner, const std::string &what = "") const
        {
            ASSERT_TRUE(problem.pdef->hasExactSolution()) << what;
            EXPECT_TRUE(path().check()) << what;
            EXPECT_TRUE(problem.si->isValid(path().getState(0))) << what;
            EXPECT_TRUE(problem.si->equalStates(path().getState(0), problem.pdef->getStartState(0))) << what;
            EXPECT_TRUE(problem.pdef->getGoal()->isSatisfied(path().getState(path().getStateCount() - 1))) << what;
            EXPECT_NEAR(path().length(), planner.bestCost(), 1e-9) << what;
            EXPECT_EQ(problem.reportedCost(), planner.bestCost()) << what;
        }

        void moveStart(const std::vector<double> &to) const
        {
            problem.pdef->clearStartStates();
            problem.pdef->addStartState(problem.state(to));
        }
    };

    /** \brief Four walls with openings alternately at the bottom and at the top. */
    inline std::vector<Box> corridors()
    {
        return {{2.0, 2.5, 1.0, 11.0}, {4.0, 4.5, -1.0, 9.0}, {6.0, 6.5, 1.0, 11.0}, {7.5, 8.0, -1.0, 9.0}};
    }
}  // namespace ompl_mfa::test

#endif
