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

#include "benchmark/MeasuredRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "benchmark/PlanarProblem.h"
#include "benchmark/TestPlanners.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using ompl_mfa::campaign::makeShared;
using ompl_mfa::campaign::RunLimits;
using ompl_mfa::campaign::RunProcess;
using ompl_mfa::test::planarProblem;

namespace ompl_mfa::benchmark
{
    namespace
    {
        template <class T>
        ob::PlannerPtr makePlanner(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<T>(si);
        }

        /* Each run in its own process, as in a campaign: a seed only counts before the first random number. */
        RunRecord run(const ob::PlannerAllocator &planner, const RunSettings &settings, std::uint32_t seed)
        {
            const auto state = makeShared<RunState>();
            RunProcess process(
                [&]
                { return writeRunRecord(measureRun([] { return planarProblem(); }, planner, settings, seed, *state)); },
                RunLimits(), state);
            process.wait();
            EXPECT_EQ(process.termination(), campaign::RunTermination::Returned) << process.console();
            return readRunRecord(process.result());
        }

        double number(const RunRecord &record, const std::string &property)
        {
            const auto found = record.properties.find(property);
            return found == record.properties.end() ? NAN : std::stod(found->second);
        }

        /* Its clearance is so slow that measuring a path takes more than a second. */
        class SlowClearance : public ob::StateValidityChecker
        {
        public:
            SlowClearance(const ob::SpaceInformationPtr &si, ob::StateValidityCheckerPtr checker)
              : StateValidityChecker(si)
              , checker_(std::move(checker))
            {
            }

            bool isValid(const ob::State *state) const override
            {
                return checker_->isValid(state);
            }

            double clearance(const ob::State *state) const override
            {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                return checker_->clearance(state);
            }

        private:
            ob::StateValidityCheckerPtr checker_;
        };

        RunSettings shortRun()
        {
            RunSettings settings;
            settings.timeLimit = 0.3;
            return settings;
        }

        std::size_t indexOf(const std::vector<std::string> &names, const std::string &name)
        {
            return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        }
    }  // namespace

    TEST(MeasuredRun, HasOmplsPropertiesAndItsOwn)
    {
        const RunRecord record = run(makePlanner<og::RRTstar>, shortRun(), 5);
        for (const char *name : {"time REAL",
                                 "memory REAL",
                                 "status ENUM",
                                 "solved BOOLEAN",
                                 "valid segment fraction REAL",
                                 "approximate solution BOOLEAN",
                                 "solution difference REAL",
                                 "solution length REAL",
                                 "solution smoothness REAL",
                                 "solution clearance REAL",
                                 "solution segments INTEGER",
                                 "correct solution BOOLEAN",
                                 "correct solution strict BOOLEAN",
                                 "simplification time REAL",
                                 "simplified solution length REAL",
                                 "simplified solution segments INTEGER",
                                 "simplified solution smoothness REAL",
                                 "simplified solution clearance REAL",
                                 "simplified correct solution BOOLEAN",
                                 "simplified correct solution strict BOOLEAN",
                                 "graph states INTEGER",
                                 "graph motions INTEGER",
                                 "path cost REAL",
                                 "simplified path cost REAL",
                                 "minimum clearance REAL",
                                 "simplified minimum clearance REAL",
                                 "resampled smoothness REAL",
                                 "simplified resampled smoothness REAL",
                                 "collision checks INTEGER",
                                 "motion checks INTEGER",
                                 "time to first solution REAL",
                                 "final best cost REAL"})
        {
            EXPECT_EQ(record.properties.count(name), 1u) << name;
        }
        EXPECT_EQ(number(record, "solved BOOLEAN"), 1.0);
        EXPECT_NEAR(number(record, "path cost REAL"), number(record, "solution length REAL"), 1e-4);
        EXPECT_GE(number(record, "path cost REAL"), test::planarOptimum() * 0.999);
        EXPECT_LE(number(record, "simplified path cost REAL"), number(record, "path cost REAL") * 1.000001);
        EXPECT_LE(number(record, "time to first solution REAL"), number(record, "time REAL"));
        EXPECT_GE(number(record, "minimum clearance REAL"), -0.01);
    }

