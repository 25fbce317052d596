#include "engine/Incumbent.h"

#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        class IncumbentTest : public ::testing::Test
        {
        protected:
            IncumbentTest()
            {
                incumbent_.reset(std::make_shared<ob::PathLengthOptimizationObjective>(si_));
                path_.resize(3);
                for (std::size_t i = 0; i < 3; ++i)
                    path_[i]->as<ob::RealVectorStateSpace::StateType>()->values[0] = static_cast<double>(i);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(1);
            ob::SpaceInformationPtr si_ = std::make_shared<ob::SpaceInformation>(space_);
            Incumbent incumbent_{space_};
            Waypoints path_{space_};
        };

        TEST_F(IncumbentTest, KnowsNothingAtFirst)
        {
            EXPECT_FALSE(incumbent_.hasPath());
            EXPECT_EQ(incumbent_.cost(), NEVER);
            EXPECT_EQ(incumbent_.partialDistance(), NEVER);
            EXPECT_TRUE(incumbent_.improvedBy(1e300));
        }

        TEST_F(IncumbentTest, KeepsTheBetterPath)
        {
            EXPECT_TRUE(incumbent_.offer(path_, 5.0));
            path_.resize(2);
            EXPECT_FALSE(incumbent_.offer(path_, 5.0));
            EXPECT_FALSE(incumbent_.offer(path_, 6.0));
            EXPECT_EQ(incumbent_.path().size(), 3U);
            EXPECT_TRUE(incumbent_.offer(path_, 4.0));
            EXPECT_EQ(incumbent_.path().size(), 2U);
            EXPECT_EQ(incumbent_.cost(), 4.0);
        }

        TEST_F(IncumbentTest, TheObjectiveSaysWhatIsBetter)
        {
            incumbent_.reset(std::make_shared<ob::MaximizeMinClearanceObjective>(si_));
            EXPECT_TRUE(incumbent_.offer(path_, 1.0));
            EXPECT_TRUE(incumbent_.improvedBy(2.0));
            EXPECT_FALSE(incumbent_.improvedBy(0.5));
        }

        TEST_F(IncumbentTest, KeepsThePartialPathThatEndsNearest)
        {
            EXPECT_TRUE(incumbent_.offerPartial(path_, 1, path_[1], 3.0));
            EXPECT_EQ(incumbent_.partialPath().size(), 2U);
            EXPECT_FALSE(incumbent_.offerPartial(path_, 2, path_[2], 3.0));
            EXPECT_TRUE(incumbent_.offerPartial(path_, 2, path_[2], 1.0));
            EXPECT_EQ(incumbent_.partialPath().size(), 3U);
            EXPECT_EQ(incumbent_.partialDistance(), 1.0);
            EXPECT_FALSE(incumbent_.hasPath());
        }

        TEST_F(IncumbentTest, ResetForgetsBoth)
        {
            incumbent_.offer(path_, 5.0);
            incumbent_.offerPartial(path_, 1, path_[1], 3.0);
            incumbent_.reset(nullptr);
            EXPECT_FALSE(incumbent_.hasPath());
            EXPECT_TRUE(incumbent_.partialPath().empty());
            EXPECT_EQ(incumbent_.cost(), NEVER);
        }
    }  // namespace
}  // namespace ompl_mfa
