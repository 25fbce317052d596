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

/* Several threads give the same results and counts as one. */

#include "path/ParallelChecks.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/RandomNumbers.h>

#include "path/PathEvaluator.h"
#include "path/SlowProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* The square [0, 10]^2 with a wall 4.5 < x < 5.5 below y = 6; threads share whole motions or single states. */
        class ParallelChecksTest : public ::testing::TestWithParam<bool>
        {
        protected:
            static bool outsideWall(const ob::State *state)
            {
                const auto *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return values[0] <= 4.5 || values[0] >= 5.5 || values[1] >= 6.0;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2, 0.0, 10.0);
            test::SlowProblem problem_{space_, GetParam(), std::chrono::microseconds(5), outsideWall};
        };

        struct ValidatorName
        {
            std::string operator()(const ::testing::TestParamInfo<bool> &wholeMotions) const
            {
                return wholeMotions.param ? "WholeMotions" : "States";
            }
        };

        INSTANTIATE_TEST_SUITE_P(Path, ParallelChecksTest, ::testing::Bool(), ValidatorName());

        struct Answers
        {
            std::vector<double> values;
            std::uint64_t asked{0};
        };

        /* Checks 60 random paths, with rivals and without, until the stop condition ends it; as drafts with a \e stride
           above 1. */
        Answers answers(const ob::SpaceInformationPtr &si, unsigned int threads, std::uint64_t stopAfter,
                        unsigned int stride = 1)
        {
            PathEvaluator evaluator(si, std::make_shared<ob::PathLengthOptimizationObjective>(si), threads);
            evaluator.setStride(stride);
            Answers result;
            evaluator.setStopCondition([&] { return ++result.asked > stopAfter; });
            ompl::RNG rng(42);
            Waypoints path(si->getStateSpace());
            const Brightness feasible{0.0, 15.0};
            const Brightness blocked{1.5, 10.0};
            for (int i = 0; i < 60; ++i)
            {
                path.resize(static_cast<std::size_t>(rng.uniformInt(2, 7)));
                for (std::size_t k = 0; k < path.size(); ++k)
                {
                    auto *values = path[k]->as<ob::RealVectorStateSpace::StateType>()->values;
                    values[0] = rng.uniformReal(0.0, 4.4) + (i % 2 == 0 && k > 1 ? 5.6 : 0.0);
                    values[1] = rng.uniformReal(4.0, 10.0);
                }
                const Brightness *rival = i % 3 == 0 ? nullptr : (i % 3 == 1 ? &feasible : &blocked);
                const Brightness brightness = evaluator.evaluate(path, rival);
                result.values.push_back(brightness.violation);
                result.values.push_back(brightness.cost);
                result.values.push_back(evaluator.checkPath(path) ? 1.0 : 0.0);
                result.values.push_back(evaluator.checkMotion(path.front(), path.back()) ? 1.0 : 0.0);
                result.values.push_back(evaluator.screenMotion(path.front(), path.back(), 3) ? 1.0 : 0.0);
                result.values.push_back(static_cast<double>(evaluator.work()));
            }
            return result;
        }

        TEST_P(ParallelChecksTest, AnswersAndWorkAreThoseOfOneThread)
        {
            for (const std::uint64_t stopAfter : {100000U, 57U, 200U})
            {
                const Answers one = answers(problem_.si, 1, stopAfter);
                for (const unsigned int threads : {2U, 3U, 5U})
                {
                    const Answers several = answers(problem_.si, threads, stopAfter);
                    EXPECT_EQ(several.values, one.values) << threads << " threads, stopped after " << stopAfter;
                    EXPECT_EQ(several.asked, one.asked) << threads << " threads, stopped after " << stopAfter;
                }
            }
            EXPECT_LE(problem_.mostInside, 5U);
        }

        TEST_P(ParallelChecksTest, AnswersAndWorkOfDraftsAreThoseOfOneThread)
        {
            const Answers full = answers(problem_.si, 1, 100000);
            for (const unsigned int stride : {2U, 5U})
            {
                for (const std::uint64_t stopAfter : {100000U, 57U})
                {
                    const Answers one = answers(problem_.si, 1, stopAfter, stride);
                    EXPECT_NE(one.values, full.values);
                    for (const unsigned int threads : {2U, 4U})
                    {
                        const Answers several = answers(problem_.si, threads, stopAfter, stride);
                        EXPECT_EQ(several.values, one.values) << threads << " threads, stopped after " << stopAfter;
                        EXPECT_EQ(several.asked, one.asked) << threads << " threads, stopped after " << stopAfter;
                    }
                }
            }
        }

        TEST_P(ParallelChecksTest, OneThreadIsNeverJoinedByAnother)
        {
            answers(problem_.si, 1, 100000);
            EXPECT_EQ(problem_.mostInside, 1U);
        }

        TEST_P(ParallelChecksTest, OfAValidPathNoStateIsCheckedTwice)
        {
            PathEvaluator evaluator(problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si), 3);
            Waypoints path(space_);
            path.resize(6);
            for (std::size_t k = 0; k < path.size(); ++k)
            {
                auto *values = path[k]->as<ob::RealVectorStateSpace::StateType>()->values;
                values[0] = k % 2 == 0 ? 0.5 : 9.5;
                values[1] = 7.0 + 0.5 * static_cast<double>(k);
            }
            const std::uint64_t states = problem_.states;
            EXPECT_TRUE(evaluator.checkPath(path));
            EXPECT_EQ(problem_.states - states, evaluator.work());
        }

        TEST_P(ParallelChecksTest, AnExceptionOfTheCheckerReachesTheCaller)
        {
            const auto caller = std::this_thread::get_id();
            test::SlowProblem failing(space_, GetParam(), std::chrono::microseconds(50),
                                      [caller](const ob::State *)
                                      {
                                          if (std::this_thread::get_id() != caller)
                                          {
                                              throw std::domain_error("not here");
                                          }
                                          return true;
                                      });
            PathEvaluator evaluator(failing.si, std::make_shared<ob::PathLengthOptimizationObjective>(failing.si), 3);
            Waypoints path(space_);
            path.resize(4);
            for (std::size_t k = 0; k < path.size(); ++k)
            {
                auto *values = path[k]->as<ob::RealVectorStateSpace::StateType>()->values;
                values[0] = k % 2 == 0 ? 0.5 : 9.5;
                values[1] = static_cast<double>(k);
            }
            const auto checkUntilAWorkerHelps = [&]
            {
                for (int i = 0; i < 10000; ++i)
                {
                    evaluator.checkPath(path);
                }
            };
            EXPECT_THROW(checkUntilAWorkerHelps(), std::domain_error);
        }
    }  // namespace
}  // namespace ompl_mfa::path
