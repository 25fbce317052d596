#include "text/NearestName.h"

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

using ompl_mfa::describeUnknown;
using ompl_mfa::requireKnown;

TEST(NearestName, IsTheLeastEditedOne)
{
    const std::vector<std::string> known = {"rrtconnect", "rrtstar", "prm", "prmstar"};
    EXPECT_EQ(ompl_mfa::nearestName("rrtconect", known), "rrtconnect");
    EXPECT_EQ(ompl_mfa::nearestName("prm*", known), "prm");
    EXPECT_EQ(ompl_mfa::nearestName("rttstar", known), "rrtstar");
    EXPECT_EQ(ompl_mfa::nearestName("rrt", known), "rrtstar");
    EXPECT_EQ(ompl_mfa::nearestName("", known), "");
    EXPECT_EQ(ompl_mfa::nearestName("zzzzzzzzzzzzzzzz", known), "");
}

TEST(NearestName, GuessesOnlyWhatIsClose)
{
    EXPECT_EQ(describeUnknown("planner", "rrtstr", {"bitstar", "rrtstar"}),
              "unknown planner 'rrtstr'; did you mean 'rrtstar'? accepted: bitstar, rrtstar");
    EXPECT_EQ(describeUnknown("planner", "xyz", {"bitstar", "rrtstar"}),
              "unknown planner 'xyz'; accepted: bitstar, rrtstar");
    EXPECT_EQ(describeUnknown("planner", "", {"a"}), "unknown planner ''; did you mean 'a'? accepted: a");
}

TEST(NearestName, ThrowsOnlyForUnknownNames)
{
    EXPECT_NO_THROW(requireKnown("planner", "a", {"a", "b"}));
    EXPECT_THROW(requireKnown("planner", "c", {"a", "b"}), ompl_mfa::InputError);
}