    TEST(MeasuredRun, CountsChecksOfTheSolveOnly)
    {
        const auto planner = [](const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<test::TestPlanner>(si, "Counting",
                                                       [si](const ob::PlannerTerminationCondition &)
                                                       {
                                                           ob::ScopedState<> state(si->getStateSpace());
                                                           state[0] = 1.0;
                                                           state[1] = 1.0;
                                                           for (int i = 0; i < 10; ++i)
                                                           {
                                                               si->isValid(state.get());
                                                           }
                                                           return ob::PlannerStatus::TIMEOUT;
                                                       });
        };
        const RunRecord record = run(planner, shortRun(), 1);
        EXPECT_EQ(number(record, "collision checks INTEGER"), 10.0);
        EXPECT_EQ(number(record, "motion checks INTEGER"), 0.0);
    }

    TEST(MeasuredRun, SameSeedAndIterationLimitGiveEqualCosts)
    {
        RunSettings settings;
        settings.timeLimit = 60.0;
        settings.iterationLimit = 400;
        for (const auto &planner :
             {ob::PlannerAllocator(makePlanner<og::RRTstar>), ob::PlannerAllocator(makePlanner<og::BITstar>)})
        {
            const RunRecord first = run(planner, settings, 11);
            const RunRecord second = run(planner, settings, 11);
            const RunRecord other = run(planner, settings, 12);
            for (const char *property : {"path cost REAL", "simplified path cost REAL", "collision checks INTEGER",
                                         "minimum clearance REAL", "graph states INTEGER"})
            {
                EXPECT_EQ(first.properties.at(property), second.properties.at(property)) << property;
            }
            EXPECT_NE(first.properties.at("path cost REAL"), other.properties.at("path cost REAL"));
        }
    }

    TEST(MeasuredRun, IterationLimitStopsThePlanner)
    {
        RunSettings settings;
        settings.timeLimit = 60.0;
        settings.iterationLimit = 100;
        const RunRecord record = run(makePlanner<og::RRTstar>, settings, 3);
        EXPECT_EQ(number(record, "iterations INTEGER"), 100.0);
    }

    TEST(MeasuredRun, ProgressIsDenseAtFirstAndGoesOnToTheTimeLimit)
    {
        RunSettings settings;
        settings.timeLimit = 0.5;
        settings.progressInterval = 0.02;
        for (const auto &planner :
             {ob::PlannerAllocator(makePlanner<og::RRTstar>), ob::PlannerAllocator(makePlanner<og::RRTConnect>)})
        {
            const RunRecord record = run(planner, settings, 2);
            ASSERT_GE(record.progress.size(), 15u);
            const std::size_t cost = indexOf(record.progressNames, "best cost REAL");
            ASSERT_LT(cost, record.progressNames.size());
            double last = 0.0;
            double lastCost = std::numeric_limits<double>::infinity();
            for (const ProgressSample &sample : record.progress)
            {
                EXPECT_GT(sample.time, last);
                ASSERT_EQ(sample.values.size(), record.progressNames.size());
                last = sample.time;
                const double value = std::strtod(sample.values[cost].c_str(), nullptr);
                if (std::isfinite(value))
                {
                    EXPECT_LE(value, lastCost);
                    lastCost = value;
                }
            }
            EXPECT_NEAR(last, 0.5, 0.2);
            EXPECT_NEAR(lastCost, number(record, "path cost REAL"), 1e-3);
        }
    }

    TEST(MeasuredRun, ShowsTheFirstTenMilliseconds)
    {
        RunSettings settings;
        settings.timeLimit = 0.05;
        // The planner returns at once, so load of the machine does not matter: its series is continued on the grid.
        const auto planner = test::testPlanner(
            "Quick", [](const ob::PlannerTerminationCondition &) { return ob::PlannerStatus::TIMEOUT; });
        const RunRecord record = run(planner, settings, 2);
        const auto early = std::count_if(record.progress.begin(), record.progress.end(),
                                         [](const ProgressSample &sample) { return sample.time <= 0.0101; });
        // 10 early samples and 50 in all on an idle machine, fewer on a loaded one
        EXPECT_GE(early, 3);
        EXPECT_GE(record.progress.size(), 15u);
    }

    TEST(MeasuredRun, GivesTheBitStarFamilyTheSamePropertyAsOthers)
    {
        const RunRecord record = run(makePlanner<og::BITstar>, shortRun(), 4);
        EXPECT_EQ(std::count(record.progressNames.begin(), record.progressNames.end(), "best cost REAL"), 1);
        for (const auto &property : record.properties)
        {
            EXPECT_EQ(property.first.find("DOUBLE"), std::string::npos) << property.first;
        }
        EXPECT_LT(number(record, "time to first solution REAL"), number(record, "time REAL"));
    }

