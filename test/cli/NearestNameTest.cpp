#include "cli/NearestName.h"

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

using ompl_mfa::cli::describeUnknown;
using ompl_mfa::cli::requireKnown;

TEST(NearestName, guessesOnlyWhatIsClose)
{
    EXPECT_EQ(describeUnknown("planner", "rrtstr", {"bitstar", "rrtstar"}),
              "unknown planner 'rrtstr'; did you mean 'rrtstar'? accepted: bitstar, rrtstar");
    EXPECT_EQ(describeUnknown("planner", "xyz", {"bitstar", "rrtstar"}),
              "unknown planner 'xyz'; accepted: bitstar, rrtstar");
    EXPECT_EQ(describeUnknown("planner", "", {"a"}), "unknown planner ''; did you mean 'a'? accepted: a");
}

TEST(NearestName, throwsOnlyForUnknownNames)
{
    EXPECT_NO_THROW(requireKnown("planner", "a", {"a", "b"}));
    EXPECT_THROW(requireKnown("planner", "c", {"a", "b"}), ompl_mfa::InputError);
}
