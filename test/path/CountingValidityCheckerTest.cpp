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

#include "path/CountingValidityChecker.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ompl_mfa::test
{
    namespace
    {
        namespace ob = ompl::base;

        /* Answers each of the five queries differently. */
        class Witness : public ob::StateValidityChecker
        {
        public:
            explicit Witness(const ob::SpaceInformationPtr &si)
              : StateValidityChecker(si)
            {
                specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
                specs_.hasValidDirectionComputation = true;
            }

            bool isValid(const ob::State * /*state*/) const override
            {
                return true;
            }

            bool isValid(const ob::State * /*state*/, double &distance) const override
            {
                distance = 2.0;
                return false;
            }

            bool isValid(const ob::State * /*state*/, double &distance, ob::State * /*validState*/,
                         bool &available) const override
            {
                distance = 3.0;
                available = true;
                return true;
            }

            double clearance(const ob::State * /*state*/) const override
            {
                return 4.0;
            }

            double clearance(const ob::State * /*state*/, ob::State * /*validState*/, bool &available) const override
            {
                available = true;
                return 5.0;
            }
        };

        class CountingValidityCheckerTest : public testing::Test
        {
        protected:
            CountingValidityCheckerTest()
              : si_(std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2)))
              , state_(si_)
            {
            }

            ob::SpaceInformationPtr si_;
            ob::ScopedState<> state_;
        };

        TEST_F(CountingValidityCheckerTest, PassesEveryQuestionOnAndCountsChecksOnce)
        {
            const path::CountingValidityChecker checker(si_, std::make_shared<Witness>(si_));
            double distance = 0.0;
            bool available = false;
            EXPECT_TRUE(checker.isValid(state_.get()));
            EXPECT_EQ(checker.checks(), 1u);
            EXPECT_FALSE(checker.isValid(state_.get(), distance));
            EXPECT_EQ(distance, 2.0);
            EXPECT_EQ(checker.checks(), 2u);
            EXPECT_TRUE(checker.isValid(state_.get(), distance, state_.get(), available));
            EXPECT_EQ(distance, 3.0);
            EXPECT_TRUE(available);
            EXPECT_EQ(checker.checks(), 3u);
            EXPECT_EQ(checker.clearance(state_.get()), 4.0);
            available = false;
            EXPECT_EQ(checker.clearance(state_.get(), state_.get(), available), 5.0);
            EXPECT_TRUE(available);
            EXPECT_EQ(checker.checks(), 3u) << "a distance is no check";
        }

        TEST_F(CountingValidityCheckerTest, HasTheSpecsOfTheCheckerThatItCounts)
        {
            const path::CountingValidityChecker checker(si_, std::make_shared<Witness>(si_));
            EXPECT_EQ(checker.getSpecs().clearanceComputationType, ob::StateValidityCheckerSpecs::EXACT);
            EXPECT_TRUE(checker.getSpecs().hasValidDirectionComputation);
        }

        TEST_F(CountingValidityCheckerTest, CountsWhereItIsToldTo)
        {
            std::atomic<std::uint64_t> count{7};
            const path::CountingValidityChecker checker(si_, std::make_shared<Witness>(si_), count);
            checker.isValid(state_.get());
            EXPECT_EQ(count, 8u);
            EXPECT_EQ(checker.checks(), 8u);
            count = 0;
            EXPECT_EQ(checker.checks(), 0u);
        }

        TEST_F(CountingValidityCheckerTest, MissesNoCheckOfAnyThread)
        {
            constexpr std::uint64_t CHECKS = 20000;
            const path::CountingValidityChecker checker(si_, std::make_shared<Witness>(si_));
            std::vector<std::thread> threads;
            for (int i = 0; i < 4; ++i)
            {
                threads.emplace_back(
                    [&]
                    {
                        for (std::uint64_t k = 0; k < CHECKS; ++k)
                        {
                            checker.isValid(state_.get());
                        }
                    });
            }
            for (std::thread &thread : threads)
            {
                thread.join();
            }
            EXPECT_EQ(checker.checks(), 4 * CHECKS);
        }
    }  // namespace
}  // namespace ompl_mfa::test
