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

#include "ompl_mfa/collision/FclStateValidityChecker.h"

#include "collision/OmplAppProblems.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST_P(OmplAppTest, AgreesWithTheReferenceOnEveryState)
        {
            const OmplAppProblem &problem = GetParam();
            const OmplAppWorld world(problem);
            const std::vector<std::vector<double>> rows =
                readRows(omplAppFolder() / "samples" / (std::string(problem.name) + ".samples"));
            ASSERT_EQ(rows.size(), 2000U);
            const std::size_t coordinates = problem.planar ? 3 : 7;
            int compared = 0;
            for (const std::vector<double> &row : rows)
            {
                const ob::ScopedState<> state = world.state(row);
                const bool valid = row[coordinates] != 0.;
                EXPECT_EQ(world.checker()->isValid(state.get()), valid) << ::testing::PrintToString(row);
                if (row.size() > coordinates + 1)
                {
                    ++compared;
                    EXPECT_NEAR(world.checker()->clearance(state.get()), row[coordinates + 1], 1e-6 * problem.scale())
                        << ::testing::PrintToString(row);
                }
            }
            EXPECT_EQ(compared, 200);
        }

        INSTANTIATE_TEST_SUITE_P(OmplApp, OmplAppTest, ::testing::ValuesIn(omplAppProblems()), problemName);
    }  // namespace
}  // namespace ompl_mfa::collision
