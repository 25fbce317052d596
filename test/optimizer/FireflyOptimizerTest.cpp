#include "ompl_mfa/optimizer/FireflyOptimizer.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "optimizer/FireflyOracle.h"

using ompl_mfa::Brightness;
using ompl_mfa::FireflyOptimizer;
using ompl_mfa::ObjectiveFunction;
using Variant = FireflyOptimizer::Variant;

namespace
{
    const auto never = [] { return false; };

    double bumpyCost(const std::vector<double> &x)
    {
        double cost = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k)
            cost += std::pow(x[k] - 1.3 * static_cast<double>(k + 1), 2) + 2.0 * std::cos(5.0 * x[k]);
        return cost;
    }

    /** \brief Keeps what it was asked, in order. */
    class Recorder : public ObjectiveFunction
    {
    public:
        using Cost = std::function<double(const std::vector<double> &)>;

        explicit Recorder(Cost cost = bumpyCost)
          : cost_(std::move(cost))
        {
        }

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override
        {
            points.emplace_back(x);
            hadRival.push_back(rival != nullptr);
            const Brightness brightness{0.0, cost_({x.data(), x.data() + x.size()})};
            if (rival != nullptr && !isBrighter(brightness, *rival))
                return {};
            return brightness;
        }

        std::vector<Eigen::VectorXd> points;
        std::vector<bool> hadRival;

    private:
        Cost cost_;
    };

    FireflyOptimizer::Settings small(Variant variant, unsigned int size = 12, unsigned int generations = 8)
    {
        FireflyOptimizer::Settings settings;
        settings.variant = variant;
        settings.populationSize = size;
        settings.generations = generations;
        return settings;
    }

    Eigen::VectorXd constant(Eigen::Index d, double value)
    {
        return Eigen::VectorXd::Constant(d, value);
    }

    /** \brief An optimiser in R^3 on a box of unequal edges, away from the origin. */
    FireflyOptimizer makeOptimizer(const FireflyOptimizer::Settings &settings, std::uint64_t seed = 3)
    {
        return {settings, Eigen::Vector3d(-4.0, 0.5, -1.0), Eigen::Vector3d(6.0, 2.5, 30.0), seed};
    }

    void expectSame(const FireflyOptimizer &a, const FireflyOptimizer &b)
    {
        EXPECT_TRUE(a.population() == b.population());
        for (unsigned int i = 0; i < a.settings().populationSize; ++i)
            EXPECT_EQ(a.brightness(i).cost, b.brightness(i).cost);
        EXPECT_TRUE(a.best() == b.best());
        EXPECT_EQ(a.bestBrightness().cost, b.bestBrightness().cost);
        EXPECT_EQ(a.evaluations(), b.evaluations());
        EXPECT_EQ(a.generation(), b.generation());
    }

    std::string refusal(const FireflyOptimizer::Settings &settings)
    {
        try
        {
            settings.validate();
        }
        catch (const std::invalid_argument &error)
        {
            return error.what();
        }
        return "";
    }
}  // namespace

class FireflyOptimizerVariants : public testing::TestWithParam<Variant>
{
};

INSTANTIATE_TEST_SUITE_P(Both, FireflyOptimizerVariants, testing::Values(Variant::FA, Variant::MFA),
                         [](const auto &variant) { return variant.param == Variant::FA ? "FA" : "MFA"; });

TEST_P(FireflyOptimizerVariants, followsTheFormulasOverAnEpoch)
{
    const FireflyOracle::Point lower{-4.0, 0.5, -1.0};
    const FireflyOracle::Point upper{6.0, 2.5, 30.0};
    auto settings = small(GetParam());
    settings.gamma = 0.03;
    settings.eta = 1.1;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        FireflyOracle oracle({GetParam() == Variant::MFA, 12, 8, 0.03, 0.2, 1.1}, lower, upper, bumpyCost, seed);
        auto optimizer = makeOptimizer(settings, seed);
        Recorder objective;
        ASSERT_TRUE(optimizer.step(objective, never));
        for (unsigned int t = 0; t < 8; ++t)
        {
            oracle.generation(t);
            ASSERT_TRUE(optimizer.step(objective, never));
            for (unsigned int i = 0; i < 12; ++i)
            {
                for (unsigned int k = 0; k < 3; ++k)
                    ASSERT_NEAR(optimizer.population()(k, i), oracle.points[i][k], 1e-9) << "generation " << t;
                ASSERT_NEAR(optimizer.brightness(i).cost, oracle.costs[i], 1e-7);
            }
            ASSERT_NEAR(optimizer.bestBrightness().cost, oracle.bestCost, 1e-7);
        }
    }
}

