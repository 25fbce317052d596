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
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"
#include "cli/RunProgram.h"

namespace
{
    class AnimateTest : public ConfigFixture
    {
    protected:
        /* The data of the page of a swarm. */
        nlohmann::json dataOf(const std::string &page) const
        {
            const std::string begin = "<script>const pageData = ";
            const std::size_t start = page.find(begin) + begin.size();
            return nlohmann::json::parse(page.substr(start, page.find(";</script>", start) - start));
        }
    };

    TEST_F(AnimateTest, PageHasEveryGenerationOfBothPlanners)
    {
        const ProgramResult result =
            runProgram("animate " + config() + " -o " + path("s.html") + " --generations 6 --seed 11");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("FA-paper: "), std::string::npos) << result.out;
        const std::string page = readFile(path("s.html"));
        const nlohmann::json data = dataOf(page);
        ASSERT_EQ(data["swarms"].size(), 2U);
        EXPECT_EQ(data["swarms"][0]["planner"], "FA-paper");
        EXPECT_EQ(data["swarms"][1]["planner"], "MFA-paper");
        EXPECT_EQ(data["obstacles"].size(), 1U);
        EXPECT_EQ(data["upper"], (nlohmann::json{10.0, 10.0}));
        for (const nlohmann::json &swarm : data["swarms"])
        {
            ASSERT_EQ(swarm["frames"].size(), 7U);
            const nlohmann::json &first = swarm["frames"].front();
            EXPECT_EQ(first["generation"], 0);
            EXPECT_EQ(swarm["frames"].back()["generation"], 6);
            EXPECT_EQ(first["paths"].size(), first["valid"].size());
            EXPECT_NE(first["paths"], swarm["frames"].back()["paths"]);
            double best = 1e9;
            for (const nlohmann::json &frame : swarm["frames"])
            {
                EXPECT_EQ(frame["paths"].size(), first["paths"].size());
                // from the start to the goal
                EXPECT_EQ(frame["paths"][0][0], 1.0);
                EXPECT_EQ(frame["paths"][0].back(), 3.0);
                if (frame.contains("cost"))
                {
                    EXPECT_LE(frame["cost"], best);
                    best = frame["cost"];
                }
            }
        }
        // a run of the same seed is the same
        runProgram("animate " + config() + " -o " + path("s.html") + " --generations 6 --seed 11");
        EXPECT_EQ(readFile(path("s.html")), page);
        runProgram("animate " + config() + " -o " + path("s.html") + " --generations 6 --seed 12");
        EXPECT_NE(dataOf(readFile(path("s.html"))), data);
    }

    TEST_F(AnimateTest, PictureIsAnimatedAndSmall)
    {
        const ProgramResult result =
            runProgram("animate " + config() + " -o " + path("s.svg") + " --planner mfa_paper --generations 30 --json");
        EXPECT_EQ(result.status, 0) << result.err;
        const nlohmann::json document = nlohmann::json::parse(result.out);
        ASSERT_EQ(document["planners"].size(), 1U);
        EXPECT_EQ(document["planners"][0]["generations"], 30);
        EXPECT_GT(document["planners"][0]["valid"], 0);
        const std::string svg = readFile(path("s.svg"));
        EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0U);
        EXPECT_NE(svg.find("<animate attributeName=\"points\""), std::string::npos);
        EXPECT_NE(svg.find("generation 30: "), std::string::npos);
        EXPECT_EQ(svg.find("<script"), std::string::npos);
        EXPECT_LE(svg.size(), 1000000U);
    }

    TEST_F(AnimateTest, ErrorsAreOneLine)
    {
        const std::string file = config();
        expectBadInput("animate " + file + " -o " + path("s.gif"), {"s.gif", ".html or .svg"});
        expectBadInput("animate " + file, {"--output"});
        expectBadInput("animate " + path("none.cfg") + " -o " + path("s.svg"), {"none.cfg"});
        expectBadInput("animate " + file + " -o " + path("s.svg") + " --planner rrtstar", {"RRTstar", "no swarm"});
        expectBadInput("animate " + file + " -o " + path("s.svg") + " --planner mfa_papr", {"mfa_papr", "mfa_paper"});
        expectBadInput("animate " + file + " -o " + path("s.svg") + " --generations 0", {"--generations"});
        expectBadInput("animate " + file + " -o " + path("no/s.svg"), {"--output", "cannot be written"});
        expectBadInput("animate " + config("start.x = 1\nstart.y = 9\n") + " -o " + path("s.svg"), {"no swarm"});
        EXPECT_FALSE(std::filesystem::exists(path("s.svg")));
    }
}  // namespace
