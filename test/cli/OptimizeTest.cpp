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

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/PdfText.h"
#include "cli/RunProgram.h"

namespace ompl_mfa::cli
{
    namespace
    {
        nlohmann::json optimize(const std::string &arguments)
        {
            const ProgramResult result = runProgram("optimize --json " + arguments);
            EXPECT_EQ(result.status, 0) << result.err;
            EXPECT_EQ(result.err, "");
            return nlohmann::json::parse(result.out);
        }
    }  // namespace

    TEST(Optimize, ReproducesThePapersStudyOfEquation19)
    {
        const auto document = optimize("--function sinc --algorithm fa,mfa --runs 30");
        ASSERT_EQ(document["results"].size(), 2U);
        const auto &fa = document["results"][0];
        const auto &mfa = document["results"][1];
        EXPECT_EQ(fa["algorithm"], "fa");
        EXPECT_EQ(mfa["algorithm"], "mfa");
        EXPECT_EQ(mfa["function"], "sinc");
        EXPECT_EQ(mfa["runs"], 30);
        EXPECT_NEAR(mfa["best_median"].get<double>(), 1.0, 1e-9);
        EXPECT_GE(mfa["share_near_optimum_median"].get<double>(), 0.95);
        EXPECT_LT(fa["share_near_optimum_median"].get<double>(), 0.5);
        EXPECT_EQ(fa["evaluations"].get<double>(), 100.0 + 50 * 99);
        EXPECT_LE(mfa["evaluations"].get<double>(), 100.0 + 50 * 599);
    }

    TEST(Optimize, MinimisesTheOtherFunctions)
    {
        for (const std::string function : {"ackley", "rastrigin", "griewank", "rosenbrock", "levy"})
        {
            const auto document = optimize("--algorithm mfa --runs 3 --function " + function);
            EXPECT_NEAR(document["results"][0]["best_median"].get<double>(), 0.0, 1e-2) << function;
        }
    }

    TEST(Optimize, RepeatsWithItsSeed)
    {
        const std::string arguments = "optimize --json --function schwefel --dimension 5 --runs 2 --seed ";
        EXPECT_EQ(runProgram(arguments + "7").out, runProgram(arguments + "7").out);
        EXPECT_NE(runProgram(arguments + "7").out, runProgram(arguments + "8").out);
    }

    TEST(Optimize, PrintsATable)
    {
        const ProgramResult result = runProgram("optimize --runs 2 --population 20 --generations 5");
        EXPECT_EQ(result.status, 0);
        for (const std::string word : {"algorithm", "share near optimum", "\nfa ", "\nmfa "})
        {
            EXPECT_NE(result.out.find(word), std::string::npos) << word;
        }
    }

    TEST(Optimize, DrawsAPanelForEachAlgorithm)
    {
        const std::string file = temporaryFile("populations.svg");
        EXPECT_EQ(runProgram("optimize --runs 3 --picture '" + file + "'").status, 0);
        const std::string svg = readFile(file);
        std::remove(file.c_str());
        const std::string fill = "fill:rgb(94.901961%,55.686275%,16.862745%)";
        std::size_t circles = 0;
        for (std::size_t at = svg.find(fill); at != std::string::npos; at = svg.find(fill, at + 1))
        {
            ++circles;
        }
        EXPECT_GE(circles, 200U) << "every firefly of both algorithms";
        const std::string pdf = temporaryFile("populations.pdf");
        EXPECT_EQ(runProgram("optimize --runs 3 --picture '" + pdf + "'").status, 0);
        const std::string text = pdfText(pdf);
        std::remove(pdf.c_str());
        for (const std::string word :
             {"FA on sinc: ", "MFA on sinc: ", "fireflies at the end", "near the global optimum"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
    }

    TEST(Optimize, RefusesWhatItCannotUse)
    {
        expectBadInput("optimize --function sync", {"function", "sync", "did you mean 'sinc'", "rastrigin"});
        expectBadInput("optimize --algorithm mfa,pso", {"pso", "fa, mfa"});
        expectBadInput("optimize --runs 0", {"--runs", "0"});
        expectBadInput("optimize --runs many", {"--runs", "many"});
        expectBadInput("optimize --seed -1", {"--seed", "-1"});
        expectBadInput("optimize --gamma -1", {"gamma", "-1", "at least 0"});
        expectBadInput("optimize --alpha nan", {"alpha", "nan", "[0, 1]"});
        expectBadInput("optimize --population 3", {"populationSize", "3", "at least 4"});
        expectBadInput("optimize --dimension 1 --function rosenbrock", {"dimension", "rosenbrock", "at least 2"});
        expectBadInput("optimize --dimension 3 --picture x.svg", {"--picture", "3", "2 dimensions"});
        expectBadInput("optimize --runs 1000000 --picture x.jpg", {"x.jpg", ".svg, .png or .pdf"});
        expectBadInput("optimize --runs 1 --picture /no/such/folder/x.svg", {"/no/such/folder/x.svg"});
    }

    TEST(Program, NamesWhatItAcceptsInsteadOfAnUnknownName)
    {
        expectBadInput("optimise", {"command", "optimise", "did you mean 'optimize'"});
        expectBadInput("optimize --picure x", {"option", "--picure", "did you mean '--picture'"});
        expectBadInput("optimize stray", {"stray"});
        expectBadInput("", {"--help"});
    }

    TEST(Program, PrintsHelpAndVersion)
    {
        EXPECT_EQ(runProgram("--help").status, 0);
        EXPECT_NE(runProgram("--help").out.find("optimize"), std::string::npos);
        EXPECT_EQ(runProgram("--version").status, 0);
        const std::string version = runProgram("--version").out;
        EXPECT_EQ(version.rfind("ompl_mfa ", 0), 0U);
        for (const char *library : {"\nOMPL ", "\nFCL ", "\nEigen "})
        {
            EXPECT_NE(version.find(library), std::string::npos) << version;
        }
    }
}  // namespace ompl_mfa::cli