TEST(FireflyOptimizer, movesTowardTheBrighterByEquation4And5)
{
    // Two fireflies without random step: the dimmer ends at x + beta0 exp(-gamma r^2) (y - x), r in tenths of ranges.
    auto settings = small(Variant::FA, 2);
    settings.alpha = 0.0;
    settings.eta = 0.8;
    settings.gamma = 0.02;
    auto optimizer = makeOptimizer(settings);
    optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
    optimizer.inject(Eigen::Vector3d(5.0, 1.5, 25.5));
    Recorder objective([](const std::vector<double> &x) { return x[0]; });
    optimizer.step(objective, never);
    optimizer.step(objective, never);
    // r^2 = (5/1)^2 + (0.5/0.2)^2 + (15.5/3.1)^2 = 56.25; beta = 0.8 exp(-1.125) = 0.259722...
    const double beta = 0.8 * 0.32465246735834974;
    EXPECT_NEAR(optimizer.population()(0, 1), 5.0 - 5.0 * beta, 1e-12);
    EXPECT_NEAR(optimizer.population()(1, 1), 1.5 - 0.5 * beta, 1e-12);
    EXPECT_NEAR(optimizer.population()(2, 1), 25.5 - 15.5 * beta, 1e-12);
    EXPECT_TRUE(optimizer.population().col(0) == Eigen::Vector3d(0.0, 1.0, 10.0));
    EXPECT_EQ(optimizer.evaluations(), 3U);
}

TEST(FireflyOptimizer, keepsAPartOfTheAttractionAtAnyDistance)
{
    auto settings = small(Variant::FA, 2);
    settings.alpha = 0.0;
    settings.gamma = 1e6;
    settings.betaMin = 0.2;
    auto optimizer = makeOptimizer(settings);
    optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
    optimizer.inject(Eigen::Vector3d(5.0, 1.5, 25.0));
    Recorder objective([](const std::vector<double> &x) { return x[0]; });
    optimizer.step(objective, never);
    optimizer.step(objective, never);
    EXPECT_NEAR(optimizer.population()(0, 1), 4.0, 1e-12);
    EXPECT_NEAR(optimizer.population()(2, 1), 22.0, 1e-12);
}

TEST(FireflyOptimizer, randomStepIsUniformAndScaledByEachRange)
{
    // Without attraction a firefly with one brighter neighbour moves by alpha eps, eps in [-1/2, 1/2] of each range.
    auto settings = small(Variant::FA, 2);
    settings.eta = 0.0;
    settings.alpha = 0.1;
    double squares[3] = {0.0, 0.0, 0.0};
    const Eigen::Vector3d start(1.0, 1.5, 15.0);
    const Eigen::Vector3d range(10.0, 2.0, 31.0);
    constexpr int RUNS = 4000;
    for (int run = 0; run < RUNS; ++run)
    {
        auto optimizer = makeOptimizer(settings, 100 + run);
        optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
        optimizer.inject(start);
        Recorder objective([](const std::vector<double> &x) { return x[2]; });
        optimizer.step(objective, never);
        optimizer.step(objective, never);
        for (int k = 0; k < 3; ++k)
        {
            const double part = (optimizer.population()(k, 1) - start[k]) / range[k] / 0.1;
            ASSERT_LE(std::abs(part), 0.5 + 1e-12);
            squares[k] += part * part / RUNS;
        }
    }
    for (const double square : squares)
        EXPECT_NEAR(square, 1.0 / 12.0, 0.004);
}

