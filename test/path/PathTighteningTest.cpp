#include "ompl_mfa/path/PathTightening.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <rapidcheck.h>

#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
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

        /* The positions of a state are kept out of a ball around the origin and, in a plane, out of a thin wall. */
        class Room : public ob::StateValidityChecker
        {
        public:
            explicit Room(const ob::SpaceInformationPtr &si)
              : StateValidityChecker(si)
              , chart_(si->getStateSpace())
            {
            }

            bool isValid(const ob::State *state) const override
            {
                return clearance(state) > 0.0;
            }

            double clearance(const ob::State *state) const override
            {
                Eigen::VectorXd x(chart_.positionDimension());
                chart_.positions(state, x);
                if (x.size() < 2)
                    return 1.0;
                return std::min(x.norm() - 2.0, std::hypot(std::max(0.0, std::abs(x[0]) - 0.02), std::max(0.0, x[1])));
            }

            /* The first position of a state. */
            double height(const ob::State *state) const
            {
                Eigen::VectorXd x(chart_.positionDimension());
                chart_.positions(state, x);
                return x.size() > 0 ? x[0] : 0.0;
            }

        private:
            StateChart chart_;
        };

        const Room &roomOf(const ob::SpaceInformationPtr &si)
        {
            return static_cast<const Room &>(*si->getStateValidityChecker());
        }

        /* Infinite within a band around the ball. */
        class LethalBand : public ob::StateCostIntegralObjective
        {
        public:
            explicit LethalBand(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                const double clearance = roomOf(si_).clearance(state);
                return clearance < 1.0 && clearance > 0.5 ? infiniteCost() : ob::Cost(1.0 + 1.0 / (1.0 + clearance));
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                // no length at infinite cost is no number
                return si_->equalStates(from, to) ? identityCost() : StateCostIntegralObjective::motionCost(from, to);
            }
        };

        class Climbing : public ob::MechanicalWorkOptimizationObjective
        {
        public:
            explicit Climbing(const ob::SpaceInformationPtr &si)
              : MechanicalWorkOptimizationObjective(si, 0.1)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(roomOf(si_).height(state));
            }
        };

        /* A motion costs three times as much one way as the other. */
        class OneWayLength : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const bool up = roomOf(si_).height(to) > roomOf(si_).height(from);
                return ob::Cost((up ? 3.0 : 1.0) * si_->distance(from, to));
            }
        };

        using MakeObjective = ob::OptimizationObjectivePtr (*)(const ob::SpaceInformationPtr &);

        template <typename Objective>
        ob::OptimizationObjectivePtr make(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<Objective>(si);
        }

        const std::vector<MakeObjective> OBJECTIVES{make<ob::PathLengthOptimizationObjective>,
                                                    make<ob::MaximizeMinClearanceObjective>, make<LethalBand>,
                                                    make<Climbing>, make<OneWayLength>};

        class TighteningOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            TighteningOfEverySpace()
              : space_(GetParam().make())
              , chart_(std::make_shared<const StateChart>(space_))
              , si_(std::make_shared<ob::SpaceInformation>(space_))
            {
                si_->setStateValidityChecker(std::make_shared<Room>(si_));
                si_->setup();
            }

            /* A path of up to \e states random states, whose motions are valid at twice the resolution. */
            Waypoints anyPath(PathEvaluator &evaluator, ompl::RNG &rng, std::size_t states) const
            {
                Waypoints path(space_);
                ob::ScopedState<> state(space_);
                for (int tries = 0; tries < 400 && path.size() < states; ++tries)
                {
                    chart_->sampleUniform(rng, state.get());
                    if (evaluator.checkState(state.get()) &&
                        (path.empty() || evaluator.checkStrictly({{path.back(), state.get()}})))
                        path.append(state.get());
                }
                return path;
            }

            ob::StateSpacePtr space_;
            StateChartPtr chart_;
            ob::SpaceInformationPtr si_;
        };

        INSTANTIATE_TEST_SUITE_P(Path, TighteningOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        /* Whatever the objective, and wherever it is interrupted: the ends stay, the path stays valid and gets no
           worse, and its cost is known. */
        TEST_P(TighteningOfEverySpace, EveryStepKeepsThePathValidAndNoneMakesItWorse)
        {
            unsigned int improved = 0;
            EXPECT_TRUE(rc::check(
                [&]
                {
                    const auto objective = OBJECTIVES[*rc::gen::inRange<std::size_t>(0, OBJECTIVES.size())](si_);
                    const auto seed = static_cast<std::uint_fast32_t>(*rc::gen::inRange(1, 1 << 30));
                    const auto states = *rc::gen::inRange<std::size_t>(2, 9);
                    const auto patience = *rc::gen::inRange(1, 400);
                    ompl::RNG rng(seed);
                    PathEvaluator evaluator(si_, objective);
                    PathEvaluator judge(si_, objective);
                    const Waypoints path = anyPath(judge, rng, states);
                    RC_PRE(path.size() >= 2);
                    PathTightening tightening(chart_, evaluator, seed);
                    tightening.begin(path);
                    ob::Cost cost = judge.cost(path);
                    const ob::Cost first = cost;
                    for (int turn = 0; turn < 6; ++turn)
                    {
                        int asked = 0;
                        evaluator.setStopCondition([&] { return turn % 2 == 0 && ++asked > patience; });
                        const bool better = tightening.advance(1200);
                        const Waypoints &now = tightening.path();
                        RC_ASSERT(now.size() >= 2);
                        RC_ASSERT(space_->equalStates(now.front(), path.front()));
                        RC_ASSERT(space_->equalStates(now.back(), path.back()));
                        for (std::size_t i = 0; i < now.size(); ++i)
                            RC_ASSERT(space_->satisfiesBounds(now[i]));
                        RC_ASSERT(judge.checkPath(now));
                        const ob::Cost after = judge.cost(now);
                        const double rounding =
                            std::isfinite(after.value()) ? 1e-9 * (1.0 + std::abs(after.value())) : 0.0;
                        RC_ASSERT(!objective->isCostBetterThan(cost, ob::Cost(after.value() - rounding)) ||
                                  !objective->isCostBetterThan(cost, ob::Cost(after.value() + rounding)));
                        RC_ASSERT(!better || objective->isCostBetterThan(after, cost));
                        // not known before the cost of every motion was computed
                        const double known = tightening.cost().value();
                        RC_ASSERT(known == after.value() || std::abs(known - after.value()) <= rounding ||
                                  (turn == 0 && !objective->isFinite(tightening.cost())));
                        cost = after;
                    }
                    improved += objective->isCostBetterThan(cost, first) ? 1 : 0;
                }));
            EXPECT_GT(improved, 25U) << "of 100 paths";
        }

        /* Motions of infinite cost lead nowhere that a difference of costs could tell. */
        TEST_F(PathTighteningTest, APathOfInfiniteCostBecomesOneOfFiniteCost)
        {
            for (const bool single : {true, false})
            {
                for (std::uint_fast32_t seed = 1; seed <= 10; ++seed)
                {
                    const auto si = std::make_shared<ob::SpaceInformation>(space_);
                    si->setStateValidityChecker(std::make_shared<Room>(si));
                    si->setup();
                    PathEvaluator evaluator(si, std::make_shared<LethalBand>(si));
                    PathTightening tightening(std::make_shared<const StateChart>(space_), evaluator, seed);
                    // above the ball, through the band
                    const Waypoints path =
                        single
                            ? test::planarPath(space_, {{-6.0, 2.8}, {6.0, 2.8}})
                            : test::planarPath(space_, {{-6.0, 0.0}, {-5.0, 2.8}, {1.0, 2.8}, {5.0, 2.8}, {6.0, 0.0}});
                    ASSERT_TRUE(evaluator.checkPath(path));
                    ASSERT_TRUE(std::isinf(evaluator.cost(path).value()));
                    tightening.begin(path);
                    EXPECT_TRUE(tightening.advance(40000));
                    const double cost = tightening.cost().value();
                    ASSERT_TRUE(std::isfinite(cost)) << seed;
                    EXPECT_NEAR(cost, evaluator.cost(tightening.path()).value(), 1e-9 * cost);
                    EXPECT_TRUE(evaluator.checkPath(tightening.path()));
                    // and is refined as any other
                    tightening.advance(40000);
                    EXPECT_LT(tightening.cost().value(), cost);
                    EXPECT_LT(tightening.cost().value(), 20.0);
                }
            }
        }

        /* Where more is better, infinity is the best and its negative the worst. */
        TEST_F(PathTighteningTest, APathWithoutClearanceIsLedAwayFromTheObstacle)
        {
            class NoClearanceNearby : public ob::MaximizeMinClearanceObjective
            {
            public:
                using MaximizeMinClearanceObjective::MaximizeMinClearanceObjective;

                ob::Cost stateCost(const ob::State *state) const override
                {
                    const double clearance = roomOf(si_).clearance(state);
                    return clearance < 1.0 ? infiniteCost() : ob::Cost(clearance);
                }
            };
            const auto si = std::make_shared<ob::SpaceInformation>(space_);
            si->setStateValidityChecker(std::make_shared<Room>(si));
            si->setup();
            const auto objective = std::make_shared<NoClearanceNearby>(si);
            PathEvaluator evaluator(si, objective);
            PathTightening tightening(std::make_shared<const StateChart>(space_), evaluator, 3);
            const Waypoints path = test::planarPath(space_, {{-8.0, 8.0}, {-2.0, 2.0}, {2.0, 2.0}, {8.0, 8.0}});
            ASSERT_FALSE(objective->isFinite(evaluator.cost(path)));
            tightening.begin(path);
            EXPECT_TRUE(tightening.advance(40000));
            EXPECT_TRUE(objective->isFinite(tightening.cost()));
            EXPECT_GE(tightening.cost().value(), 1.0);
            EXPECT_TRUE(evaluator.checkPath(tightening.path()));
        }
    }  // namespace
}  // namespace ompl_mfa
