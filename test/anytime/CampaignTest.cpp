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

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <unistd.h>

#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"

namespace anytime = ompl_mfa::anytime;

namespace
{
    class Campaign : public testing::Test
    {
    protected:
        ~Campaign() override
        {
            std::filesystem::remove(file_);
        }

        std::size_t lineCount() const
        {
            std::ifstream in(file_);
            std::size_t count = 0;
            for (std::string line; std::getline(in, line);)
                ++count;
            return count;
        }

        anytime::CampaignRequest request_{
            anytime::selectWorlds("^(wall_gap|dividing_walls)_2d_1$"), {"rrtconnect"}, 2, 5.0, anytime::Clock::CPU, 1};
        std::filesystem::path file_{std::filesystem::temp_directory_path() /
                                    ("anytime-campaign-" + std::to_string(getpid()) + ".jsonl")};
        std::ostringstream progress_;
    };
}  // namespace

TEST_F(Campaign, MakesEveryRunOnce)
{
    anytime::runCampaign(request_, file_, progress_);
    EXPECT_EQ(lineCount(), 4U);
    EXPECT_NE(progress_.str().find("[4/4]"), std::string::npos) << progress_.str();
    request_.seeds = 3;
    progress_.str("");
    anytime::runCampaign(request_, file_, progress_);
    EXPECT_EQ(lineCount(), 6U);
    EXPECT_NE(progress_.str().find("[2/2]"), std::string::npos) << progress_.str();
}

TEST_F(Campaign, RefusesWhatCannotRun)
{
    request_.jobs = 0;
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    request_.jobs = 1;
    request_.planners = {"no_such_planner"};
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    request_.planners = {"rrtconnect:range=much"};
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    EXPECT_EQ(lineCount(), 0U);
}