TEST(FireflyOptimizer, equallyBrightFirefliesMoveAtRandomExceptTheFirst)
{
    auto optimizer = makeOptimizer(small(Variant::FA));
    const Eigen::MatrixXd before = optimizer.population();
    Recorder flat([](const std::vector<double> &) { return 1.0; });
    optimizer.step(flat, never);
    optimizer.step(flat, never);
    EXPECT_TRUE(optimizer.population().col(0) == before.col(0));
    for (int i = 1; i < 12; ++i)
    {
        const Eigen::Vector3d step =
            (optimizer.population().col(i) - before.col(i)).cwiseQuotient(Eigen::Vector3d(10.0, 2.0, 31.0));
        EXPECT_GT(step.cwiseAbs().maxCoeff(), 0.0);
        EXPECT_LE(step.cwiseAbs().maxCoeff(), 0.1 + 1e-12);
    }
}

TEST(FireflyOptimizer, trialVectorsObeyEquations6To12)
{
    // The population is recovered from the evaluations; no firefly moves, since none is brighter than another.
    auto settings = small(Variant::MFA, 8);
    settings.alpha = 0.0;
    const Eigen::VectorXd lower = constant(4, -1e3);
    const Eigen::VectorXd upper = constant(4, 1e3);
    FireflyOptimizer optimizer(settings, lower, upper, 12);
    // Narrow around a far point, so that no trial is clamped.
    for (int i = 0; i < 8; ++i)
        optimizer.inject(Eigen::Vector4d(10.0 + i, 20.0 + i * i, 30.0 - i * i * i / 64.0, 7.0 * std::sin(i)));
    Recorder flat([](const std::vector<double> &) { return 1.0; });
    optimizer.step(flat, never);
    const Eigen::MatrixXd x = optimizer.population();
    const Eigen::VectorXd best = optimizer.best();
    const Eigen::VectorXd worst = x.col(7);
    flat.points.clear();
    flat.hadRival.clear();
    optimizer.step(flat, never);
    ASSERT_EQ(flat.points.size(), 7U + 8U * 5U)
        << "a trial equal to its firefly would be left out; choose another seed";
    for (int i = 0; i < 8; ++i)
    {
        const auto *trial = &flat.points[7 + 5 * static_cast<std::size_t>(i)];
        // (7): F_new2 - F_new1 = l (F_best - F_worst) with one l for all components; F_new1 shows in (8) and (9).
        std::set<long> lambdas;
        for (int j = 0; j < 4; ++j)
        {
            const bool newIn8 = trial[0][j] != best[j];
            const bool newIn9 = trial[1][j] != x(j, i);
            if (newIn8 && newIn9)
            {
                EXPECT_EQ(trial[0][j], trial[1][j]);
            }
            EXPECT_TRUE(trial[2][j] == x(j, i) || trial[2][j] == trial[3][j]);
            if (newIn8 || newIn9)
            {
                const double new1 = newIn8 ? trial[0][j] : trial[1][j];
                lambdas.insert(std::lround(1e9 * (trial[3][j] - new1) / (best[j] - worst[j])));
            }
        }
        EXPECT_LE(lambdas.size(), 1U);
        for (const long lambda : lambdas)
        {
            EXPECT_GE(lambda, 0);
            EXPECT_LT(lambda, 1000000000);
        }
        // (12): delta F_worst + psi (F_best - F_worst), both in [0, 1).
        Eigen::MatrixXd basis(4, 2);
        basis << worst, best - worst;
        const Eigen::Vector2d weights = basis.colPivHouseholderQr().solve(trial[4]);
        EXPECT_NEAR((basis * weights - trial[4]).norm(), 0.0, 1e-9);
        EXPECT_GE(weights.minCoeff(), -1e-9);
        EXPECT_LT(weights.maxCoeff(), 1.0 + 1e-9);
    }
    for (std::size_t k = 0; k < flat.hadRival.size(); ++k)
        EXPECT_EQ(flat.hadRival[k], k >= 7) << "only trial vectors have a rival";
}

