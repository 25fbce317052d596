/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#include "ompl_mfa/optimizer/FireflyOptimizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "text/NumberText.h"

namespace ompl_mfa
{
    namespace
    {
        /** \brief The range of the coordinates in the paper's study of eq. (19), to which distances are scaled so that
        gamma has the same meaning on every box. */
        constexpr double REFERENCE_RANGE = 10.0;

        [[noreturn]] void refuse(const char *setting, double value, const std::string &accepted)
        {
            throw std::invalid_argument(std::string("FireflyOptimizer: ") + setting + " = " +
                                        text::numberText(value, 6) + " is not accepted; it must be " + accepted);
        }

        void requireInterval(const char *setting, double value, double lower, double upper)
        {
            if (value >= lower && value <= upper)
            {
                return;
            }
            const std::string least = text::numberText(lower, 6);
            refuse(setting, value,
                   upper == std::numeric_limits<double>::max()
                       ? "finite and at least " + least
                       : "in [" + least + ", " + text::numberText(upper, 6) + "]");
        }

        void validateBox(const Eigen::VectorXd &lower, const Eigen::VectorXd &upper)
        {
            if (lower.size() == 0 || lower.size() != upper.size())
            {
                throw std::invalid_argument(
                    "FireflyOptimizer: bounds of " + std::to_string(lower.size()) + " and " +
                    std::to_string(upper.size()) +
                    " coordinates are not accepted; both must have the same number, at least 1");
            }
            for (Eigen::Index k = 0; k < lower.size(); ++k)
            {
                if (!std::isfinite(lower[k]))
                {
                    refuse(("lower[" + std::to_string(k) + "]").c_str(), lower[k], "finite");
                }
                if (!std::isfinite(upper[k] - lower[k]) || upper[k] < lower[k])
                {
                    refuse(("upper[" + std::to_string(k) + "]").c_str(), upper[k],
                           "finite and at least the lower bound");
                }
            }
        }
    }  // namespace

    void FireflyOptimizer::Settings::validate() const
    {
        const unsigned int smallest = variant == Variant::MFA ? 4 : 1;
        if (populationSize < smallest)
        {
            refuse("populationSize", populationSize, "at least " + std::to_string(smallest));
        }
        if (generations < 1)
        {
            refuse("generations", generations, "at least 1");
        }
        requireInterval("gamma", gamma, 0.0, std::numeric_limits<double>::max());
        requireInterval("alpha", alpha, 0.0, 1.0);
        requireInterval("eta", eta, 0.0, 2.0);
        requireInterval("betaMin", betaMin, 0.0, 2.0);
    }

    FireflyOptimizer::FireflyOptimizer(const Settings &settings, const Eigen::VectorXd &lower,
                                       const Eigen::VectorXd &upper, std::uint_fast64_t seed)
      : settings_(settings)
      , lower_(lower)
      , upper_(upper)
      , random_(seed)
    {
        settings_.validate();
        validateBox(lower_, upper_);

        const Eigen::Index dimension = lower_.size();
        const unsigned int size = settings_.populationSize;
        range_ = upper_ - lower_;
        inverseScale_ = (range_.array() > 0.0).select(REFERENCE_RANGE * range_.cwiseInverse(), 0.0);
        population_.resize(dimension, size);
        brightness_.resize(size);
        order_.reserve(size);
        sorted_.resize(size);
        merged_.resize(size);
        brighter_.resize(size);
        best_ = lower_ + 0.5 * range_;
        moved_.resize(dimension, size);
        moves_.resize(size, true);
        trialsWanted_.assign(settings_.trialVectors.begin(), settings_.trialVectors.end());
        trials_.resize(dimension, TRIAL_VECTORS);
        new1_.resize(dimension);
        new2_.resize(dimension);
    }

