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

#include "anytime/Campaign.h"

#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include <unistd.h>

#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"

using ompl_mfa::campaign::Json;

namespace ompl_mfa::anytime
{
    namespace
    {
        class Campaign : public testing::Test
        {
        protected:
            Campaign()
            {
                options_.journal = std::filesystem::temp_directory_path() /
                                   ("anytime-campaign-" + std::to_string(getpid()) + ".jsonl");
                options_.progress = &progress_;
            }

            ~Campaign() override
            {
                std::filesystem::remove(options_.journal);
            }

            std::vector<Json> runs() const
            {
                std::vector<Json> all;
                campaign::readJournal(options_.journal, [&all](const Json &run, std::size_t) { all.push_back(run); });
                return all;
            }

            CampaignRequest request_{
                selectWorlds("^(wall_gap|dividing_walls)_2d_1$"), {"rrtconnect"}, 2, 5.0, Clock::CPU};
            std::ostringstream progress_;
            campaign::RunOptions options_;
        };
    }  // namespace

    TEST_F(Campaign, MakesEveryRunOnce)
    {
        EXPECT_EQ(runCampaign(request_, options_).missing, 0U);
        EXPECT_EQ(runs().size(), 4U);
        EXPECT_NE(progress_.str().find("4/4  "), std::string::npos) << progress_.str();
        request_.seeds = 3;
        runCampaign(request_, options_);
        EXPECT_EQ(runs().size(), 6U);
        request_.worlds.pop_back();
        request_.planners = {"rrtconnect:range=0.1", "rrtconnect"};
        runCampaign(request_, options_);
        EXPECT_EQ(runs().size(), 9U);
        request_.timeLimit = 4.0;
        request_.seeds = 1;
        runCampaign(request_, options_);
        EXPECT_EQ(runs().size(), 11U);
        options_.overwrite = true;
        runCampaign(request_, options_);
        EXPECT_EQ(runs().size(), 2U);
    }

    TEST_F(Campaign, KeepsWhatTheStatisticsRead)
    {
        request_.planners = {"mfa:slices=3"};
        request_.timeLimit = 0.2;
        request_.seeds = 1;
        runCampaign(request_, options_);
        const Json run = runs().at(1);
        EXPECT_EQ(run["world"], request_.worlds[1].name);
        EXPECT_EQ(run["planner"], "mfa:slices=3");
        EXPECT_EQ(run["seed"], 1);
        EXPECT_EQ(run["time_limit"], 0.2);
        EXPECT_EQ(run["clock"], "cpu");
        for (const char *field :
             {"status", "note", "solved", "valid", "strict", "cost", "wall", "cpu", "checks", "path_check",
              "path_checks", "looks", "longest_gap", "path", "improvements", "family"})
        {
            EXPECT_TRUE(run.contains(field)) << field;
        }
        ASSERT_FALSE(run["improvements"].empty());
        EXPECT_EQ(run["improvements"][0].size(), 4U);
    }

    TEST_F(Campaign, RefusesWhatCannotRun)
    {
        options_.jobs = 0;
        EXPECT_THROW(runCampaign(request_, options_), InputError);
        options_.jobs = 1;
        request_.planners = {"no_such_planner"};
        EXPECT_THROW(runCampaign(request_, options_), InputError);
        EXPECT_FALSE(std::filesystem::exists(options_.journal));
        request_.planners = {"rrtconnect:range=much"};
        EXPECT_THROW(runCampaign(request_, options_), InputError);
        EXPECT_EQ(runs().size(), 0U);
    }
}  // namespace ompl_mfa::anytime
