#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/RunProgram.h"

TEST(Planners, listsEveryPlannerWithItsParameters)
{
    const ProgramResult result = runProgram("planners --json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const auto document = nlohmann::json::parse(result.out);
    std::set<std::string> names;
    for (const auto &planner : document["planners"])
    {
        names.insert(planner["name"].get<std::string>());
        for (const auto &parameter : planner["parameters"])
            for (const char *key : {"name", "type", "range", "default"})
                EXPECT_TRUE(parameter.contains(key)) << planner["name"] << " " << key;
    }
    for (const char *name : {"mfa", "mfa_paper", "fa_paper", "aps", "informedrrtstar", "rrtconnect"})
        EXPECT_EQ(names.count(name), 1U) << name;
}

TEST(Planners, listsOnlyThoseThatAreAskedFor)
{
    const ProgramResult result = runProgram("planners rrt mfa");
    ASSERT_EQ(result.status, 0);
    EXPECT_EQ(result.out.find("prm"), std::string::npos);
    EXPECT_NE(result.out.find("goal_bias"), std::string::npos);
    EXPECT_NE(result.out.find("0.:.05:1."), std::string::npos);
    EXPECT_NE(result.out.find("population_size"), std::string::npos);
}

TEST(Planners, namesTheNearestKnownPlanner)
{
    expectBadInput("planners rrtconect", {"rrtconect", "rrtconnect"});
}
