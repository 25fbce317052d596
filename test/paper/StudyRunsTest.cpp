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

#include "paper/StudyRuns.h"

#include <csignal>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <unistd.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::paper
{
    namespace
    {
        class StudyRuns : public testing::Test
        {
        protected:
            StudyRuns()
            {
                options_.outputFolder = testing::TempDir() + "study_runs_" + std::to_string(getpid());
                std::filesystem::create_directories(options_.outputFolder);
            }

            ~StudyRuns() override
            {
                std::filesystem::remove_all(options_.outputFolder);
            }

            /* Runs 1 to \e count; each returns the ids of its process and of its parent. */
            static std::vector<StudyRun> runs(unsigned int count)
            {
                std::vector<StudyRun> all;
                for (unsigned int run = 1; run <= count; ++run)
                {
                    all.push_back({{{"algorithm", "mfa"}, {"run", run}}, [] {
                                       return Json{{"process", getpid()}, {"parent", getppid()}};
                                   }});
                }
                return all;
            }

            StudyOptions options_;
        };
    }  // namespace

    TEST_F(StudyRuns, ComeBackInTheirOrderFromAProcessEach)
    {
        options_.jobs = 3;
        const std::vector<Json> results = makeStudyRuns(options_, "part", "", runs(9));
        ASSERT_EQ(results.size(), 9U);
        for (std::size_t i = 0; i < results.size(); ++i)
        {
            EXPECT_EQ(results[i].at("run"), i + 1);
            EXPECT_EQ(results[i].at("parent"), getpid());
            EXPECT_NE(results[i].at("process"), getpid());
        }
        EXPECT_NE(results[0].at("process"), results[1].at("process"));
    }

    TEST_F(StudyRuns, AreMadeOnceWhereTheStudyIsResumed)
    {
        const std::vector<Json> before = makeStudyRuns(options_, "part", "a", runs(3));
        EXPECT_THROW(makeStudyRuns(options_, "part", "a", runs(5)), InputError);
        options_.resume = true;
        const std::vector<Json> after = makeStudyRuns(options_, "part", "a", runs(5));
        ASSERT_EQ(after.size(), 5U);
        EXPECT_EQ(after[2], before[2]);
        EXPECT_EQ(makeStudyRuns(options_, "part", "a", runs(2)).size(), 2U)
            << "runs that were not requested are left out";
        EXPECT_THROW(makeStudyRuns(options_, "part", "b", runs(5)), InputError);
        EXPECT_EQ(makeStudyRuns(options_, "other", "b", runs(5)).size(), 5U) << "each part has its own journal";
    }

    TEST_F(StudyRuns, EndTheStudyWhereOneDoesNotReturn)
    {
        std::vector<StudyRun> all = runs(3);
        all[1].make = []() -> Json { throw std::logic_error("no such luck"); };
        try
        {
            makeStudyRuns(options_, "part", "", all);
            FAIL() << "a table without a run";
        }
        catch (const std::runtime_error &error)
        {
            EXPECT_EQ(std::string(error.what()), "mfa, 2: threw an exception: no such luck");
        }
    }

    TEST_F(StudyRuns, StopOnASignal)
    {
        std::vector<StudyRun> all = runs(3);
        all[1].make = []() -> Json
        {
            kill(getppid(), SIGTERM);
            pause();
            return {};
        };
        try
        {
            options_.jobs = 1;
            makeStudyRuns(options_, "part", "", all);
            FAIL() << "not stopped";
        }
        catch (const Interrupted &interrupted)
        {
            EXPECT_EQ(interrupted.signal(), SIGTERM);
            EXPECT_NE(std::string(interrupted.what()).find("2 runs of 'part'"), std::string::npos)
                << interrupted.what();
        }
    }

    TEST_F(StudyRuns, NumbersSurviveTheJournalWhole)
    {
        const double infinity = std::numeric_limits<double>::infinity();
        const std::vector<double> numbers{0.0, 1.0 / 3.0, -5e-324, 1.7976931348623157e308, infinity, -infinity};
        const std::vector<StudyRun> all{{{{"algorithm", "mfa"}},
                                         [&numbers]
                                         {
                                             Json values = Json::array();
                                             for (const double number : numbers)
                                             {
                                                 values.push_back(numberToJson(number));
                                             }
                                             values.push_back(numberToJson(NAN));
                                             return Json{{"values", values}};
                                         }}};
        const Json values = makeStudyRuns(options_, "part", "", all).at(0).at("values");
        for (std::size_t i = 0; i < numbers.size(); ++i)
        {
            EXPECT_EQ(numberFrom(values.at(i)), numbers[i]);
        }
        EXPECT_TRUE(std::isnan(numberFrom(values.back())));
    }
}  // namespace ompl_mfa::paper
