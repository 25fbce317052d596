#include "engine/guides/HyperspheroidCache.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa
{
    namespace
    {
        Eigen::VectorXd point(Eigen::Index dimension, double x)
        {
            return Eigen::VectorXd::Constant(dimension, x);
        }

        TEST(HyperspheroidCache, KeepsThoseOfAThousandGoals)
        {
            constexpr std::size_t GOALS = 1000;
            HyperspheroidCache cache(16);
            ASSERT_GE(cache.capacity(), GOALS);
            std::vector<ompl::ProlateHyperspheroidPtr> first;
            for (int turn = 0; turn < 3; ++turn)
            {
                for (std::size_t j = 0; j < GOALS; ++j)
                {
                    const auto kept = cache.of(j, point(16, -1.0), point(16, static_cast<double>(j)));
                    EXPECT_DOUBLE_EQ(kept->getMinTransverseDiameter(), 4.0 * (static_cast<double>(j) + 1.0));
                    if (turn == 0)
                        first.push_back(kept);
                    EXPECT_EQ(kept, first[j]);
                }
            }
            EXPECT_EQ(cache.size(), GOALS);
        }

        TEST(HyperspheroidCache, IsBoundedHoweverManyPairsThereAre)
        {
            for (const Eigen::Index dimension : {2, 16, 100})
            {
                HyperspheroidCache cache(dimension);
                for (std::size_t j = 0; j < std::min<std::size_t>(2 * cache.capacity(), 6000); ++j)
                    cache.of(j, point(dimension, -1.0), point(dimension, static_cast<double>(j)));
                EXPECT_LE(cache.size(), cache.capacity());
                // two matrices of d^2 numbers each
                EXPECT_LE(cache.capacity() * static_cast<std::size_t>(2 * dimension * dimension), 1000000U);
            }
        }

        TEST(HyperspheroidCache, IsThatOfTheFociWhateverTheNumberOfThePairWasBefore)
        {
            HyperspheroidCache cache(2);
            EXPECT_DOUBLE_EQ(cache.of(0, point(2, 0.0), Eigen::Vector2d(3.0, 4.0))->getMinTransverseDiameter(), 5.0);
            EXPECT_DOUBLE_EQ(cache.of(0, point(2, 0.0), Eigen::Vector2d(6.0, 8.0))->getMinTransverseDiameter(), 10.0);
            EXPECT_EQ(cache.size(), 1U);
        }
    }  // namespace
}  // namespace ompl_mfa
