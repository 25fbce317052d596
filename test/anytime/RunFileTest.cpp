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

#include "anytime/RunFile.h"

#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sched.h>
#include <unistd.h>

#include "ompl_mfa/InputError.h"

namespace anytime = ompl_mfa::anytime;

namespace
{
    class RunFile : public testing::Test
    {
    protected:
        RunFile()
        {
            world_.name = "some_world";
            world_.family = "some";
        }

        ~RunFile() override
        {
            std::filesystem::remove(file_);
        }

        anytime::RunRequest request(std::uint32_t seed) const
        {
            return {&world_, "mfa:slices=3,gamma=2", seed, 1.5, anytime::Clock::CPU};
        }

        void appendRun(anytime::RunFile &runs, std::uint32_t seed) const
        {
            anytime::RunProcess run(request(seed), sched_getcpu(),
                                    [](const anytime::RunRequest &, anytime::RunResult &result)
                                    {
                                        result.solved = true;
                                        result.cost = 2.25;
                                        result.states = 2;
                                        result.reals = 4;
                                        for (int i = 0; i < 4; ++i)
                                            result.path[i] = i;
                                        result.log.entries[0] = {0.5, 0.25, 2.5, 100};
                                        result.log.count = 1;
                                    });
            while (!run.finished())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            runs.append(run);
        }

        std::vector<std::string> lines() const
        {
            std::ifstream in(file_);
            std::vector<std::string> all;
            for (std::string line; std::getline(in, line);)
                all.push_back(line);
            return all;
        }

        anytime::World world_;
        std::filesystem::path file_{std::filesystem::temp_directory_path() /
                                    ("anytime-runs-" + std::to_string(getpid()) + ".jsonl")};
    };
}  // namespace

TEST_F(RunFile, HoldsEverythingOfARun)
{
    {
        anytime::RunFile runs(file_);
        appendRun(runs, 3);
    }
    ASSERT_EQ(lines().size(), 1U);
    const auto run = nlohmann::json::parse(lines()[0]);
    EXPECT_EQ(run["world"], "some_world");
    EXPECT_EQ(run["planner"], "mfa:slices=3,gamma=2");
    EXPECT_EQ(run["seed"], 3);
    EXPECT_EQ(run["time_limit"], 1.5);
    EXPECT_EQ(run["status"], "returned");
    EXPECT_EQ(run["cost"], 2.25);
    EXPECT_EQ(run["path"], (nlohmann::json{{0.0, 1.0}, {2.0, 3.0}}));
    EXPECT_EQ(run["improvements"], (nlohmann::json{{0.5, 0.25, 2.5, 100}}));
}

TEST_F(RunFile, RemembersWhatItHolds)
{
    {
        anytime::RunFile runs(file_);
        EXPECT_FALSE(runs.has(request(1)));
        appendRun(runs, 1);
        EXPECT_TRUE(runs.has(request(1)));
    }
    const anytime::RunFile again(file_);
    EXPECT_TRUE(again.has(request(1)));
    EXPECT_FALSE(again.has(request(2)));
    auto longer = request(1);
    longer.timeLimit = 2.0;
    EXPECT_FALSE(again.has(longer));
}

TEST_F(RunFile, GoesOnAfterAnInterruptedLine)
{
    {
        anytime::RunFile runs(file_);
        appendRun(runs, 1);
    }
    std::ofstream(file_, std::ios::app) << R"({"world": "some_wor)";
    anytime::RunFile runs(file_);
    appendRun(runs, 2);
    ASSERT_EQ(lines().size(), 2U);
    EXPECT_EQ(nlohmann::json::parse(lines()[1])["seed"], 2);
}

TEST_F(RunFile, NamesTheLineThatIsNoRun)
{
    std::ofstream(file_) << "{\"world\": 3}\n";
    try
    {
        const anytime::RunFile runs(file_);
        FAIL() << "accepted";
    }
    catch (const ompl_mfa::InputError &error)
    {
        EXPECT_NE(std::string(error.what()).find(file_.string() + ":1"), std::string::npos) << error.what();
    }
}