TEST(FireflyOptimizer, drawsFourDistinctFireflies)
{
    // Firefly i sits at 10^i: F_n1 + l1 (F_n2 - F_n3) + l2 (F_n3 - F_n4) of four fireflies, were two of them the same,
    // would miss one of the four powers. Their use is read off a least-squares fit that needs all four to be distinct.
    auto settings = small(Variant::MFA, 4, 2000);
    settings.alpha = 0.0;
    settings.trialVectors = {{false, false, false, true, false}};
    FireflyOptimizer optimizer(settings, constant(4, -1e6), constant(4, 1e6), 5);
    for (int i = 0; i < 4; ++i)
        optimizer.inject(Eigen::Vector4d::Unit(i));
    Recorder flat([](const std::vector<double> &) { return 1.0; });
    optimizer.step(flat, never);
    for (int generation = 0; generation < 500; ++generation)
    {
        flat.points.clear();
        optimizer.step(flat, never);
        // Unit vectors: the components are the weights. Best is e0 and worst e3, so F_new2 - l (e0 - e3) must have the
        // weights 1, l1, l2 - l1 and -l2 in some order, whose sum is 1 whatever the draw; with a repetition the four
        // fireflies would be three at most and one of e1, e2 could be missing only together with e0 or e3.
        for (std::size_t k = 3; k < flat.points.size(); ++k)
        {
            EXPECT_NEAR(flat.points[k].sum(), 1.0, 1e-9);
            EXPECT_NE(flat.points[k][1], 0.0);
            EXPECT_NE(flat.points[k][2], 0.0);
        }
    }
}

TEST(FireflyOptimizer, schedulesEndWhereEquations13And14Say)
{
    auto optimizer = makeOptimizer(small(Variant::MFA, 5, 10));
    Recorder objective;
    optimizer.step(objective, never);
    EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
    EXPECT_DOUBLE_EQ(optimizer.beta0(), 1.0);
    optimizer.step(objective, never);
    EXPECT_NEAR(optimizer.alpha(), 0.2 * std::pow(1.0 / 20.0, 0.1), 1e-15);
    EXPECT_NEAR(optimizer.beta0(), 0.9, 1e-15);
    for (int t = 1; t < 10; ++t)
        optimizer.step(objective, never);
    EXPECT_NEAR(optimizer.alpha(), 0.2 / 20.0, 1e-15);
    EXPECT_NEAR(optimizer.beta0(), 0.0, 1e-15);

    optimizer.step(objective, never);
    EXPECT_EQ(optimizer.generation(), 11U);
    EXPECT_NEAR(optimizer.alpha(), 0.2 * std::pow(1.0 / 20.0, 0.1), 1e-15) << "the second epoch starts anew";
    optimizer.restartEpoch();
    EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
    EXPECT_DOUBLE_EQ(optimizer.beta0(), 1.0);
}

TEST(FireflyOptimizer, otherSchedulesEndWhereTheySay)
{
    using Alpha = FireflyOptimizer::AlphaSchedule;
    const std::pair<Alpha, double> ends[] = {
        {Alpha::Constant, 0.2}, {Alpha::Geometric, 0.01}, {Alpha::Yang, 0.2e-4 / 0.9}, {Alpha::Linear, 0.0}};
    for (const auto &end : ends)
    {
        auto settings = small(Variant::FA, 5, 10);
        settings.alphaSchedule = end.first;
        auto optimizer = makeOptimizer(settings);
        Recorder objective;
        EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
        for (int t = 0; t <= 10; ++t)
            optimizer.step(objective, never);
        EXPECT_NEAR(optimizer.alpha(), end.second, 1e-15);
        EXPECT_EQ(optimizer.beta0(), 1.0);
    }
    auto settings = small(Variant::MFA, 5, 10);
    settings.alphaSchedule = Alpha::Constant;
    settings.betaSchedule = FireflyOptimizer::BetaSchedule::Constant;
    auto optimizer = makeOptimizer(settings);
    Recorder objective;
    for (int t = 0; t <= 10; ++t)
        optimizer.step(objective, never);
    EXPECT_EQ(optimizer.alpha(), 0.2);
    EXPECT_EQ(optimizer.beta0(), 1.0);
}

TEST(FireflyOptimizer, attractionNeverBecomesRepulsion)
{
    auto settings = small(Variant::MFA, 5, 10);
    settings.eta = 0.35;
    auto optimizer = makeOptimizer(settings);
    Recorder objective;
    for (int t = 0; t <= 10; ++t)
    {
        EXPECT_GE(optimizer.beta0(), 0.0);
        optimizer.step(objective, never);
    }
}

