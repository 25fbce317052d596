#include "ompl_mfa/optimizer/RandomSource.h"

#include <vector>

#include <gtest/gtest.h>

using ompl_mfa::RandomSource;

TEST(RandomSource, isTheSameOnEveryPlatform)
{
    // The C++ standard fixes the 10000th output of a default-seeded mt19937_64 at 9981545732273789042.
    RandomSource random(5489U);
    for (int i = 1; i < 10000; ++i)
        random.uniform();
    EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042ULL >> 11U) / 9007199254740992.0);
}

TEST(RandomSource, staysWithinItsIntervals)
{
    RandomSource random(1);
    std::vector<int> counts(7, 0);
    double sum = 0.0;
    for (int i = 0; i < 70000; ++i)
    {
        const double value = random.uniform();
        ASSERT_GE(value, 0.0);
        ASSERT_LT(value, 1.0);
        sum += value;
        const unsigned int index = random.index(7);
        ASSERT_LT(index, 7U);
        ++counts[index];
    }
    EXPECT_NEAR(sum / 70000, 0.5, 0.01);
    for (const int count : counts)
        EXPECT_NEAR(count, 10000, 500);
}
