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

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/RunProgram.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /* A separate folder with a config of the paper's scene. */
        class Benchmark : public testing::Test
        {
        protected:
            void SetUp() override
            {
                folder_ = temporaryFile("benchmark");
                std::filesystem::create_directories(folder_);
                writeConfig("time_limit = 30\nrun_count = 4\niteration_limit = 400\nseed = 5\n",
                            "rrtstar =\nrrtconnect =\n");
            }

            void TearDown() override
            {
                std::filesystem::remove_all(folder_);
            }

            void writeConfig(const std::string &benchmark, const std::string &planners) const
            {
                std::ofstream(config()) << "[problem]\nname = scene\nworld = " OMPL_MFA_SOURCE_DIR
                                           "/benchmarks/worlds/paper_scene.yaml\nrobot = disc\nrobot.radius = 0.3\n"
                                           "start.x = 0.3\nstart.y = 2.2\ngoal.x = 20\ngoal.y = 20\nvolume.min.x = 0\n"
                                           "volume.min.y = 0\nvolume.max.x = 20\nvolume.max.y = 20\n[benchmark]\n"
                                        << benchmark << "[planner]\n"
                                        << planners;
            }

            std::string config() const
            {
                return folder_ + "/scene.cfg";
            }

            std::string folder_;
        };

        std::size_t count(const std::string &text, const std::string &part)
        {
            std::size_t found = 0;
            for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            {
                ++found;
            }
            return found;
        }
    }  // namespace

    TEST_F(Benchmark, WritesItsLogBesideTheConfigAndATable)
    {
        const ProgramResult result = runProgram("benchmark " + config());
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("RRTstar                   4"), std::string::npos) << result.out;
        EXPECT_EQ(count(result.err, ", run "), 8u) << result.err;
        const std::string log = readFile(folder_ + "/scene.log");
        EXPECT_NE(log.find("\nExperiment scene\n"), std::string::npos);
        EXPECT_NE(log.find("\nbase_seed INTEGER = 5\n"), std::string::npos);
        EXPECT_NE(log.find("\niteration_limit INTEGER = 400\n"), std::string::npos);
        EXPECT_EQ(count(log, "\n4 runs\n"), 4u);
    }

    TEST_F(Benchmark, PrintsJson)
    {
        const ProgramResult result = runProgram("benchmark --json --quiet --jobs 2 " + config());
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document.at("log"), folder_ + "/scene.log");
        ASSERT_EQ(document.at("planners").size(), 2u);
        EXPECT_EQ(document["planners"][0]["planner"], "RRTstar");
        EXPECT_EQ(document["planners"][0]["runs"], 4);
        EXPECT_GT(document["planners"][0]["cost_mean"], 27.8);
        EXPECT_LE(document["planners"][0]["simplified_cost_mean"], document["planners"][0]["cost_mean"]);
    }

    TEST_F(Benchmark, ShardsAndMergeMakeTheWhole)
    {
        const std::string output = folder_ + "/out/";
        EXPECT_EQ(runProgram("benchmark --quiet --output " + output + "whole.log " + config()).status, 0);
        std::string parts;
        for (const char *shard : {"1", "2", "3"})
        {
            const std::string part = output + "part" + shard + ".log";
            EXPECT_EQ(
                runProgram("benchmark --quiet --shard " + std::string(shard) + "/3 --output " + part + " " + config())
                    .status,
                0);
            parts += part + " ";
        }
        const ProgramResult merged = runProgram("merge " + parts + "--output " + output + "merged.log");
        EXPECT_EQ(merged.status, 0) << merged.err;
        EXPECT_NE(merged.out.find("8 runs of 2 planners from 3 parts"), std::string::npos);

        const ProgramResult json = runProgram("merge " + parts + "--json --output " + output + "merged.log");
        const auto document = nlohmann::json::parse(json.out);
        EXPECT_EQ(document["log"], output + "merged.log");
        EXPECT_EQ(document["parts"], 3);
        EXPECT_EQ(document["planners"].size(), 2u);
        EXPECT_EQ(document["planners"][1]["planner"], "RRTConnect");
        EXPECT_EQ(document["planners"][1]["runs"], 4);

        expectBadInput("merge " + parts + output + "whole.log --output " + output + "x.log", {"is in", "part"});
        expectBadInput("merge " + output + "part1.log --output " + output + "x.log", {"in none of the parts"});
        EXPECT_EQ(runProgram("merge --allow-missing " + output + "part1.log --output " + output + "x.log").status, 0);
        writeConfig("time_limit = 30\nrun_count = 4\niteration_limit = 401\nseed = 5\n", "rrtstar =\nrrtconnect =\n");
        EXPECT_EQ(
            runProgram("benchmark --quiet --shard 3/3 --overwrite --output " + output + "part3.log " + config()).status,
            0);
        expectBadInput("merge " + parts + "--output " + output + "x.log",
                       {"part3.log", "not a part of the same campaign"});
        expectBadInput("merge " + config() + " --output " + output + "x.log",
                       {"scene.cfg: is no journal", "scene.cfg.journal"});
        expectBadInput("merge /no/such.log --output " + output + "x.log", {"/no/such.log"});
        EXPECT_EQ(
            runProgram("merge --allow-missing " + output + "part1.log.journal --output " + output + "x.log").status, 0);
        EXPECT_EQ(
            runProgram("merge " + output + "x.log " + output + "part2.log --allow-missing --output " + output + "x.log")
                .status,
            0)
            << "a merged campaign can be merged again";
    }

    TEST_F(Benchmark, ResumesOnlyWhatIsMissing)
    {
        EXPECT_EQ(runProgram("benchmark --quiet " + config()).status, 0);
        const std::string journal = folder_ + "/scene.log.journal";
        const std::string whole = readFile(journal);
        std::filesystem::resize_file(journal, whole.size() / 2);
        std::filesystem::remove(folder_ + "/scene.log");
        expectBadInput("benchmark " + config(), {"scene.log.journal", "--resume", "--overwrite"});
        const ProgramResult result = runProgram("benchmark --resume " + config());
        EXPECT_EQ(result.status, 0);
        EXPECT_GE(count(result.err, ", run "), 1u);
        EXPECT_LT(count(result.err, ", run "), 8u);
        EXPECT_EQ(count(readFile(folder_ + "/scene.log"), "\n4 runs\n"), 4u);
    }

    TEST_F(Benchmark, SavesTheShortestPathsOfAProblemWithoutObjective)
    {
        writeConfig("time_limit = 30\nrun_count = 2\niteration_limit = 400\nsave_paths = shortest\n",
                    "rrtstar =\nrrtconnect =\n");
        EXPECT_EQ(runProgram("benchmark --quiet " + config()).status, 0);
        for (const char *planner : {"RRTstar", "RRTConnect"})
        {
            EXPECT_EQ(readFile(folder_ + "/scene.geometric_" + planner + ".path").rfind("0.3 2.2", 0), 0u) << planner;
        }
    }

    TEST_F(Benchmark, NamesOfTheConfigStayInTheFolder)
    {
        const auto expectRefused = [this](const std::string &key, const std::string &value)
        {
            writeConfig("run_count = 1\niteration_limit = 400\n", "rrtconnect =\n");
            std::string text = readFile(config());
            if (key == "name")
            {
                text.replace(text.find("name = scene"), 12, "name = " + value);
            }
            else
            {
                text.replace(text.find("run_count"), 0, key + " = " + value + "\n");
            }
            std::ofstream(folder_ + "/in/scene.cfg") << text;
            expectBadInput("benchmark --quiet " + folder_ + "/in/scene.cfg", {"scene.cfg:", key + " = "});
        };
        std::filesystem::create_directories(folder_ + "/in/sub");
        for (const std::string name : {"../scene", "/tmp/ompl_mfa_scene", "sub/scene", "sub/../../scene", ".", "..",
                                       "a\tb", "a\x1b[2Jb", "a\x7f"})
        {
            expectRefused("name", name);
        }
        expectRefused("name", std::string(300, 'n'));
        for (const std::string output : {"~nobody", "a/~", "~/~/b", "a\tb", "~nobody/a"})
        {
            expectRefused("output", output);
        }
        std::size_t files = 0;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(folder_))
        {
            files += entry.is_regular_file() ? 1 : 0;
        }
        EXPECT_EQ(files, 2U) << "only scene.cfg and in/scene.cfg";
    }

    TEST_F(Benchmark, TheTildeIsTheHomeFolder)
    {
        const auto runAtHome = [this](const std::string &arguments)
        {
            const ProgramResult result = runProgram(arguments);
            EXPECT_EQ(result.status, 0) << result.err;
            EXPECT_FALSE(std::filesystem::exists("~"));
            std::error_code ignored;
            std::filesystem::remove_all("~", ignored);
        };
        const char *before = std::getenv("HOME");
        const std::string home = before == nullptr ? "" : before;
        std::filesystem::create_directories(folder_ + "/home");
        setenv("HOME", (folder_ + "/home").c_str(), 1);
        for (const std::string output : {"~", "~/logs/deep"})
        {
            writeConfig("run_count = 1\niteration_limit = 400\noutput = " + output + "\n", "rrtconnect =\n");
            runAtHome("benchmark --quiet " + config());
            EXPECT_TRUE(std::filesystem::exists(folder_ + "/home" + output.substr(1) + "/scene.log")) << output;
        }
        writeConfig("run_count = 1\niteration_limit = 400\n", "rrtconnect =\n");
        runAtHome("benchmark --quiet --output='~/a/b.log' " + config());
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/home/a/b.log"));
        runAtHome("merge --output='~/a/c.log' " + folder_ + "/home/a/b.log");
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/home/a/c.log"));
        runAtHome("plan --planner rrtconnect --path='~/a/p.path' --picture='~/a/p.svg' " + config());
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/home/a/p.path"));
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/home/a/p.svg"));
        unsetenv("HOME");
        expectBadInput("benchmark --quiet --output='~/a/d.log' " + config(), {"--output", "~/a/d.log", "HOME"});
        setenv("HOME", home.c_str(), 1);
        if (before == nullptr)
        {
            unsetenv("HOME");
        }
    }

    TEST_F(Benchmark, SavesPathsOfPlannersWhateverTheirNames)
    {
        writeConfig("run_count = 1\niteration_limit = 400\nsave_paths = all\n",
                    "rrtconnect =\nrrtconnect.name = ../a/b\nrrtconnect =\nrrtconnect.name = 50 % w/o\n");
        const ProgramResult result = runProgram("benchmark --quiet " + config());
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/scene.geometric_..%2Fa%2Fb.0.path"));
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/scene.geometric_50 %25 w%2Fo.0.path"));
        writeConfig("run_count = 1\n", "rrtconnect =\nrrtconnect.name = a\x1b[31m\n");
        expectBadInput("check " + config(), {"scene.cfg:18", "name", "control characters"});
        writeConfig("run_count = 1\n", "rrtconnect =\nrrtconnect.name = " + std::string(101, 'n') + "\n");
        expectBadInput("check " + config(), {"scene.cfg:18", "name", "100 bytes"});
    }

    TEST_F(Benchmark, RefusesWhatItCannotUse)
    {
        for (const char *shard : {"0/3", "4/3", "3", "a/b", "1/3x", "-1/3", "1/-3", "/"})
        {
            expectBadInput(std::string("benchmark --shard=") + shard + " " + config(), {"--shard", shard, "I/N"});
        }
        expectBadInput("benchmark --jobs 0 " + config(), {"--jobs"});
        expectBadInput("benchmark --grace -1 " + config(), {"--grace"});
        expectBadInput("benchmark --grace nan " + config(), {"--grace"});
        expectBadInput("benchmark --resume --overwrite " + config(), {"--overwrite", "--resume"});
        expectBadInput("benchmark /no/such.cfg", {"/no/such.cfg"});
        expectBadInput("benchmark --output /proc/no/x.log " + config(), {"/proc/no"});
        expectBadInput("benchmark", {"config"});

        writeConfig("time_limt = 3\n", "rrtstar =\n");
        expectBadInput("benchmark " + config(), {"scene.cfg:15", "time_limt", "time_limit"});
        writeConfig("progress_interval = 0.0001\n", "rrtstar =\n");
        expectBadInput("benchmark " + config(), {"progress_interval", "0.001"});
        writeConfig("", "mfa =\nmfa.seed = 3\n");
        expectBadInput("benchmark " + config(), {"scene.cfg", "seed", "benchmark.seed"});
        writeConfig("", "rrtstar =\nrrtstar.rnge = 3\n");
        expectBadInput("benchmark " + config(), {"scene.cfg:17", "rnge", "range"});
        EXPECT_FALSE(std::filesystem::exists(folder_ + "/scene.log"));
    }
}  // namespace ompl_mfa::cli