    bool FireflyOptimizer::step(ObjectiveFunction &objective, const StopCondition &stop)
    {
        if (phase_ == Phase::Placing && !placeInitial(stop))
        {
            return false;
        }
        if (phase_ == Phase::Initial)
        {
            return evaluateInitial(objective, stop);
        }
        if (phase_ == Phase::Between && !beginGeneration(objective, stop))
        {
            return false;
        }
        if (phase_ == Phase::Moving && !move(stop))
        {
            return false;
        }
        if (phase_ == Phase::Moves && !evaluateMoves(objective, stop))
        {
            return false;
        }
        return evaluateTrials(objective, stop) && endGeneration(objective, stop);
    }

    bool FireflyOptimizer::asked(const StopCondition &stop)
    {
        if (stop())
        {
            return true;
        }
        operationsWhenAsked_ = operations_;
        return false;
    }

    bool FireflyOptimizer::askedIfDue(const StopCondition &stop)
    {
        return operations_ - operationsWhenAsked_ >= OPERATIONS_BETWEEN_STOPS && asked(stop);
    }

    void FireflyOptimizer::inject(const Eigen::Ref<const Eigen::VectorXd> &x)
    {
        if (phase_ != Phase::Placing || cursor_ > 0)
        {
            throw std::logic_error("FireflyOptimizer: an unevaluated point can only be injected before the first step");
        }
        if (injected_ == settings_.populationSize)
        {
            throw std::logic_error("FireflyOptimizer: every member of the initial population was injected already");
        }
        population_.col(injected_++) = x.cwiseMax(lower_).cwiseMin(upper_);
    }

    void FireflyOptimizer::inject(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness &brightness,
                                  const ObjectiveFunction &objective)
    {
        if (phase_ == Phase::Placing || phase_ == Phase::Initial)
        {
            throw std::logic_error("FireflyOptimizer: the initial population has not been evaluated yet");
        }
        unsigned int dimmest = 0;
        for (unsigned int i = 1; i < settings_.populationSize; ++i)
        {
            if (objective.isBrighter(brightness_[dimmest], brightness_[i]))
            {
                dimmest = i;
            }
        }
        moved_.col(dimmest) = x.cwiseMax(lower_).cwiseMin(upper_);
        place(dimmest, moved_.col(dimmest), brightness, objective);
        moves_[dimmest] = false;
        runLength_ = 0;
        if (phase_ == Phase::Between)
        {
            sortByBrightness(objective, [] { return false; });
        }
    }

    void FireflyOptimizer::orderChanged(const ObjectiveFunction &objective)
    {
        runLength_ = 0;
        orderChanged_ = true;
        unsigned int brightest = 0;
        for (unsigned int i = 1; i < settings_.populationSize; ++i)
        {
            if (objective.isBrighter(brightness_[i], brightness_[brightest]))
            {
                brightest = i;
            }
        }
        if (!objective.isBrighter(brightness_[brightest], bestBrightness_))
        {
            return;
        }
        best_ = population_.col(brightest);
        bestBrightness_ = brightness_[brightest];
    }

    void FireflyOptimizer::restartEpoch()
    {
        epochGeneration_ = 0;
    }

    // Eq. (13): alpha_{t+1} = (1 / (2 Mmax))^(1 / Mmax) alpha_t, in closed form.
    double FireflyOptimizer::alpha() const
    {
        const double progress = static_cast<double>(epochGeneration_) / settings_.generations;
        switch (alphaSchedule())
        {
            case AlphaSchedule::Constant:
                return settings_.alpha;
            case AlphaSchedule::Geometric:
                return settings_.alpha * std::pow(1.0 / (2.0 * settings_.generations), progress);
            case AlphaSchedule::Yang:
                return settings_.alpha * std::pow(1e-4 / 0.9, progress);
            case AlphaSchedule::Linear:
                return settings_.alpha * (1.0 - progress);
        }
        return settings_.alpha;
    }

    // Eq. (14): beta0(t) = eta - t / MaxIter. It stays at 0 for eta < 1 rather than turn attraction into repulsion.
    double FireflyOptimizer::beta0() const
    {
        if (betaSchedule() == BetaSchedule::Constant)
        {
            return settings_.eta;
        }
        return std::max(0.0, settings_.eta - static_cast<double>(epochGeneration_) / settings_.generations);
    }

