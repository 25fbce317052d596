#include "anytime/PlannerText.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace anytime = ompl_mfa::anytime;
using Texts = std::vector<std::string>;

TEST(PlannerText, CommasSeparatePlannersAndParameters)
{
    EXPECT_EQ(anytime::splitPlanners("mfa,bitstar"), (Texts{"mfa", "bitstar"}));
    EXPECT_EQ(anytime::splitPlanners("mfa:slices=4,gamma=1,rrtstar,mfa:slices=5"),
              (Texts{"mfa:slices=4,gamma=1", "rrtstar", "mfa:slices=5"}));
    EXPECT_THROW(anytime::splitPlanners(""), ompl_mfa::InputError);
}

TEST(PlannerText, PeersStandForAllOfThem)
{
    const Texts all = anytime::splitPlanners("mfa,peers");
    for (const char *name : {"mfa", "rrtstar", "informedrrtstar", "prmstar", "bitstar", "abitstar", "aitstar",
                             "anytimepathshortening", "rrtconnect"})
        EXPECT_EQ(std::count(all.begin(), all.end(), name), 1) << name;
}

TEST(PlannerText, ParametersAreRead)
{
    const auto spec = anytime::parsePlanner("mfa:slices=4,gamma=1.5");
    EXPECT_EQ(spec.type, "mfa");
    ASSERT_EQ(spec.parameters.size(), 2U);
    EXPECT_EQ(spec.parameters[0].key, "slices");
    EXPECT_EQ(spec.parameters[0].value, "4");
    EXPECT_EQ(spec.parameters[1].key, "gamma");
    EXPECT_EQ(spec.parameters[1].value, "1.5");
}

TEST(PlannerText, RefusesWhatItDoesNotKnow)
{
    EXPECT_THROW(anytime::parsePlanner("mfaa"), ompl_mfa::InputError);
    EXPECT_THROW(anytime::parsePlanner("mfa:slices"), ompl_mfa::InputError);
    EXPECT_THROW(anytime::parsePlanner("mfa:=3"), ompl_mfa::InputError);
}
