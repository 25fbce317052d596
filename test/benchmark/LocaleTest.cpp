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

#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "ForeignLocale.h"
#include "benchmark/CampaignLog.h"
#include "benchmark/InputErrorOf.h"
#include "benchmark/MeasuredRun.h"
#include "benchmark/PlanarProblem.h"
#include "benchmark/TestPlanners.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ob = ompl::base;
using namespace ompl_mfa::test;
using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::benchmark
{
    namespace
    {
        const std::string CONFIG = R"([PROBLEM]
ROBOT = disc
ROBOT.RADIUS = 0.125
START.X = 1.5
START.Y = 1e-1
GOAL.X = 1234.5
GOAL.Y = 2.5
VOLUME.MIN.X = -0.5
VOLUME.MIN.Y = -0.5
VOLUME.MAX.X = 2000.5
VOLUME.MAX.Y = 3.5
OBJECTIVE = WEIGHTED
OBJECTIVE.WEIGHT.LENGTH = 0.25
LONGEST_VALID_SEGMENT_FRACTION = 0.0125
[BENCHMARK]
TIME_LIMIT = 0.05
RUN_COUNT = 2000
SIMPLIFY = TRUE
PROGRESS_INTERVAL = 0.0015
[PLANNER]
PRMSTAR =
RRTSTAR.GOAL_BIAS = 0.125
MFA.POPULATION_SIZE = 1200
MFA.GAMMA = 0.25
)";

        BenchmarkConfig parsed(const std::string &text = CONFIG)
        {
            std::istringstream in(text);
            return parseBenchmarkConfig(in, "a.cfg");
        }

        /* All values of the config in one line, formatted independently of the locale. */
        std::string summary(const BenchmarkConfig &config)
        {
            std::ostringstream out;
            out.imbue(std::locale::classic());
            out << config.problem.robotRadius << ' ' << config.problem.start.x << ' ' << config.problem.start.y << ' '
                << config.problem.goal.x << ' ' << config.problem.volume->max[0] << ' '
                << config.problem.objectiveWeights.at(0).second << ' ' << config.benchmark.timeLimit << ' '
                << config.benchmark.runCount << ' ' << config.benchmark.simplify << ' '
                << config.benchmark.progressInterval;
            const ProblemFactory factory(config);
            for (const PlannerSpec &spec : config.planners)
            {
                const auto setup = factory.create(spec);
                std::map<std::string, std::string> parameters;
                setup->getPlanner()->params().getParams(parameters);
                out << ' ' << setup->getStateSpace()->getLongestValidSegmentFraction();
                for (const char *name : {"goal_bias", "population_size", "gamma"})
                {
                    out << ' ' << parameters[name];
                }
            }
            return out.str();
        }

        CampaignPlanner entry(const std::string &name, const ob::PlannerAllocator &allocator)
        {
            return {name, [](std::size_t) { return planarProblem(); }, allocator};
        }

        CampaignDescription description()
        {
            CampaignDescription description;
            description.name = "disc";
            description.planners = {entry("Solver",
                                          [](const ob::SpaceInformationPtr &si)
                                          {
                                              auto planner = std::make_shared<ompl::geometric::RRTConnect>(si);
                                              planner->setRange(0.25);
                                              return planner;
                                          }),
                                    entry("Crashing", crashingPlanner())};
            description.settings.timeLimit = 0.125;
            description.runCount = 1;
            description.savePaths = SavePaths::All;
            return description;
        }

        std::string textOf(const std::filesystem::path &file)
        {
            std::ifstream in(file);
            std::stringstream text;
            text << in.rdbuf();
            return text.str();
        }

        class Locale : public testing::Test
        {
        protected:
            Locale()
              : folder_(std::filesystem::temp_directory_path() /
                        ("ompl_mfa_benchmark_locale_" + std::to_string(getpid())))
            {
                std::filesystem::create_directories(folder_);
            }

            ~Locale() override
            {
                std::filesystem::remove_all(folder_);
            }

            CampaignResult runCampaign(const std::string &name) const
            {
                CampaignOptions options;
                options.log = folder_ / (name + ".log");
                return Campaign(description()).run(options);
            }

            std::filesystem::path folder_;
        };

        /* Values that differ between two runs. */
        void expectPlainNumbers(const LogProperties &properties)
        {
            for (const auto &[name, value] : properties)
            {
                EXPECT_EQ(value.find(','), std::string::npos) << name << " = " << value;
            }
        }
    }  // namespace

    TEST_F(Locale, ConfigsMeanTheSameWhateverStreamsTakeForNumbersAndLetters)
    {
        const std::string expected = summary(parsed());
        EXPECT_EQ(expected.rfind("0.125 1.5 0.1 1234.5 2000.5 0.25 0.05 2000 1 0.0015 0.0125", 0), 0U) << expected;
        const ForeignStreams foreign;
        EXPECT_EQ(inputErrorOf([] { summary(parsed()); }), "");
        EXPECT_EQ(summary(parsed()), expected);
    }

    TEST_F(Locale, ConfigsMeanTheSameWhateverTheLibraryTakesForNumbers)
    {
        const std::string expected = summary(parsed());
        const ForeignLibrary foreign;
        if (!foreign.isThere())
        {
            GTEST_SKIP() << "there is no locale de_DE.UTF-8, and it cannot be compiled";
        }
        EXPECT_EQ(inputErrorOf([] { summary(parsed()); }), "");
        EXPECT_EQ(summary(parsed()), expected);
    }

    TEST_F(Locale, MessagesNameNumbersAsConfigsWriteThem)
    {
        const ForeignStreams foreign;
        std::string text = CONFIG;
        text.replace(text.find("GOAL.X = 1234.5"), 15, "GOAL.X = 4321.5");
        const std::string message = inputErrorOf([&] { ProblemFactory(parsed(text)).create(); });
        EXPECT_NE(message.find("goal (4321.5, 2.5) is outside the bounds [-0.5, 2000.5] x"), std::string::npos)
            << message;
        text.replace(text.find("GOAL.X = 4321.5"), 15, "GOAL.X = 4321,5");
        EXPECT_NE(inputErrorOf([&] { parsed(text); }).find("problem.goal.x = 4321,5: expected a finite number"),
                  std::string::npos);
    }

    TEST_F(Locale, LogsAreWrittenAndReadTheSame)
    {
        BenchmarkLog log;
        log.version = "1.5.2";
        log.experiment = "e";
        log.properties = {{"campaign TEXT", "c"}};
        log.host = "here";
        log.start = "2026-01-02 03:04:05";
        log.seed = 1234567;
        log.timeLimit = 0.125;
        log.memoryLimit = 4096.5;
        log.runCount = 1000;
        log.duration = 12345.5;
        PlannerLog planner;
        planner.name = "geometric_A";
        planner.progressNames = {"best cost REAL"};
        for (int run = 0; run < 1000; ++run)
        {
            planner.runs.push_back({{"run INTEGER", std::to_string(run)}, {"time REAL", "0.5"}, {"odd REAL", "-inf"}});
            planner.progress.push_back({{0.25, {"1234.5"}}});
        }
        log.planners = {planner};
        const auto written = [&log]
        {
            std::ostringstream out;
            writeBenchmarkLog(out, log);
            return out.str();
        };
        const std::string expected = written();
        const auto expectSame = [&](const std::string &where)
        {
            EXPECT_EQ(written(), expected) << where;
            const BenchmarkLog back = logHeadFrom(campaign::parseJson(campaign::jsonLine(toJson(log))));
            EXPECT_EQ(back.timeLimit, 0.125) << where;
            EXPECT_EQ(back.memoryLimit, 4096.5) << where;
            EXPECT_EQ(back.seed, 1234567U) << where;
            EXPECT_EQ(back.runCount, 1000U) << where;
        };
        inForeignLocales(expectSame);
    }

    TEST_F(Locale, ALogKeepsTheFormatOfItsStream)
    {
        std::ostringstream out;
        out.imbue(std::locale(std::locale::classic(), new GermanPunctuation));
        writeBenchmarkLog(out, BenchmarkLog());
        out.str("");
        out << 1234567.5;
        EXPECT_EQ(out.str(), "1,23457e+06");
    }

    TEST_F(Locale, CampaignsAreTheSame)
    {
        runCampaign("plain");
        const CampaignRuns expected = readCampaignRuns(Campaign::journalFile(folder_ / "plain.log"));
        ASSERT_EQ(expected.records.size(), 2U);
        const std::string path = textOf(folder_ / "plain.geometric_Solver.0.path");
        ASSERT_NE(path.find("9 5"), std::string::npos) << path;
        const std::string print = Campaign(description()).fingerprint();
        const auto expectSame = [&](const std::string &name)
        {
            EXPECT_EQ(Campaign(description()).fingerprint(), print) << name;
            const CampaignResult found = runCampaign(name);
            EXPECT_EQ(textOf(folder_ / (name + ".geometric_Solver.0.path")), path) << name;
            EXPECT_NE(found.log.setup.find("extent: 14.1421\n"), std::string::npos) << name << ": " << found.log.setup;
            const CampaignRuns back = readCampaignRuns(Campaign::journalFile(folder_ / (name + ".log")));
            ASSERT_EQ(back.records.size(), 2U) << name;
            for (std::size_t i = 0; i < 2; ++i)
            {
                EXPECT_EQ(back.records[i].common, expected.records[i].common) << name;
                EXPECT_EQ(back.records[i].pathCost, expected.records[i].pathCost) << name;
                expectPlainNumbers(back.records[i].properties);
            }
            EXPECT_EQ(logHeadFrom(back.header.description).timeLimit, 0.125) << name;
        };
        inForeignLocales(expectSame);
    }

    TEST_F(Locale, ARunThatIsMeasuredHereIsTheSame)
    {
        RunSettings settings;
        settings.timeLimit = 0.05;
        settings.keepPath = true;
        const auto measured = [&settings](RunState &state)
        {
            return measureRun([] { return planarProblem(); },
                              [](const ob::SpaceInformationPtr &si)
                              { return std::make_shared<ompl::geometric::RRTConnect>(si); },
                              settings, 1, state);
        };
        RunState plain;
        const RunRecord expected = measured(plain);
        ASSERT_TRUE(std::isfinite(plain.bestCost.load()));
        const auto expectPlain = [&](const std::string &where)
        {
            RunState state;
            const RunRecord found = measured(state);
            EXPECT_EQ(found.path.find(','), std::string::npos) << where << ": " << found.path;
            const RunRecord back = readRunRecord(writeRunRecord(found));
            EXPECT_EQ(back.pathCost, found.pathCost) << where;
            EXPECT_EQ(back.properties, found.properties) << where;
        };
        inForeignLocales(expectPlain);
    }

    TEST_F(Locale, PublishedCostsAreReadWhole)
    {
        const ForeignLibrary foreign;
        if (!foreign.isThere())
        {
            GTEST_SKIP() << "there is no locale de_DE.UTF-8, and it cannot be compiled";
        }
        class Publisher : public ompl::geometric::RRTConnect
        {
        public:
            explicit Publisher(const ob::SpaceInformationPtr &si)
              : RRTConnect(si)
            {
                addPlannerProgressProperty("best cost REAL", [] { return "9.75"; });
            }
        };
        RunSettings settings;
        settings.timeLimit = 0.05;
        RunState state;
        measureRun([] { return planarProblem(); },
                   [](const ob::SpaceInformationPtr &si) { return std::make_shared<Publisher>(si); }, settings, 1,
                   state);
        EXPECT_EQ(state.bestCost.load(), 9.75);
    }
}  // namespace ompl_mfa::benchmark
