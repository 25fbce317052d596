#include "ompl_mfa/planner/Swarm.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        class SwarmTest : public ::testing::Test
        {
        protected:
            SwarmTest()
            {
                settings_.populationSize = 10;
                settings_.generations = 5;
            }

            SliceFrame frame() const
            {
                return SliceFrame::straight(std::make_shared<const StateChart>(problem_->si->getStateSpace()),
                                            problem_->state({1.0, 1.0}).get(), problem_->state({9.0, 1.0}).get(), 4);
            }

            Swarm makeSwarm(std::uint64_t seed, Swarm::Coordinates coordinates = Swarm::Coordinates::Offsets)
            {
                return {frame(),
                        coordinates,
                        evaluator_,
                        settings_,
                        seed,
                        [this](const Waypoints &, const Brightness &brightness) { costs_.push_back(brightness.cost); }};
            }

            static bool never()
            {
                return false;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            PathEvaluator evaluator_{problem_->si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            FireflyOptimizer::Settings settings_;
            std::vector<double> costs_;
        };

        TEST_F(SwarmTest, CountsEpochsAndEvaluationsAcrossThem)
        {
            Swarm swarm = makeSwarm(3);
            std::uint64_t before = 0;
            for (int i = 0; i < 25; ++i)
            {
                EXPECT_TRUE(swarm.step(never));
                EXPECT_GT(swarm.evaluations(), before);
                before = swarm.evaluations();
            }
            // the evaluation of the initial swarm is a step of its own, then come 5 generations
            EXPECT_EQ(swarm.epoch(), 25U / 6U);
        }

        TEST_F(SwarmTest, TheBestSurvivesTheEndOfAnEpoch)
        {
            Swarm swarm = makeSwarm(3);
            while (!swarm.fireflies().bestBrightness().isFeasible() || swarm.fireflies().generation() < 5)
                swarm.step(never);
            const unsigned int epoch = swarm.epoch();
            const double best = swarm.fireflies().bestBrightness().cost;
            swarm.step(never);
            EXPECT_EQ(swarm.epoch(), epoch + 1);
            EXPECT_LE(swarm.fireflies().bestBrightness().cost, best);
        }

        TEST_F(SwarmTest, AnInjectedPathIsEvaluated)
        {
            // over the wall at its corners, as short as slices at x = 3, 5, 7 allow
            Waypoints path(problem_->si->getStateSpace());
            for (const auto &[x, y] :
                 std::vector<std::pair<double, double>>{{1, 1}, {3, 4.3}, {5, 7.6}, {7, 4.3}, {9, 1}})
                path.append(problem_->state({x, y}).get());
            Swarm swarm = makeSwarm(3);
            swarm.inject(path);
            swarm.step(never);
            EXPECT_LE(swarm.fireflies().bestBrightness().cost, evaluator_.cost(path).value() + 1e-9);
            EXPECT_FALSE(costs_.empty());
        }

        TEST_F(SwarmTest, TheSeedDecidesTheRun)
        {
            const auto population = [this](std::uint64_t seed)
            {
                Swarm swarm = makeSwarm(seed);
                for (int i = 0; i < 9; ++i)
                    swarm.step(never);
                return Eigen::MatrixXd(swarm.fireflies().population());
            };
            EXPECT_EQ(population(3), population(3));
            EXPECT_NE(population(3), population(4));
        }

        TEST_F(SwarmTest, FirefliesInModesAreSmoothPathsOverTheSameSlices)
        {
            const auto meanLength = [this](Swarm::Coordinates coordinates)
            {
                Swarm swarm = makeSwarm(3, coordinates);
                swarm.step(never);
                Waypoints path(problem_->si->getStateSpace());
                double sum = 0.0;
                for (Eigen::Index i = 0; i < swarm.fireflies().population().cols(); ++i)
                {
                    swarm.pathOf(i, path);
                    EXPECT_EQ(path.size(), swarm.frame().slices() + 2);
                    sum += path.length();
                }
                return sum / static_cast<double>(swarm.fireflies().population().cols());
            };
            EXPECT_LT(meanLength(Swarm::Coordinates::Modes), 0.9 * meanLength(Swarm::Coordinates::Offsets));
        }

        TEST_F(SwarmTest, StopsBeforeAnyEvaluation)
        {
            Swarm swarm = makeSwarm(3);
            EXPECT_FALSE(swarm.step([] { return true; }));
            EXPECT_EQ(swarm.evaluations(), 0U);
            int left = 4;
            EXPECT_FALSE(swarm.step([&left] { return left-- == 0; }));
            EXPECT_EQ(swarm.evaluations(), 4U);
        }
    }  // namespace
}  // namespace ompl_mfa
