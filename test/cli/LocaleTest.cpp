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

#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <CLI/CLI.hpp>

#include "ForeignLocale.h"
#include "cli/Commands.h"
#include "cli/ConfigFixture.h"
#include "cli/Figure.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /** \brief Removes the numbers of surfaces, which Cairo counts over the life of a process. */
        std::string withoutSurface(const std::string &svg)
        {
            return std::regex_replace(svg, std::regex("id=\"surface[0-9]+\""), "");
        }

        /** \brief Runs commands in the process of the test, whose locale it can set. */
        class Locale : public ConfigFixture
        {
        protected:
            Locale()
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
                config("start.x = 1.25\nstart.y = 3\n", "mfa_paper =\nmfa_paper.slices = 5\n");
            }

            ~Locale() override
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_DEBUG);
            }

            /** \brief The output of a command, with the error message if it fails. */
            static std::string printed(std::vector<std::string> arguments)
            {
                CLI::App app{"test", "ompl_mfa"};
                addBenchmarkCommand(app);
                addCheckCommand(app);
                addOptimizeCommand(app);
                addPlanCommand(app);
                std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
                std::string message;
                testing::internal::CaptureStdout();
                try
                {
                    app.parse(reversed);
                }
                catch (const CLI::RuntimeError &)
                {
                    message = "";
                }
                catch (const std::exception &error)
                {
                    message = error.what();
                }
                return testing::internal::GetCapturedStdout() + message;
            }

            /** \brief Output and files of the commands, without values that depend on a clock. */
            std::string everything() const
            {
                const std::string file = path("a.cfg");
                // the time of a state check varies, its format does not
                const std::regex checkTime(R"((check +|state_check_time"?[:=] ?)[0-9]+\.?[0-9]*(e-[0-9]+)?)");
                std::string all = std::regex_replace(printed({"check", file}) + printed({"check", file, "--json"}),
                                                     checkTime, "$1TIME");
                all +=
                    printed({"optimize", "--runs", "1", "--generations", "2", "--population", "1200", "--gamma", "0.5",
                             "--alpha", "0.25", "--eta", "1.5", "--dimension", "2", "--picture", path("swarm.svg")});
                const std::string plan = printed({"plan", file, "--planner", "mfa_paper", "--iterations", "2000",
                                                  "--time", "60.5", "--parameter", "population_size=12", "--path",
                                                  path("a.path"), "--picture", path("a.svg")});
                all += plan.substr(0, plan.find("time to first solution"));
                all += plan.substr(plan.find("states "));
                for (const char *name : {"swarm.svg", "a.path", "a.svg"})
                {
                    EXPECT_NE(readFile(path(name)), "") << name;
                    all += withoutSurface(readFile(path(name)));
                    std::filesystem::remove(path(name));
                }
                all += printed({"plan", file, "--time", "0,5"}) + printed({"plan", file, "--time", "-1234567.5"});
                all += printed({"benchmark", file, "--grace", "0,5"}) + printed({"optimize", "--gamma", "1,5"});
                return all + printed({"optimize", "--alpha", "1234.5"});
            }
        };
    }  // namespace

    TEST_F(Locale, CommandsReadAndWriteTheSameWhateverStreamsTakeForNumbers)
    {
        const std::string expected = everything();
        EXPECT_NE(expected.find("--time -1234567.5: "), std::string::npos) << expected.substr(expected.size() - 600);
        EXPECT_NE(expected.find("alpha = 1234.5 "), std::string::npos);
        for (const char *refused : {"--time 0,5: ", "--grace 0,5: ", "--gamma 1,5: "})
        {
            EXPECT_NE(expected.find(refused), std::string::npos) << expected.substr(expected.size() - 600);
        }
        const test::ForeignStreams foreign;
        EXPECT_EQ(everything(), expected);
    }

    TEST_F(Locale, CommandsReadAndWriteTheSameWhateverTheLibraryTakesForNumbers)
    {
        const std::string expected = everything();
        const test::ForeignLibrary foreign;
        if (!foreign.isThere())
        {
            GTEST_SKIP() << "there is no locale de_DE.UTF-8, and it cannot be compiled";
        }
        EXPECT_EQ(everything(), expected);
    }

    TEST_F(Locale, PicturesHavePointsInTheirNumbers)
    {
        Axes axes("title", "x (m)", "y (m)", {0.0, 0.0}, {12000.0, 900.5});
        axes.addPolyline({{0.0, 0.0}, {6000.5, 0.25}}, {0x000000, 0.75, std::nullopt, 0.5}, "a line");
        axes.addMarkers({{10.0, 0.25}}, 2.5, {0x000000, 0.75, std::nullopt, 0.5}, "a point");
        Figure figure;
        figure.addAxes(axes);
        for (const auto format : {PictureFormat::SVG, PictureFormat::PNG, PictureFormat::PDF})
        {
            const std::string expected = withoutSurface(figure.render(format));
            test::inForeignLocales([&](const char *where)
                                   { EXPECT_EQ(withoutSurface(figure.render(format)), expected) << where; });
        }
    }
}  // namespace ompl_mfa::cli