    // Coordinates are also drawn for injected fireflies, and discarded, so that the others do not depend on them.
    bool FireflyOptimizer::placeInitial(const StopCondition &stop)
    {
        for (; cursor_ < settings_.populationSize; ++cursor_)
        {
            if (askedIfDue(stop))
            {
                return false;
            }
            for (Eigen::Index k = 0; k < range_.size(); ++k)
            {
                const double drawn = std::min(lower_[k] + range_[k] * random_.uniform(), upper_[k]);
                if (cursor_ >= injected_)
                {
                    population_(k, cursor_) = drawn;
                }
            }
            operations_ += static_cast<std::uint64_t>(range_.size());
        }
        order_.resize(settings_.populationSize);
        std::iota(order_.begin(), order_.end(), 0U);
        cursor_ = 0;
        phase_ = Phase::Initial;
        return true;
    }

    bool FireflyOptimizer::evaluateInitial(ObjectiveFunction &objective, const StopCondition &stop)
    {
        if (cursor_ == 0)
        {
            objective.prepare(population_, moves_);
        }
        for (; cursor_ < settings_.populationSize; ++cursor_)
        {
            if (asked(stop))
            {
                return false;
            }
            place(cursor_, population_.col(cursor_), evaluate(objective, population_.col(cursor_), nullptr), objective);
        }
        if (!sortByBrightness(objective, stop))
        {
            return false;
        }
        phase_ = Phase::Between;
        return true;
    }

    bool FireflyOptimizer::beginGeneration(const ObjectiveFunction &objective, const StopCondition &stop)
    {
        if (orderChanged_ && !sortByBrightness(objective, stop))
        {
            return false;
        }
        if (epochGeneration_ == settings_.generations)
        {
            restartEpoch();
        }
        // The brightest firefly has nothing to move toward; those that are equally bright move at random (rule 2 of the
        // paper).
        std::fill(moves_.begin(), moves_.end(), true);
        moves_[order_.front()] = false;
        rank_ = 0;
        moving_ = false;
        phase_ = Phase::Moving;
        return true;
    }

    // population_ is unchanged until the last firefly has moved: fireflies attract from their positions at the
    // beginning of the generation.
    bool FireflyOptimizer::move(const StopCondition &stop)
    {
        const double beta0Now = beta0();
        const double alphaNow = alpha();
        for (; rank_ < settings_.populationSize; ++rank_, moving_ = false)
        {
            if (!moves_[order_[rank_]])
            {
                continue;
            }
            auto x = moved_.col(order_[rank_]);
            if (!moving_)
            {
                x = population_.col(order_[rank_]);
                movesLeft_ = brighter_[rank_];
                moving_ = true;
            }
            do
            {
                if (askedIfDue(stop))
                {
                    return false;
                }
                if (movesLeft_ > 0)
                {
                    const auto target = population_.col(order_[--movesLeft_]);
                    // Eq. (3), squared, in units of a tenth of each coordinate's range.
                    const double squaredDistance = ((x - target).cwiseProduct(inverseScale_)).squaredNorm();
                    // Eqs. (4) and (15).
                    const double absorbed = std::exp(-settings_.gamma * squaredDistance);
                    const double beta = settings_.betaMin + (beta0Now - settings_.betaMin) * absorbed;
                    // Eqs. (5) and (16).
                    x += beta * (target - x);
                }
                for (Eigen::Index k = 0; k < x.size(); ++k)
                {
                    x[k] += alphaNow * range_[k] * (random_.uniform() - 0.5);
                }
                x = x.cwiseMax(lower_).cwiseMin(upper_);
                operations_ += static_cast<std::uint64_t>(x.size());
            } while (movesLeft_ > 0);
        }
        cursor_ = 0;
        phase_ = Phase::Moves;
        return true;
    }