TEST(FireflyOptimizer, epochEndKeepsTheBest)
{
    auto optimizer = makeOptimizer(small(Variant::MFA, 10, 5));
    Recorder objective;
    for (int t = 0; t <= 5; ++t)
        optimizer.step(objective, never);
    const double before = optimizer.bestBrightness().cost;
    const Eigen::VectorXd brightest = optimizer.population().col(optimizer.brightestIndex());
    const double brightestCost = optimizer.brightness(optimizer.brightestIndex()).cost;
    optimizer.step(objective, never);
    EXPECT_LE(optimizer.bestBrightness().cost, before);
    EXPECT_LE(optimizer.brightness(optimizer.brightestIndex()).cost, brightestCost);
    EXPECT_TRUE(brightest.allFinite());
}

TEST_P(FireflyOptimizerVariants, isDeterministicInItsSeed)
{
    auto a = makeOptimizer(small(GetParam()), 42);
    auto b = makeOptimizer(small(GetParam()), 42);
    auto c = makeOptimizer(small(GetParam()), 43);
    Recorder objective;
    for (int t = 0; t < 10; ++t)
    {
        a.step(objective, never);
        b.step(objective, never);
        c.step(objective, never);
    }
    expectSame(a, b);
    EXPECT_FALSE(a.population() == c.population());
}

TEST_P(FireflyOptimizerVariants, resumesAtTheVeryEvaluation)
{
    auto whole = makeOptimizer(small(GetParam()), 9);
    auto interrupted = makeOptimizer(small(GetParam()), 9);
    Recorder objective;
    Recorder same;
    for (int t = 0; t < 6; ++t)
        whole.step(objective, never);
    for (int t = 0; t < 6; ++t)
    {
        // Every evaluation is its own call.
        std::uint64_t limit = interrupted.evaluations();
        while (!interrupted.step(same, [&] { return interrupted.evaluations() >= limit; }))
        {
            ASSERT_EQ(interrupted.evaluations(), limit);
            ++limit;
        }
    }
    expectSame(whole, interrupted);
    ASSERT_EQ(objective.points.size(), same.points.size());
    for (std::size_t k = 0; k < same.points.size(); ++k)
        EXPECT_TRUE(objective.points[k] == same.points[k]);
}

TEST(FireflyOptimizer, asksStopBeforeEveryEvaluation)
{
    auto optimizer = makeOptimizer(small(Variant::MFA));
    Recorder objective;
    std::uint64_t asked = 0;
    for (int t = 0; t < 5; ++t)
        optimizer.step(objective, [&asked] { return ++asked, false; });
    EXPECT_EQ(asked, optimizer.evaluations());
    EXPECT_EQ(asked, objective.points.size());
}

TEST(FireflyOptimizer, stoppedBeforeTheFirstEvaluationItHasNothing)
{
    auto optimizer = makeOptimizer(small(Variant::MFA));
    Recorder objective;
    EXPECT_FALSE(optimizer.step(objective, [] { return true; }));
    EXPECT_EQ(optimizer.evaluations(), 0U);
    EXPECT_FALSE(optimizer.bestBrightness().isFeasible());
    EXPECT_EQ(optimizer.best().size(), 3);
}

TEST_P(FireflyOptimizerVariants, zeroGenerationsAreTheInitialPopulation)
{
    auto optimizer = makeOptimizer(small(GetParam()));
    const Eigen::MatrixXd initial = optimizer.population();
    Recorder objective;
    EXPECT_TRUE(optimizer.step(objective, never));
    EXPECT_EQ(optimizer.generation(), 0U);
    EXPECT_EQ(optimizer.evaluations(), 12U);
    EXPECT_TRUE(optimizer.population() == initial);
    double lowest = INFINITY;
    for (unsigned int i = 0; i < 12; ++i)
    {
        EXPECT_EQ(optimizer.brightness(i).cost, bumpyCost({&initial(0, i), &initial(0, i) + 3}));
        lowest = std::min(lowest, optimizer.brightness(i).cost);
    }
    EXPECT_EQ(optimizer.bestBrightness().cost, lowest);
    EXPECT_EQ(optimizer.brightness(optimizer.brightestIndex()).cost, lowest);
}

