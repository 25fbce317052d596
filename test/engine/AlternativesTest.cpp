#include "engine/Alternatives.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "path/StateSpaces.h"

namespace ompl_mfa
{
    namespace
    {
        class AlternativesTest : public ::testing::Test
        {
        protected:
            void add(double y)
            {
                alternatives_.add(test::planarPath(space_, {{0.0, 0.0}, {1.0, y}, {2.0, 0.0}}));
            }

            /* What distinguishes the paths that are kept. */
            std::set<double> kept() const
            {
                std::set<double> heights;
                for (std::size_t i = 0; i < alternatives_.size(); ++i)
                {
                    EXPECT_EQ(alternatives_[i].size(), 3U);
                    std::vector<double> values;
                    space_->copyToReals(values, alternatives_[i][1]);
                    heights.insert(values[1]);
                }
                return heights;
            }

            ompl::base::StateSpacePtr space_ = test::realVectorSpace(2);
            Alternatives alternatives_;
        };

        TEST_F(AlternativesTest, AreCopiesOfThePathsThatWereAdded)
        {
            EXPECT_EQ(alternatives_.size(), 0U);
            Waypoints path = test::planarPath(space_, {{0.0, 0.0}, {1.0, 0.5}, {2.0, 0.0}});
            alternatives_.add(path);
            path.clear();
            ASSERT_EQ(alternatives_.size(), 1U);
            EXPECT_EQ(kept(), (std::set<double>{0.5}));
        }

        TEST_F(AlternativesTest, ThreeAreKeptAndTheOldestMakesRoom)
        {
            for (const double y : {0.5, 1.0, 1.5})
                add(y);
            EXPECT_EQ(kept(), (std::set<double>{0.5, 1.0, 1.5}));
            add(2.0);
            EXPECT_EQ(kept(), (std::set<double>{1.0, 1.5, 2.0}));
            add(2.5);
            add(3.0);
            add(3.5);
            EXPECT_EQ(kept(), (std::set<double>{2.5, 3.0, 3.5}));
            EXPECT_EQ(alternatives_.size(), 3U);
        }
    }  // namespace
}  // namespace ompl_mfa