    TEST(MeasuredRun, KeepsApproximateSolutionsApart)
    {
        const auto enclosed = []
        {
            auto setup = planarProblem(2.0);
            ob::ScopedState<> goal(setup->getStateSpace());
            goal[0] = 5.0;
            goal[1] = 5.0;
            setup->setGoalState(goal);
            return setup;
        };
        const auto state = makeShared<RunState>();
        RunProcess process(
            [&]
            {
                // Most planners reject a goal in collision; EST of OMPL 1.5 grows towards it.
                return writeRunRecord(measureRun(enclosed, makePlanner<og::EST>, shortRun(), 1, *state));
            },
            RunLimits(), state);
        process.wait();
        ASSERT_EQ(process.termination(), campaign::RunTermination::Returned);
        const RunRecord record = readRunRecord(process.result());
        EXPECT_EQ(number(record, "solved BOOLEAN"), 0.0);
        EXPECT_EQ(record.properties.count("solution length REAL"), 0u);
        EXPECT_EQ(record.properties.count("simplified solution length REAL"), 0u);
        EXPECT_EQ(record.properties.count("path cost REAL"), 0u);
        EXPECT_EQ(record.properties.count("simplified path cost REAL"), 0u);
        if (record.properties.count("approximate solution BOOLEAN") != 0 &&
            record.properties.at("approximate solution BOOLEAN") == "1")
        {
            EXPECT_EQ(record.properties.count("approximate solution length REAL"), 1u);
            EXPECT_EQ(record.properties.count("approximate simplified solution length REAL"), 1u);
        }
    }

    TEST(MeasuredRun, SimplifiesOnlyWhereItIsToldTo)
    {
        RunSettings settings = shortRun();
        settings.simplify = false;
        const RunRecord record = run(makePlanner<og::RRTConnect>, settings, 1);
        EXPECT_EQ(number(record, "solved BOOLEAN"), 1.0);
        EXPECT_EQ(record.properties.count("path cost REAL"), 1u);
        for (const auto &property : record.properties)
        {
            EXPECT_EQ(property.first.find("simpl"), std::string::npos) << property.first;
        }
    }

    TEST(MeasuredRun, TheTimeIsThePlannersOwn)
    {
        const auto slowlyMeasured = []
        {
            auto setup = planarProblem();
            const auto &si = setup->getSpaceInformation();
            setup->setStateValidityChecker(std::make_shared<SlowClearance>(si, si->getStateValidityChecker()));
            return setup;
        };
        RunSettings settings;
        settings.simplify = false;
        const auto state = makeShared<RunState>();
        RunProcess process(
            [&]
            { return writeRunRecord(measureRun(slowlyMeasured, makePlanner<og::RRTConnect>, settings, 1, *state)); },
            RunLimits(), state);
        const double start = campaign::monotonicSeconds();
        process.wait();
        EXPECT_GT(campaign::monotonicSeconds() - start, 1.0) << "the path is measured";
        const RunRecord record = readRunRecord(process.result());
        EXPECT_EQ(number(record, "solved BOOLEAN"), 1.0);
        EXPECT_LT(number(record, "time REAL"), 0.8);
    }

    TEST(MeasuredRun, AThrowingPlannerIsACrash)
    {
        const RunRecord record = run(test::throwingPlanner(), shortRun(), 1);
        EXPECT_EQ(record.termination, campaign::RunTermination::Exception);
        EXPECT_EQ(number(record, "status ENUM"), static_cast<double>(ob::PlannerStatus::CRASH));
    }

    TEST(RunSeed, IsAFunctionOfBaseAndRun)
    {
        // SplitMix64 from state 1: the first outputs, computed independently, modulo 2^31 - 1.
        EXPECT_EQ(runSeed(1, 0), 10451216379200822465ULL % 0x7fffffffULL);
        EXPECT_EQ(runSeed(1, 1), 13757245211066428519ULL % 0x7fffffffULL);
        std::set<std::uint32_t> seeds;
        for (std::uint64_t base = 1; base <= 20; ++base)
        {
            for (unsigned int k = 0; k < 100; ++k)
            {
                seeds.insert(runSeed(base, k));
            }
        }
        EXPECT_EQ(seeds.size(), 2000u);
        EXPECT_EQ(seeds.count(0), 0u);
    }
}  // namespace ompl_mfa::benchmark