TEST(FireflyOptimizer, initialPopulationFillsTheBoxUniformly)
{
    const FireflyOptimizer optimizer(small(Variant::FA, 20000), Eigen::Vector2d(-3.0, 100.0),
                                     Eigen::Vector2d(1.0, 100.5), 1);
    const Eigen::MatrixXd unit = ((optimizer.population().colwise() - optimizer.lower()).array().colwise() /
                                  (optimizer.upper() - optimizer.lower()).array())
                                     .matrix();
    EXPECT_GE(unit.minCoeff(), 0.0);
    EXPECT_LE(unit.maxCoeff(), 1.0);
    for (int k = 0; k < 2; ++k)
    {
        EXPECT_NEAR(unit.row(k).mean(), 0.5, 0.01);
        EXPECT_NEAR(unit.row(k).squaredNorm() / 20000, 1.0 / 3.0, 0.01);
    }
}

TEST_P(FireflyOptimizerVariants, neverLeavesTheBox)
{
    // The optimum lies outside: every move and trial pushes against the bounds.
    auto settings = small(GetParam());
    settings.alpha = 1.0;
    settings.eta = 2.0;
    auto optimizer = makeOptimizer(settings);
    Recorder objective([](const std::vector<double> &x) { return x[0] + x[1] - x[2]; });
    for (int t = 0; t < 20; ++t)
        optimizer.step(objective, never);
    for (const auto &x : objective.points)
    {
        ASSERT_TRUE((x.array() >= optimizer.lower().array()).all());
        ASSERT_TRUE((x.array() <= optimizer.upper().array()).all());
    }
    EXPECT_TRUE(optimizer.best() == Eigen::Vector3d(-4.0, 0.5, 30.0)) << "the corner is reached exactly";
}

TEST_P(FireflyOptimizerVariants, bestSoFarIsMonotoneAndTheBestOfAll)
{
    auto settings = small(GetParam());
    settings.alpha = 1.0;
    auto optimizer = makeOptimizer(settings);
    double lowest = INFINITY;
    Recorder objective(
        [&lowest](const std::vector<double> &x)
        {
            lowest = std::min(lowest, bumpyCost(x));
            return bumpyCost(x);
        });
    double previous = INFINITY;
    for (int t = 0; t < 30; ++t)
    {
        optimizer.step(objective, never);
        EXPECT_LE(optimizer.bestBrightness().cost, previous);
        previous = optimizer.bestBrightness().cost;
        EXPECT_EQ(previous, lowest);
        const auto &best = optimizer.best();
        EXPECT_EQ(bumpyCost({best.data(), best.data() + best.size()}), lowest);
    }
}

TEST(FireflyOptimizer, spendsAtMostOneAndSixEvaluationsAFirefly)
{
    for (const auto variant : {Variant::FA, Variant::MFA})
    {
        auto optimizer = makeOptimizer(small(variant));
        Recorder objective;
        optimizer.step(objective, never);
        for (int t = 0; t < 20; ++t)
        {
            const auto before = optimizer.evaluations();
            optimizer.step(objective, never);
            const auto spent = optimizer.evaluations() - before;
            if (variant == Variant::FA)
                EXPECT_EQ(spent, 11U);
            else
                EXPECT_LE(spent, 11U + 60U);
        }
    }
}

TEST(FireflyOptimizer, leavesOutTheTrialVectorsThatAreSwitchedOff)
{
    auto settings = small(Variant::MFA);
    settings.trialVectors = {{false, false, false, false, false}};
    settings.alphaSchedule = FireflyOptimizer::AlphaSchedule::Constant;
    settings.betaSchedule = FireflyOptimizer::BetaSchedule::Constant;
    auto optimizer = makeOptimizer(settings);
    Recorder objective;
    for (int t = 0; t <= 4; ++t)
        optimizer.step(objective, never);
    EXPECT_EQ(optimizer.evaluations(), 12U + 4U * 11U);
}

TEST(FireflyOptimizer, ranksFeasibleBeforeLessViolated)
{
    class Violated : public ObjectiveFunction
    {
    public:
        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
        {
            return {std::max(0.0, x[0] - 1.0), -x[0]};
        }
    } objective;
    FireflyOptimizer optimizer(small(Variant::MFA, 20, 30), constant(1, -10.0), constant(1, 10.0), 4);
    for (int t = 0; t <= 60; ++t)
        optimizer.step(objective, never);
    EXPECT_TRUE(optimizer.bestBrightness().isFeasible());
    EXPECT_NEAR(optimizer.best()[0], 1.0, 1e-2);
    EXPECT_LE(optimizer.best()[0], 1.0);
}

