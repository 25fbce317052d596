#include "ompl_mfa/path/SliceObjective.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* From (-4, 0) to (4, 0) with one slice at x = 0, where |y| < 1 is forbidden. */
        class SliceObjectiveTest : public ::testing::Test
        {
        protected:
            SliceObjectiveTest()
              : frame_(makeFrame())
            {
            }

            SliceFrame makeFrame() const
            {
                ob::ScopedState<> start(space_);
                ob::ScopedState<> goal(space_);
                start[0] = -4.0;
                goal[0] = 4.0;
                start[1] = goal[1] = 0.0;
                return SliceFrame::straight(std::make_shared<const StateChart>(space_), start.get(), goal.get(), 2);
            }

            static bool isValid(const ob::State *state)
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::hypot(values[0], values[1]) > 1.0;
            }

            static Eigen::VectorXd offset(double y)
            {
                return Eigen::VectorXd::Constant(1, y);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, isValid};
            PathEvaluator evaluator_{problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
            SliceFrame frame_;
            std::vector<double> valid_;
            SliceObjective objective_{frame_, nullptr, evaluator_,
                                      [this](const Waypoints &path, const Brightness &brightness)
                                      {
                                          EXPECT_EQ(path.size(), 3U);
                                          valid_.push_back(brightness.cost);
                                      }};
        };

        TEST_F(SliceObjectiveTest, EvaluatesThePathAtItsCoordinates)
        {
            const Brightness brightness = objective_.evaluate(offset(3.0), nullptr);
            EXPECT_TRUE(brightness.isFeasible());
            EXPECT_DOUBLE_EQ(brightness.cost, 10.0);
            const Brightness invalid = objective_.evaluate(offset(0.0), nullptr);
            EXPECT_NEAR(invalid.violation, 2.0, 4.0 * 0.01 * space_->getMaximumExtent());
        }

        TEST_F(SliceObjectiveTest, ReportsValidPathsOnly)
        {
            objective_.evaluate(offset(0.0), nullptr);
            EXPECT_TRUE(valid_.empty());
            const Brightness rival = objective_.evaluate(offset(3.0), nullptr);
            EXPECT_EQ(valid_, (std::vector<double>{10.0}));
            objective_.evaluate(offset(-4.0), &rival);
            EXPECT_EQ(valid_.size(), 1U);
        }

        TEST_F(SliceObjectiveTest, OrdersBrightnessAsTheObjectiveDoes)
        {
            EXPECT_TRUE(objective_.isBrighter({0.0, 1.0}, {0.0, 2.0}));
            PathEvaluator clearance(problem_.si, std::make_shared<ob::MaximizeMinClearanceObjective>(problem_.si));
            const SliceObjective wide(frame_, nullptr, clearance, {});
            EXPECT_TRUE(wide.isBrighter({0.0, 2.0}, {0.0, 1.0}));
        }
    }  // namespace
}  // namespace ompl_mfa
