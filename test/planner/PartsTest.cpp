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

/* Which parts of the search a user switches on and off, and what is reported of their work. */

#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        class Parts : public ::testing::Test
        {
        protected:
            std::shared_ptr<MFA> planner(const std::map<std::string, std::string> &parameters) const
            {
                auto result = problem_->planner(test::PlannerVariant::Default);
                for (const auto &[name, value] : parameters)
                {
                    test::set(*result, name, value);
                }
                return result;
            }

            /* The progress properties "share of <part> REAL", by part. */
            static std::map<std::string, double> shares(const MFA &planner)
            {
                const std::string before = "share of ";
                const std::string behind = " REAL";
                std::map<std::string, double> result;
                for (const auto &[name, value] : planner.getPlannerProgressProperties())
                {
                    if (name.rfind(before, 0) == 0)
                    {
                        result[name.substr(before.size(), name.size() - before.size() - behind.size())] =
                            std::stod(value());
                    }
                }
                return result;
            }

            static double sum(const std::map<std::string, double> &shares)
            {
                double result = 0.0;
                for (const auto &share : shares)
                {
                    result += share.second;
                }
                return result;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        TEST_F(Parts, TheSharesOfAllPartsAddUpToTheWholeWork)
        {
            const auto mfa = planner({});
            EXPECT_EQ(sum(shares(*mfa)), 0.0);
            mfa->solve(test::afterCalls(60000));
            const auto told = shares(*mfa);
            EXPECT_EQ(told.size(), 7U);
            EXPECT_NEAR(sum(told), 1.0, 1e-5);
            // recombination ends with the first path
            for (const char *part : {"fireflies", "tightening", "trees", "roadmap"})
            {
                EXPECT_GT(told.at(part), 0.0) << part;
            }
            EXPECT_EQ(told.at("guide planner"), 0.0);
            EXPECT_EQ(told.at("goal search"), 0.0);
            const auto asked = mfa->shares();
            ASSERT_EQ(asked.size(), told.size());
            for (const auto &[part, share] : told)
            {
                EXPECT_NEAR(asked.at(part), share, 1e-5) << part;
            }
            mfa->clear();
            EXPECT_EQ(sum(shares(*mfa)), 0.0);
        }

        TEST_F(Parts, WithoutFirefliesTheGuidesSolve)
        {
            for (const char *guide : {"trees", "roadmap", "both"})
            {
                problem_->pdef->clearSolutionPaths();
                const auto mfa = planner({{"fireflies", "0"}, {"guide", guide}});
                ASSERT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION) << guide;
                mfa->solve(test::afterCalls(60000));
                EXPECT_TRUE(problem_->path().check());
                EXPECT_LT(mfa->bestCost(), 1.02 * test::wallOptimum()) << guide;
                const auto told = shares(*mfa);
                EXPECT_EQ(told.at("fireflies"), 0.0);
                EXPECT_EQ(told.at("recombination"), 0.0) << "there is nothing to splice";
                EXPECT_NEAR(sum(told), 1.0, 1e-5);
                EXPECT_EQ(mfa->iterations(), 0U);
                EXPECT_TRUE(mfa->getSwarmPaths().empty());
                EXPECT_TRUE(mfa->getSlicePaths().empty());
                ob::PlannerData data(problem_->si);
                mfa->getPlannerData(data);
                EXPECT_GT(data.numVertices(), 2U);
            }
        }

        TEST_F(Parts, EachThatFindsPathsSolvesAlone)
        {
            const std::map<std::string, std::map<std::string, std::string>> alone{
                {"fireflies", {{"fireflies", "1"}, {"guide", "none"}}},
                {"trees", {{"fireflies", "0"}, {"guide", "trees"}}},
                {"roadmap", {{"fireflies", "0"}, {"guide", "roadmap"}}},
                {"guide planner", {{"fireflies", "0"}, {"guide", "none"}}}};
            for (auto [part, parameters] : alone)
            {
                parameters["recombination"] = parameters["tightening"] = "0";
                problem_->pdef->clearSolutionPaths();
                const auto mfa = planner(parameters);
                if (part == "guide planner")
                {
                    mfa->setGuidePlanner([](const ob::SpaceInformationPtr &si) -> ob::PlannerPtr
                                         { return std::make_shared<ompl::geometric::RRTConnect>(si); });
                }
                ASSERT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION) << part;
                EXPECT_TRUE(problem_->path().check()) << part;
                EXPECT_DOUBLE_EQ(shares(*mfa).at(part), 1.0);
            }
        }

        TEST_F(Parts, OneOfThemHasToFindPaths)
        {
            const auto mfa = planner({{"fireflies", "0"}, {"guide", "none"}});
            EXPECT_THROW(mfa->solve(test::afterCalls(2000)), ompl::Exception);
            EXPECT_FALSE(problem_->pdef->hasSolution());
            EXPECT_THROW(mfa->solve(test::afterCalls(2000)), ompl::Exception);
            ob::PlannerData data(problem_->si);
            mfa->getPlannerData(data);
            EXPECT_EQ(data.numVertices(), 0U);
            mfa->setGuide("trees");
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