    bool FireflyOptimizer::evaluateMoves(ObjectiveFunction &objective, const StopCondition &stop)
    {
        if (cursor_ == 0)
        {
            objective.prepare(moved_, moves_);
        }
        for (; cursor_ < settings_.populationSize; ++cursor_)
        {
            if (!moves_[cursor_])
            {
                continue;
            }
            if (asked(stop))
            {
                return false;
            }
            place(cursor_, moved_.col(cursor_), evaluate(objective, moved_.col(cursor_), nullptr), objective);
        }
        if (!sortByBrightness(objective, stop))
        {
            return false;
        }
        cursor_ = settings_.variant == Variant::MFA ? 0 : settings_.populationSize;
        trial_ = 0;
        trialsMade_ = false;
        phase_ = Phase::Trials;
        return true;
    }

    bool FireflyOptimizer::evaluateTrials(ObjectiveFunction &objective, const StopCondition &stop)
    {
        for (; cursor_ < settings_.populationSize; ++cursor_, trial_ = 0, trialsMade_ = false)
        {
            if (!trialsMade_)
            {
                if (askedIfDue(stop))
                {
                    return false;
                }
                makeTrials(cursor_);
                trialsMade_ = true;
                objective.prepare(trials_, trialsWanted_);
            }
            for (; trial_ < TRIAL_VECTORS; ++trial_)
            {
                const auto candidate = trials_.col(trial_);
                // A trial that took every component from F_i is not evaluated.
                if (!settings_.trialVectors[trial_] || candidate == population_.col(cursor_))
                {
                    continue;
                }
                if (asked(stop))
                {
                    return false;
                }
                const Brightness rival = brightness_[cursor_];
                const Brightness brightness = evaluate(objective, candidate, &rival);
                if (objective.isBrighter(brightness, rival))
                {
                    place(cursor_, candidate, brightness, objective);
                }
            }
        }
        return true;
    }

    void FireflyOptimizer::makeTrials(unsigned int i)
    {
        const auto n = drawDistinct();
        const auto worst = population_.col(order_.back());
        const auto firefly = population_.col(i);

        // Eq. (6); the two lambda are drawn separately, or the sum would telescope.
        const double lambda1 = random_.uniform();
        const double lambda2 = random_.uniform();
        new1_ = population_.col(n[0]) + lambda1 * (population_.col(n[1]) - population_.col(n[2])) +
                lambda2 * (population_.col(n[2]) - population_.col(n[3]));
        // Eq. (7).
        new2_ = new1_ + random_.uniform() * (best_ - worst);
        for (Eigen::Index j = 0; j < new1_.size(); ++j)
        {
            const double k1 = random_.uniform();
            const double k2 = random_.uniform();
            const double k3 = random_.uniform();
            const double k4 = random_.uniform();
            trials_(j, 0) = k1 <= k2 ? new1_[j] : best_[j];    // Eq. (8).
            trials_(j, 1) = k3 <= k2 ? new1_[j] : firefly[j];  // Eq. (9).
            trials_(j, 2) = k4 <= k3 ? new2_[j] : firefly[j];  // Eq. (10).
        }
        // Eq. (11).
        trials_.col(3) = new2_;
        // Eq. (12).
        const double delta = random_.uniform();
        const double psi = random_.uniform();
        trials_.col(4) = delta * worst + psi * (best_ - worst);
        for (unsigned int trial = 0; trial < TRIAL_VECTORS; ++trial)
        {
            trials_.col(trial) = trials_.col(trial).cwiseMax(lower_).cwiseMin(upper_);
        }
        operations_ += static_cast<std::uint64_t>(trials_.size());
    }

    std::array<unsigned int, 4> FireflyOptimizer::drawDistinct()
    {
        std::array<unsigned int, 4> n{};
        for (unsigned int drawn = 0; drawn < n.size(); ++drawn)
        {
            do
            {
                {
                    n[drawn] = random_.index(settings_.populationSize);
                }
            } while (std::find(n.begin(), n.begin() + drawn, n[drawn]) != n.begin() + drawn);
        }
        return n;
    }

