#include "ompl_mfa/path/PathTightening.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* An integral that depends on the direction too, and counts how often it is asked for. */
        class Counted : public ob::StateCostIntegralObjective
        {
        public:
            using StateCostIntegralObjective::StateCostIntegralObjective;

            ob::Cost stateCost(const ob::State *state) const override
            {
                const auto *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return ob::Cost(1.0 + std::abs(values[1]));
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                ++asked;
                const double rise = to->as<ob::RealVectorStateSpace::StateType>()->values[1] -
                                    from->as<ob::RealVectorStateSpace::StateType>()->values[1];
                return ob::Cost(StateCostIntegralObjective::motionCost(from, to).value() + std::max(0.0, rise));
            }

            mutable std::uint64_t asked{0};
        };

        class PathTighteningTest : public ::testing::Test
        {
        protected:
            PathTighteningTest()
            {
                ob::ScopedState<> state(space_);
                ompl::RNG rng(3);
                for (int i = 0; i <= 20; ++i)
                {
                    state[0] = i - 10.0;
                    state[1] = 5.0 + rng.uniformReal(-3.0, 3.0);
                    path_.append(state.get());
                }
            }

            /* The plane without a disc below the path. */
            static bool outsideDisc(const ob::State *state)
            {
                const auto *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::hypot(values[0], values[1]) > 1.9;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, outsideDisc};
            std::shared_ptr<Counted> objective_ = std::make_shared<Counted>(problem_.si);
            PathEvaluator evaluator_{problem_.si, objective_};
            PathTightening tightening_{std::make_shared<const StateChart>(space_), evaluator_, 5};
            Waypoints path_{space_};
        };

        TEST_F(PathTighteningTest, KnowsTheCostOfItsPathAtAllTimes)
        {
            const double before = evaluator_.cost(path_).value();
            tightening_.begin(path_);
            EXPECT_EQ(tightening_.cost().value(), objective_->infiniteCost().value()) << "not computed yet";
            for (int i = 0; i < 60; ++i)
            {
                tightening_.advance(300);
                const double cost = evaluator_.cost(tightening_.path()).value();
                ASSERT_NEAR(tightening_.cost().value(), cost, 1e-9 * cost) << "turn " << i;
            }
            EXPECT_TRUE(evaluator_.checkPath(tightening_.path()));
            EXPECT_LT(tightening_.cost().value(), 0.6 * before);
        }

        TEST_F(PathTighteningTest, IsInterruptedBetweenAnyTwoCostsAndGoesOnFromThere)
        {
            tightening_.begin(path_);
            std::uint64_t limit = 0;
            evaluator_.setStopCondition([&] { return objective_->asked >= limit; });
            double cost = objective_->infiniteCost().value();
            for (int i = 0; i < 400; ++i)
            {
                limit = objective_->asked + 7;
                evaluator_.setStopCondition([&] { return objective_->asked >= limit; });
                tightening_.advance(100000);
                EXPECT_LE(objective_->asked, limit);
                EXPECT_LE(tightening_.cost().value(), cost);
                cost = tightening_.cost().value();
            }
            evaluator_.setStopCondition({});
            EXPECT_NEAR(cost, evaluator_.cost(tightening_.path()).value(), 1e-9 * cost);
        }
    }  // namespace
}  // namespace ompl_mfa