TEST(FireflyOptimizer, ordersAsTheObjectiveSays)
{
    class Greatest : public ObjectiveFunction
    {
    public:
        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
        {
            return {0.0, -x.squaredNorm()};
        }
        bool isBrighter(const Brightness &a, const Brightness &b) const override
        {
            return a.violation < b.violation || (a.violation == b.violation && a.cost > b.cost);
        }
    } objective;
    FireflyOptimizer optimizer(small(Variant::MFA, 20, 30), constant(2, -3.0), constant(2, 10.0), 4);
    for (int t = 0; t <= 30; ++t)
        optimizer.step(objective, never);
    EXPECT_LT(optimizer.best().norm(), 0.05);
}

TEST(FireflyOptimizer, takesNanAsInfinitelyDim)
{
    Recorder objective([](const std::vector<double> &x) { return x[0] > 0.0 ? std::nan("") : x[0] * x[0]; });
    auto optimizer = makeOptimizer(small(Variant::MFA, 20, 30));
    for (int t = 0; t <= 30; ++t)
        optimizer.step(objective, never);
    EXPECT_TRUE(optimizer.bestBrightness().isFeasible());
    EXPECT_LT(optimizer.bestBrightness().cost, 1e-2);
}

TEST(FireflyOptimizer, injectedPointReplacesTheDimmest)
{
    auto optimizer = makeOptimizer(small(Variant::MFA));
    Recorder objective;
    optimizer.step(objective, never);
    const unsigned int dimmest = optimizer.order().back();
    const Eigen::Vector3d dull(0.1, 1.1, 1.1);
    const double second = optimizer.brightness(optimizer.order()[10]).cost;
    optimizer.inject(dull, {0.0, second}, objective);
    EXPECT_TRUE(optimizer.population().col(dimmest) == dull);
    EXPECT_FALSE(optimizer.best() == dull);

    const Eigen::Vector3d bright(-99.0, 1.0, 2.0);
    optimizer.inject(bright, {0.0, -1e9}, objective);
    EXPECT_TRUE(optimizer.best() == Eigen::Vector3d(-4.0, 1.0, 2.0)) << "clamped to the box";
    EXPECT_EQ(optimizer.bestBrightness().cost, -1e9);
    EXPECT_EQ(optimizer.brightness(optimizer.brightestIndex()).cost, -1e9);
    optimizer.step(objective, never);
    EXPECT_EQ(optimizer.bestBrightness().cost, -1e9);
    EXPECT_TRUE(optimizer.population().col(optimizer.brightestIndex()) == optimizer.best());
}

TEST(FireflyOptimizer, injectionInTheMiddleOfAGenerationSurvivesIt)
{
    auto optimizer = makeOptimizer(small(Variant::FA));
    Recorder objective;
    optimizer.step(objective, never);
    const auto limit = optimizer.evaluations() + 3;
    EXPECT_FALSE(optimizer.step(objective, [&] { return optimizer.evaluations() >= limit; }));
    optimizer.inject(Eigen::Vector3d(1.0, 1.0, 1.0), {0.0, -1e9}, objective);
    EXPECT_TRUE(optimizer.step(objective, never));
    EXPECT_TRUE(optimizer.population().col(optimizer.brightestIndex()) == Eigen::Vector3d(1.0, 1.0, 1.0));
}

TEST(FireflyOptimizer, injectionsAtTheWrongTimeAreLogicErrors)
{
    auto optimizer = makeOptimizer(small(Variant::FA, 2));
    Recorder objective;
    const Eigen::Vector3d x(1.0, 1.0, 1.0);
    EXPECT_THROW(optimizer.inject(x, {0.0, 1.0}, objective), std::logic_error);
    optimizer.inject(x);
    optimizer.inject(x);
    EXPECT_THROW(optimizer.inject(x), std::logic_error);
    optimizer.step(objective, never);
    EXPECT_THROW(optimizer.inject(x), std::logic_error);
}

