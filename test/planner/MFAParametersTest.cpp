#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/util/Exception.h>

#include "planner/ConsoleRecord.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
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
                EXPECT_TRUE(planner_.params().hasParam(name)) << name;
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
                parts.push_back(part);
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
                    ends = {ends.front(), ends.back()};
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
                    continue;
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

        TEST_F(Parameters, TheyAreObeyed)
        {
            const auto planner = problem_->planner(test::Engine::Paper);
            planner->setPopulationSize(13);
            planner->setSlices(4);
            planner->solve(test::afterCalls(500));
            EXPECT_EQ(planner->getSwarmPaths().size(), 13U);
            EXPECT_EQ(planner->getSwarmPaths().front().getStateCount(), 4U + 2U);
            EXPECT_EQ(planner->getSlicePaths().size(), 4U);
        }

        TEST_F(Parameters, BothVariantsSolve)
        {
            for (const char *variant : {"fa", "mfa"})
            {
                const auto planner = problem_->planner(test::Engine::Paper);
                planner->setVariant(variant);
                problem_->pdef->clearSolutionPaths();
                EXPECT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            }
        }

        /* The numbers, or the words, of a text. */
        std::vector<std::string> accepted(const std::string &text, const std::string &separators)
        {
            std::vector<std::string> parts(1);
            for (const char c : text)
            {
                if (separators.find(c) == std::string::npos)
                    parts.back() += c;
                else if (!parts.back().empty())
                    parts.emplace_back();
            }
            if (parts.back().empty())
                parts.pop_back();
            return parts;
        }

        /* Whether a range of the documentation ("1 to 100", "0, 4 to 100", "a, b") is what a parameter declares. */
        bool documents(const std::string &cell, const std::string &range)
        {
            if (range.find(':') == std::string::npos)
                return accepted(cell, " ,") == accepted(range, ",");
            auto documented = accepted(cell, " ,");
            const auto declared = split(range, ':');
            return documented.size() >= 3 && documented[documented.size() - 2] == "to" &&
                   std::stod(documented.front()) == std::stod(declared.front()) &&
                   std::stod(documented.back()) == std::stod(declared.back());
        }

        /* The table of the documentation has a row `| `name` | default | range | ...` for each parameter. */
        TEST_F(Parameters, EachIsInTheDocumentationWithItsDefaultAndRange)
        {
            std::ifstream in(OMPL_MFA_SOURCE_DIR "/docs/planner.md");
            ASSERT_TRUE(in) << "docs/planner.md is missing";
            std::map<std::string, std::vector<std::string>> rows;
            for (std::string line; std::getline(in, line);)
            {
                const auto cells = split(line, '|');
                if (cells.size() > 5 && cells[1].size() > 4 && cells[1].substr(0, 2) == " `")
                    rows[cells[1].substr(2, cells[1].size() - 4)] = cells;
            }
            for (const auto &[name, parameter] : planner_.params().getParams())
            {
                ASSERT_EQ(rows.count(name), 1U) << name << " is not in the table";
                EXPECT_TRUE(documents(rows[name][3], parameter->getRangeSuggestion()))
                    << name << ": " << rows[name][3] << " is not " << parameter->getRangeSuggestion();
                const std::string defaultCell = rows[name][2];
                const std::string shown = defaultCell.substr(1, defaultCell.size() - 2);
                const std::string actual = parameter->getValue();
                const bool number = actual.find_first_not_of("0123456789.-+e") == std::string::npos;
                if (number)
                {
                    EXPECT_DOUBLE_EQ(std::stod(shown), std::stod(actual)) << name;
                }
                else
                {
                    EXPECT_EQ(shown, actual) << name;
                }
                rows.erase(name);
            }
            for (const auto &row : rows)
                ADD_FAILURE() << row.first << " is in the table, but no parameter";
        }
    }  // namespace
}  // namespace ompl_mfa
