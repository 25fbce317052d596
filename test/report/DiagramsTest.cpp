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

#include "report/Diagrams.h"

#include <gtest/gtest.h>

namespace ompl_mfa::report
{
    namespace
    {
        using Groups = std::vector<std::pair<std::size_t, std::size_t>>;
    }  // namespace

    TEST(DiagramsTest, GroupsAreMaximal)
    {
        EXPECT_EQ(indifferentGroups({1.0, 1.5, 2.2, 4.0, 4.5}, 1.25), (Groups{{0, 2}, {3, 4}}));
        EXPECT_EQ(indifferentGroups({1.0, 2.0, 3.0}, 1.0), (Groups{{0, 1}, {1, 2}}));
        EXPECT_EQ(indifferentGroups({1.0, 2.0, 3.0}, 0.5), Groups());
        EXPECT_EQ(indifferentGroups({1.0, 2.0, 3.0}, 5.0), (Groups{{0, 2}}));
    }

    TEST(DiagramsTest, DiagramNamesEveryPlannerAndEscapes)
    {
        Comparison comparison;
        comparison.planners = {"a<b", "c"};
        Ranking ranking;
        ranking.measure = "final cost";
        ranking.test.meanRanks = {1.75, 1.25};
        ranking.criticalDifference = 0.98;
        ranking.order = {1, 0};
        const std::string svg = rankDiagram(comparison, ranking);
        EXPECT_NE(svg.find("a&lt;b (1.75)"), std::string::npos) << svg;
        EXPECT_NE(svg.find("c (1.25)"), std::string::npos) << svg;
        EXPECT_NE(svg.find("critical difference 0.980"), std::string::npos) << svg;
        // the two do not differ: one thick bar
        EXPECT_NE(svg.find("stroke-width=\"4.0\""), std::string::npos) << svg;
        ranking.criticalDifference = 0.1;
        EXPECT_EQ(rankDiagram(comparison, ranking).find("stroke-width=\"4.0\""), std::string::npos);
    }
}  // namespace ompl_mfa::report