    bool FireflyOptimizer::endGeneration(const ObjectiveFunction &objective, const StopCondition &stop)
    {
        if (settings_.variant == Variant::MFA && !sortByBrightness(objective, stop))
        {
            return false;
        }
        ++generation_;
        ++epochGeneration_;
        phase_ = Phase::Between;
        return true;
    }

    // A merge sort from short runs to long ones: std::sort of a large population would take too long between two calls
    // of stop.
    bool FireflyOptimizer::sortByBrightness(const ObjectiveFunction &objective, const StopCondition &stop)
    {
        const auto brighter = [&](unsigned int a, unsigned int b)
        {
            if (objective.isBrighter(brightness_[a], brightness_[b]))
            {
                return true;
            }
            return a < b && !objective.isBrighter(brightness_[b], brightness_[a]);
        };
        const std::size_t size = order_.size();
        if (runLength_ == 0)
        {
            sorted_ = order_;
            runLength_ = 1;
            mergedUpTo_ = 0;
        }
        for (; runLength_ < size; runLength_ *= 2, mergedUpTo_ = 0)
        {
            while (mergedUpTo_ < size)
            {
                if (askedIfDue(stop))
                {
                    return false;
                }
                const std::size_t middle = std::min(mergedUpTo_ + runLength_, size);
                const std::size_t last = std::min(middle + runLength_, size);
                const auto at = [this](std::size_t i) { return sorted_.begin() + static_cast<std::ptrdiff_t>(i); };
                std::merge(at(mergedUpTo_), at(middle), at(middle), at(last),
                           merged_.begin() + static_cast<std::ptrdiff_t>(mergedUpTo_), brighter);
                operations_ += last - mergedUpTo_;
                mergedUpTo_ = last;
            }
            sorted_.swap(merged_);
        }
        order_.swap(sorted_);
        runLength_ = 0;
        orderChanged_ = false;
        countBrighter(objective);
        return true;
    }

    void FireflyOptimizer::countBrighter(const ObjectiveFunction &objective)
    {
        for (std::size_t rank = 1; rank < order_.size(); ++rank)
        {
            const bool dimmer = objective.isBrighter(brightness_[order_[rank - 1]], brightness_[order_[rank]]);
            brighter_[rank] = dimmer ? static_cast<unsigned int>(rank) : brighter_[rank - 1];
        }
        operations_ += order_.size();
    }

    Brightness FireflyOptimizer::evaluate(ObjectiveFunction &objective, const Eigen::Ref<const Eigen::VectorXd> &x,
                                          const Brightness *rival)
    {
        ++evaluations_;
        const Brightness brightness = objective.evaluate(x, rival);
        // A NaN would break the order.
        return std::isnan(brightness.violation) || std::isnan(brightness.cost) ? Brightness() : brightness;
    }

    void FireflyOptimizer::place(unsigned int i, const Eigen::Ref<const Eigen::VectorXd> &x,
                                 const Brightness &brightness, const ObjectiveFunction &objective)
    {
        population_.col(i) = x;
        brightness_[i] = brightness;
        if (objective.isBrighter(brightness, bestBrightness_))
        {
            best_ = x;
            bestBrightness_ = brightness;
        }
    }

    FireflyOptimizer::AlphaSchedule FireflyOptimizer::alphaSchedule() const
    {
        const auto usual = settings_.variant == Variant::FA ? AlphaSchedule::Constant : AlphaSchedule::Geometric;
        return settings_.alphaSchedule.value_or(usual);
    }

    FireflyOptimizer::BetaSchedule FireflyOptimizer::betaSchedule() const
    {
        const auto usual = settings_.variant == Variant::FA ? BetaSchedule::Constant : BetaSchedule::Decreasing;
        return settings_.betaSchedule.value_or(usual);
    }
}  // namespace ompl_mfa