TEST(FireflyOptimizer, injectedSeedsAreEvaluatedFirst)
{
    auto optimizer = makeOptimizer(small(Variant::MFA));
    optimizer.inject(Eigen::Vector3d(1.0, 2.0, 3.0));
    Recorder objective;
    optimizer.step(objective, never);
    EXPECT_TRUE(objective.points.front() == Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST(FireflyOptimizer, aCoordinateWithoutRangeStaysPut)
{
    for (const auto variant : {Variant::FA, Variant::MFA})
    {
        FireflyOptimizer optimizer(small(variant), Eigen::Vector2d(-1.0, 7.0), Eigen::Vector2d(1.0, 7.0), 2);
        Recorder objective;
        for (int t = 0; t <= 10; ++t)
            optimizer.step(objective, never);
        EXPECT_TRUE((optimizer.population().row(1).array() == 7.0).all());
        EXPECT_TRUE(optimizer.population().allFinite());
    }
}

TEST(FireflyOptimizer, findsTheOptimumOfEquation19)
{
    // -f, eq. (19), over [-5, 5]^2 with the paper's settings.
    Recorder objective(
        [](const std::vector<double> &x)
        {
            const double squared = x[0] * x[0] + x[1] * x[1];
            return squared == 0.0 ? -1.0 : -std::sin(squared) / squared;
        });
    std::vector<int> near;
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
    {
        FireflyOptimizer optimizer({}, constant(2, -5.0), constant(2, 5.0), seed);
        for (int t = 0; t <= 50; ++t)
            optimizer.step(objective, never);
        near.push_back(static_cast<int>((optimizer.population().colwise().norm().array() <= 0.5).count()));
    }
    std::sort(near.begin(), near.end());
    EXPECT_GE(near[14], 95);
}

TEST(FireflyOptimizer, refusesBadSettingsByNameValueAndRange)
{
    EXPECT_EQ(refusal({}), "");
    const double nan = std::nan("");
    const double inf = std::numeric_limits<double>::infinity();
    struct Case
    {
        const char *name;
        double FireflyOptimizer::Settings::*member;
        double bad;
    };
    for (const auto &bad :
         {Case{"gamma", &FireflyOptimizer::Settings::gamma, -0.1},
          Case{"gamma", &FireflyOptimizer::Settings::gamma, nan},
          Case{"gamma", &FireflyOptimizer::Settings::gamma, inf},
          Case{"alpha", &FireflyOptimizer::Settings::alpha, 1.5},
          Case{"alpha", &FireflyOptimizer::Settings::alpha, -0.5},
          Case{"alpha", &FireflyOptimizer::Settings::alpha, nan}, Case{"eta", &FireflyOptimizer::Settings::eta, 2.5},
          Case{"eta", &FireflyOptimizer::Settings::eta, -1.0},
          Case{"betaMin", &FireflyOptimizer::Settings::betaMin, -1.0}})
    {
        FireflyOptimizer::Settings settings;
        settings.*bad.member = bad.bad;
        const std::string message = refusal(settings);
        EXPECT_NE(message.find(bad.name), std::string::npos) << message;
        EXPECT_NE(message.find("must be"), std::string::npos) << message;
    }
    EXPECT_EQ(refusal(small(Variant::MFA, 3)),
              "FireflyOptimizer: populationSize = 3 is not accepted; it must be at least 4");
    EXPECT_EQ(refusal(small(Variant::FA, 1)), "");
    EXPECT_NE(refusal(small(Variant::FA, 0)), "");
    EXPECT_NE(refusal(small(Variant::FA, 10, 0)).find("generations = 0"), std::string::npos);
}

TEST(FireflyOptimizer, refusesBadBoxes)
{
    const auto make = [](const Eigen::VectorXd &lower, const Eigen::VectorXd &upper)
    { FireflyOptimizer(FireflyOptimizer::Settings(), lower, upper, 1); };
    EXPECT_THROW(make({}, {}), std::invalid_argument);
    EXPECT_THROW(make(constant(2, 0.0), constant(3, 1.0)), std::invalid_argument);
    EXPECT_THROW(make(constant(2, 1.0), constant(2, 0.0)), std::invalid_argument);
    EXPECT_THROW(make(constant(2, -INFINITY), constant(2, 0.0)), std::invalid_argument);
    EXPECT_THROW(make(constant(2, 0.0), constant(2, std::nan(""))), std::invalid_argument);
    EXPECT_THROW(make(constant(1, -1e308), constant(1, 1e308)), std::invalid_argument) << "the range overflows";
}
