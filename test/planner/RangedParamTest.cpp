#include "ompl_mfa/planner/RangedParam.h"

#include <string>

#include <gtest/gtest.h>

#include "planner/ConsoleRecord.h"

namespace ompl_mfa
{
    namespace
    {
        class RangedParamTest : public ::testing::Test
        {
        protected:
            RangedParam<double> parameter_{"share",
                                           [this](const double &value)
                                           {
                                               if (value == 0.7)
                                                   throw ompl::Exception("share must not be 0.7");
                                               value_ = value;
                                           },
                                           [this] { return value_; }, "0.0:0.1:1.0"};
            double value_{0.5};
        };

        TEST_F(RangedParamTest, SetsAndReadsBack)
        {
            EXPECT_EQ(parameter_.getName(), "share");
            EXPECT_EQ(parameter_.getRangeSuggestion(), "0.0:0.1:1.0");
            EXPECT_TRUE(parameter_.setValue("0.25"));
            EXPECT_EQ(value_, 0.25);
            EXPECT_EQ(std::stod(parameter_.getValue()), 0.25);
        }

        TEST_F(RangedParamTest, AValueOutOfRangeIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            EXPECT_FALSE(parameter_.setValue("1.5"));
            EXPECT_FALSE(parameter_.setValue("nan"));
            EXPECT_EQ(value_, 0.5);
            EXPECT_TRUE(console.mentions("share"));
            EXPECT_TRUE(console.mentions("1.5"));
            EXPECT_TRUE(console.mentions("0.0:0.1:1.0"));
        }

        TEST_F(RangedParamTest, AValueThatItsSetterRefusesIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            EXPECT_FALSE(parameter_.setValue("0.7"));
            EXPECT_EQ(value_, 0.5);
            EXPECT_TRUE(console.mentions("share must not be 0.7"));
        }

        TEST_F(RangedParamTest, ANegativeNumberIsNoLargeUnsignedOne)
        {
            unsigned int count = 3;
            RangedParam<unsigned int> parameter(
                "count", [&count](const unsigned int &value) { count = value; }, [&count] { return count; },
                "0:1:4294967295");
            const test::ConsoleRecord console;
            EXPECT_FALSE(parameter.setValue("-1"));
            EXPECT_EQ(count, 3U);
            EXPECT_TRUE(parameter.setValue("4294967295"));
        }

        TEST_F(RangedParamTest, AValueOfAnotherTypeIsRefusedOnTheConsole)
        {
            const test::ConsoleRecord console;
            for (const char *value : {"", "much", "0.5x", "0,5"})
                EXPECT_FALSE(parameter_.setValue(value)) << value;
            EXPECT_EQ(value_, 0.5);
            EXPECT_TRUE(console.mentions("much"));
            EXPECT_TRUE(console.mentions("0.0:0.1:1.0"));
        }
    }  // namespace
}  // namespace ompl_mfa
