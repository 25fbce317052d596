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

#include <cmath>
#include <fstream>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/util/Exception.h>

#include "ForeignLocale.h"
#include "planner/ConsoleRecord.h"
#include "planner/MFAParameters.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        class Parameters : public ::testing::Test
        {
        protected:
            std::string value(const std::string &name) const
            {
                std::string result;
                EXPECT_TRUE(planner_.params().getParam(name, result)) << name;
                return result;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            MFA planner_{problem_->si};
        };

        TEST_F(Parameters, ThoseOfThePaperAreThere)
        {
            for (const char *name :
                 {"variant", "population_size", "slices", "generations", "gamma", "alpha", "eta", "seed"})
            {
                EXPECT_TRUE(planner_.params().hasParam(name)) << name;
            }
        }

        TEST_F(Parameters, DefaultsOfTheSwarmAreThePapers)
        {
            EXPECT_EQ(value("variant"), "mfa");
            EXPECT_EQ(value("generations"), "50");
            EXPECT_DOUBLE_EQ(std::stod(value("gamma")), 0.5);
            EXPECT_DOUBLE_EQ(std::stod(value("alpha")), 0.2);
            EXPECT_DOUBLE_EQ(std::stod(value("eta")), 1.0);
        }

        TEST_F(Parameters, EveryOneHasARangeAndCanBeSetToWhatItReads)
        {
            for (const auto &[name, parameter] : planner_.params().getParams())
            {
                EXPECT_FALSE(parameter->getRangeSuggestion().empty()) << name;
                const std::string before = parameter->getValue();
                EXPECT_FALSE(before.empty()) << name;
                EXPECT_TRUE(planner_.params().setParam(name, before)) << name << " = " << before;
                EXPECT_EQ(parameter->getValue(), before) << name;
            }
        }

        std::vector<std::string> split(const std::string &text, char separator)
        {
            std::vector<std::string> parts;
            std::istringstream in(text);
            for (std::string part; std::getline(in, part, separator);)
            {
                parts.push_back(part);
            }
            return parts;
        }

        TEST_F(Parameters, TheEndsOfEveryRangeAreAcceptedAndReadBack)
        {
            for (const auto &[name, parameter] : planner_.params().getParams())
            {
                const std::string range = parameter->getRangeSuggestion();
                const bool interval = range.find(':') != std::string::npos;
                auto ends = split(range, interval ? ':' : ',');
                if (interval)
                {
                    ends = {ends.front(), ends.back()};
                }
                const std::string before = parameter->getValue();
                for (const auto &end : ends)
                {
                    EXPECT_TRUE(planner_.params().setParam(name, end)) << name << " = " << end;
                    if (interval)
                    {
                        EXPECT_DOUBLE_EQ(std::stod(parameter->getValue()), std::stod(end)) << name;
                    }
                    else
                    {
                        EXPECT_EQ(parameter->getValue(), end) << name;
                    }
                }
                planner_.params().setParam(name, before);
            }
        }

        TEST_F(Parameters, WhatIsNoNumberOrOutOfRangeIsRefusedOnTheConsoleAndChangesNothing)
        {
            const std::map<std::string, std::vector<std::string>> bad{
                {"variant", {"", "firefly", "MFA"}},
                {"population_size", {"", "many", "3", "-1", "2.5", "99999999999"}},
                {"slices", {"", "0", "-3", "1001", "x"}},
                {"generations", {"", "0", "-3", "x"}},
                {"gamma", {"", "-0.1", "nan", "x"}},
                {"alpha", {"", "-0.1", "1.1", "nan", "x"}},
                {"eta", {"", "-0.1", "2.1", "nan", "x"}},
                {"seed", {"", "x", "-1", "4294967296", "1.5"}}};
            for (const auto &[name, values] : bad)
            {
                const std::string before = value(name);
                for (const auto &wrong : values)
                {
                    const test::ConsoleRecord console;
                    EXPECT_FALSE(planner_.params().setParam(name, wrong)) << name << " = '" << wrong << "'";
                    EXPECT_TRUE(console.mentions(name)) << name << " = '" << wrong << "'";
                    EXPECT_EQ(value(name), before);
                }
            }
        }

        TEST_F(Parameters, EveryNumberIsCheckedAgainstBothEndsOfItsRange)
        {
            for (const auto &[name, parameter] : planner_.params().getParams())
            {
                const std::string range = parameter->getRangeSuggestion();
                const test::ConsoleRecord console;
                EXPECT_FALSE(planner_.params().setParam(name, "surely not")) << name;
                if (range.find(':') == std::string::npos)
                {
                    continue;
                }
                const auto ends = split(range, ':');
                std::ostringstream above;
                above << std::fixed << std::stod(ends.back()) * 2.0 + 1.0;
                EXPECT_FALSE(planner_.params().setParam(name, "-1")) << name << " = -1";
                EXPECT_FALSE(planner_.params().setParam(name, above.str())) << name << " = " << above.str();
            }
        }

        TEST_F(Parameters, AnUnknownNameIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            EXPECT_FALSE(planner_.params().setParam("populationsize", "20"));
            EXPECT_TRUE(console.mentions("populationsize"));
        }

        TEST_F(Parameters, SettersThrowWithNameAndValue)
        {
            try
            {
                planner_.setSlices(0);
                FAIL() << "accepted";
            }
            catch (const ompl::Exception &error)
            {
                EXPECT_NE(std::string(error.what()).find("slices = 0"), std::string::npos) << error.what();
            }
            EXPECT_THROW(planner_.setVariant("x"), ompl::Exception);
            EXPECT_THROW(planner_.setPopulationSize(3), ompl::Exception);
            EXPECT_THROW(planner_.setAlpha(2.0), ompl::Exception);
        }

        /* One of the trial vectors needs four fireflies: the sizes accepted must not depend on the order in which
           variant and size are set. */
        TEST_F(Parameters, NoSequenceOfAcceptedValuesIsRefusedLater)
        {
            const auto planner = problem_->planner(test::PlannerVariant::Paper);
            const test::ConsoleRecord console;
            for (const std::string size : {"0", "1", "2", "3", "4"})
            {
                for (const std::string first : {"fa", "mfa"})
                {
                    const bool accepted = size == "0" || size == "4";
                    ASSERT_TRUE(planner->params().setParam("variant", first));
                    EXPECT_EQ(planner->params().setParam("population_size", size), accepted) << first << ' ' << size;
                    EXPECT_TRUE(planner->params().setParam("variant", first == "fa" ? "mfa" : "fa")) << size;
                    planner->clear();
                    EXPECT_NO_THROW(planner->solve(test::afterCalls(300))) << first << ' ' << size;
                }
            }
        }

        /* Calls a setter and returns whether the value was accepted; params() then has to accept the value read
           back. */
        template <typename Setter>
        bool accepts(MFA &planner, const std::string &name, const Setter &setter)
        {
            bool accepted = true;
            try
            {
                setter();
            }
            catch (const ompl::Exception &)
            {
                accepted = false;
            }
            std::string text;
            EXPECT_TRUE(planner.params().getParam(name, text));
            EXPECT_TRUE(planner.params().setParam(name, text)) << name << " = " << text;
            return accepted;
        }

        TEST_F(Parameters, SettersRefuseWhatParamsRefuse)
        {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            for (const double gamma : {-0.1, 0.0, 100.0, 100.1, 1000.0, nan, HUGE_VAL})
            {
                EXPECT_EQ(accepts(planner_, "gamma", [&] { planner_.setGamma(gamma); }), gamma >= 0 && gamma <= 100);
            }
            for (const double alpha : {-0.1, 0.0, 1.0, 1.1, nan})
            {
                EXPECT_EQ(accepts(planner_, "alpha", [&] { planner_.setAlpha(alpha); }), alpha >= 0 && alpha <= 1);
            }
            for (const double eta : {-0.1, 0.0, 2.0, 2.1, nan})
            {
                EXPECT_EQ(accepts(planner_, "eta", [&] { planner_.setEta(eta); }), eta >= 0 && eta <= 2);
            }
            for (const unsigned int n : {0U, 1U, 3U, 4U, 64U, 65U, 1000U, 1001U, 10000U, 10001U, 100000U, 1000000U})
            {
                EXPECT_EQ(accepts(planner_, "population_size", [&] { planner_.setPopulationSize(n); }),
                          n == 0 || (n >= 4 && n <= 10000));
                EXPECT_EQ(accepts(planner_, "slices", [&] { planner_.setSlices(n); }), n >= 1 && n <= 1000);
                EXPECT_EQ(accepts(planner_, "generations", [&] { planner_.setGenerations(n); }), n >= 1 && n <= 100000);
                EXPECT_EQ(accepts(planner_, "threads", [&] { planner_.setThreads(n); }), n >= 1 && n <= 64);
                EXPECT_EQ(accepts(planner_, "strictness", [&] { planner_.setStrictness(n); }), n >= 1 && n <= 64);
                EXPECT_TRUE(accepts(planner_, "seed", [&] { planner_.setSeed(n); }));
            }
            for (const std::string word : {"mfa", "fa", "none", "trees", "roadmap", "both", "equations", "detours", ""})
            {
                EXPECT_EQ(accepts(planner_, "variant", [&] { planner_.setVariant(word); }),
                          word == "mfa" || word == "fa");
                EXPECT_EQ(accepts(planner_, "guide", [&] { planner_.setGuide(word); }),
                          word == "none" || word == "trees" || word == "roadmap" || word == "both");
                EXPECT_EQ(accepts(planner_, "firefly_moves", [&] { planner_.setFireflyMoves(word); }),
                          word == "both" || word == "equations" || word == "detours");
            }
        }

        TEST_F(Parameters, SwitchesAreReadAsOmplReadsThem)
        {
            for (const char *name : {"recombination", "tightening"})
            {
                for (const char *off : {"0", "false", "False", "FALSE", "f"})
                {
                    planner_.params().setParam(name, "1");
                    EXPECT_TRUE(planner_.params().setParam(name, off)) << off;
                    EXPECT_EQ(value(name), "0") << off;
                }
                for (const char *on : {"1", "true", "True", "TRUE", "t"})
                {
                    planner_.params().setParam(name, "0");
                    EXPECT_TRUE(planner_.params().setParam(name, on)) << on;
                    EXPECT_EQ(value(name), "1") << on;
                }
                // values that OMPL would read as true
                const test::ConsoleRecord console;
                for (const char *neither : {"", "2", "no", "-1", "01", "truee"})
                {
                    EXPECT_FALSE(planner_.params().setParam(name, neither)) << neither;
                }
            }
        }

        TEST_F(Parameters, NumbersAreReadTheSameHoweverTheyAreWritten)
        {
            const test::ConsoleRecord console;
            for (const char *half : {"0.5", "+0.5", "5e-1", ".5", " 0.5", "0.5 ", "0.50000"})
            {
                planner_.setGamma(1.0);
                EXPECT_TRUE(planner_.params().setParam("gamma", half)) << half;
                EXPECT_EQ(planner_.getGamma(), 0.5) << half;
            }
            for (const char *twenty : {"20", "+20", "020", " 20\t"})
            {
                planner_.setSlices(1);
                EXPECT_TRUE(planner_.params().setParam("slices", twenty)) << twenty;
                EXPECT_EQ(planner_.getSlices(), 20U) << twenty;
            }
            for (const char *wrong :
                 {"0x1", "inf", "nan", "1,5", "1.5.1", "+-1", "++1", "1 2", "1e999", "+", " ", "1f"})
            {
                EXPECT_FALSE(planner_.params().setParam("gamma", wrong)) << wrong;
                EXPECT_FALSE(planner_.params().setParam("slices", wrong)) << wrong;
            }
            for (const char *wrong : {"2e1", "20.0", "0x14", "4294967296", "18446744073709551617", "1,000"})
            {
                EXPECT_FALSE(planner_.params().setParam("slices", wrong)) << wrong;
            }
            EXPECT_EQ(planner_.getGamma(), 0.5);
            EXPECT_EQ(planner_.getSlices(), 20U);
        }

        TEST_F(Parameters, NumbersAreReadTheSameInEveryLocale)
        {
            const std::locale before =
                std::locale::global(std::locale(std::locale::classic(), new test::GermanPunctuation));
            EXPECT_TRUE(planner_.params().setParam("gamma", "0.125"));
            EXPECT_TRUE(planner_.params().setParam("generations", "2000"));
            const std::string gamma = value("gamma");
            const std::string generations = value("generations");
            const test::ConsoleRecord console;
            EXPECT_FALSE(planner_.params().setParam("gamma", "0,5"));
            EXPECT_FALSE(planner_.params().setParam("slices", "1.000"));
            EXPECT_FALSE(planner_.params().setParam("slices", "1001"));
            EXPECT_TRUE(console.mentions("1001"));
            MFA made(problem_->si);
            EXPECT_EQ(made.params()["generations"].getRangeSuggestion(), "1:1:100000");
            std::locale::global(before);
            EXPECT_EQ(gamma, "0.125");
            EXPECT_EQ(generations, "2000");
            EXPECT_EQ(planner_.getGamma(), 0.125);
            EXPECT_EQ(planner_.getGenerations(), 2000U);
        }

        TEST_F(Parameters, TheyAreObeyed)
        {
            const auto planner = problem_->planner(test::PlannerVariant::Paper);
            planner->setPopulationSize(13);
            planner->setSlices(4);
            planner->solve(test::afterCalls(500));
            EXPECT_EQ(planner->getSwarmPaths().size(), 13U);
            EXPECT_EQ(planner->getSwarmPaths().front().getStateCount(), 4U + 2U);
            EXPECT_EQ(planner->getSlicePaths().size(), 4U);
        }

        /* A search keeps the parameters with which it began. */
        TEST_F(Parameters, AChangeBetweenTwoSolvesWaitsForTheNextQuery)
        {
            const auto planner = problem_->planner(test::PlannerVariant::Default);
            planner->setTightening(false);
            ASSERT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            planner->solve(test::afterCalls(2000));
            planner->setTightening(true);
            EXPECT_TRUE(planner->getTightening());
            planner->solve(test::afterCalls(2000));
            EXPECT_EQ(planner->shares().at("tightening"), 0.0);
            planner->clear();
            EXPECT_TRUE(planner->getTightening());
            planner->solve(test::afterCalls(2000));
            EXPECT_GT(planner->shares().at("tightening"), 0.0);
        }

        TEST_F(Parameters, ANewQueryTakesWhatWasSet)
        {
            const auto planner = problem_->planner(test::PlannerVariant::Default);
            planner->setTightening(false);
            planner->solve(test::afterCalls(2000));
            planner->setTightening(true);
            problem_->pdef->setGoalState(problem_->state({9.0, 2.0}));
            planner->solve(test::afterCalls(2000));
            EXPECT_GT(planner->shares().at("tightening"), 0.0);
        }

        TEST_F(Parameters, WhatIsSetBetweenTwoSolvesDoesNotChangeTheSearch)
        {
            const auto run = [this](bool disturbed)
            {
                problem_->pdef->clearSolutionPaths();
                const auto planner = problem_->planner(test::PlannerVariant::Default, 3);
                planner->solve(test::afterCalls(6000));
                if (disturbed)
                {
                    planner->setVariant("fa");
                    planner->setFireflies(false);
                    planner->setPopulationSize(7);
                    planner->setSlices(3);
                    planner->setGenerations(2);
                    planner->setGamma(3.0);
                    planner->setAlpha(1.0);
                    planner->setEta(0.1);
                    planner->setGuide("none");
                    planner->setRecombination(false);
                    planner->setTightening(false);
                    planner->setSeed(0);
                    planner->setThreads(2);
                }
                planner->solve(test::afterCalls(6000));
                std::vector<double> result;
                for (const auto &share : planner->shares())
                {
                    result.push_back(share.second);
                }
                result.push_back(planner->bestCost());
                result.push_back(static_cast<double>(planner->evaluations()));
                result.push_back(static_cast<double>(planner->iterations()));
                return result;
            };
            EXPECT_EQ(run(true), run(false));
        }

        TEST_F(Parameters, BothVariantsSolve)
        {
            for (const char *variant : {"fa", "mfa"})
            {
                const auto planner = problem_->planner(test::PlannerVariant::Paper);
                planner->setVariant(variant);
                problem_->pdef->clearSolutionPaths();
                EXPECT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            }
        }

        /* The table of the documentation has a row `| `name` | default | range | unit | meaning | ...` for each
           parameter. */
        TEST_F(Parameters, EachIsInTheDocumentationWithItsDefaultItsRangeAndItsMeaning)
        {
            std::ifstream in(OMPL_MFA_SOURCE_DIR "/docs/planner.md");
            ASSERT_TRUE(in) << "docs/planner.md is missing";
            std::map<std::string, std::vector<std::string>> rows;
            for (std::string line; std::getline(in, line);)
            {
                const auto cells = split(line, '|');
                if (cells.size() > 5 && cells[1].size() > 4 && cells[1].substr(0, 2) == " `")
                {
                    rows[cells[1].substr(2, cells[1].size() - 4)] = cells;
                }
            }
            const auto compare = [&](const auto &parameter)
            {
                const std::string &name = parameter.name;
                ASSERT_EQ(rows.count(name), 1U) << name << " is not in the table";
                EXPECT_EQ(rows[name][2],
                          ' ' + parameter.accepted.write(engine::SearchSettings().*parameter.member) + ' ')
                    << name;
                EXPECT_EQ(rows[name][3], ' ' + parameter.accepted.description() + ' ') << name;
                EXPECT_EQ(rows[name][5], ' ' + parameter.meaning + ' ') << name;
                EXPECT_TRUE(planner_.params().hasParam(name));
                EXPECT_EQ(value(name), parameter.accepted.write(engine::SearchSettings().*parameter.member));
                rows.erase(name);
            };
            for (const auto &parameter : mfaParameters())
            {
                std::visit(compare, parameter);
            }
            EXPECT_EQ(planner_.params().size(), mfaParameters().size());
            for (const auto &row : rows)
            {
                ADD_FAILURE() << row.first << " is in the table, but no parameter";
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
