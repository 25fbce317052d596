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

#include "report/Statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>

namespace ompl_mfa::report
{
    namespace
    {
        void requireValues(const std::vector<double> &values)
        {
            if (values.empty())
            {
                throw std::invalid_argument("a median needs at least one value");
            }
        }

        double medianOfSorted(const std::vector<double> &sorted)
        {
            const double low = sorted[(sorted.size() - 1) / 2];
            const double high = sorted[sorted.size() / 2];
            return low + (low == high ? 0.0 : (high - low) / 2);
        }

        /* Coverage of the interval from the r-th smallest to the r-th largest of n values. */
        double coverageOf(std::size_t r, std::size_t n)
        {
            const boost::math::binomial_distribution<double> heads(static_cast<double>(n), 0.5);
            return 1.0 - 2.0 * cdf(heads, static_cast<double>(r) - 1.0);
        }

        double normalDensity(double x)
        {
            return std::exp(-x * x / 2) / std::sqrt(2 * std::acos(-1.0));
        }

        double normalProbability(double x)
        {
            return std::erfc(-x / std::sqrt(2.0)) / 2;
        }

        /* Probability that the range of \e count standard normal values is at most \e range, by Simpson's rule over
           the largest of them. */
        double rangeProbability(double range, std::size_t count)
        {
            constexpr int STEPS = 2000;
            constexpr double END = 9.0;
            const double step = 2 * END / STEPS;
            double sum = 0.0;
            for (int i = 0; i <= STEPS; ++i)
            {
                const double largest = -END + i * step;
                const double others = normalProbability(largest) - normalProbability(largest - range);
                const double weight = i == 0 || i == STEPS ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
                sum += weight * normalDensity(largest) * std::pow(others, static_cast<double>(count) - 1.0);
            }
            return static_cast<double>(count) * sum * step / 3;
        }

        /* Sum of (t^3 - t) over the groups of t equal values. */
        double tieCorrection(const std::vector<double> &values)
        {
            std::map<double, double> counts;
            for (const double value : values)
            {
                counts[value] += 1.0;
            }
            double sum = 0.0;
            for (const auto &[value, count] : counts)
            {
                sum += count * count * count - count;
            }
            return sum;
        }
    }  // namespace

    double median(std::vector<double> values)
    {
        requireValues(values);
        std::sort(values.begin(), values.end());
        return medianOfSorted(values);
    }

    Estimate medianEstimate(std::vector<double> values, double level)
    {
        requireValues(values);
        std::sort(values.begin(), values.end());
        const std::size_t count = values.size();
        std::size_t r = 1;
        while (2 * (r + 1) <= count && coverageOf(r + 1, count) >= level)
        {
            ++r;
        }
        return {medianOfSorted(values), values[r - 1], values[count - r], coverageOf(r, count)};
    }

    Estimate proportionEstimate(std::size_t successes, std::size_t runs, double level)
    {
        if (runs == 0 || successes > runs)
        {
            throw std::invalid_argument("a share needs at least one run, and no more successes than runs");
        }
        using Binomial = boost::math::binomial_distribution<double>;
        const auto n = static_cast<double>(runs);
        const auto k = static_cast<double>(successes);
        const double tail = (1.0 - level) / 2;
        return {k / n, successes == 0 ? 0.0 : Binomial::find_lower_bound_on_p(n, k, tail),
                successes == runs ? 1.0 : Binomial::find_upper_bound_on_p(n, k, tail), level};
    }

    Estimate medianRatio(const std::vector<double> &numerators, const std::vector<double> &denominators, double limit,
                         double level)
    {
        const Estimate above = medianEstimate(numerators, std::sqrt(level));
        const Estimate below = medianEstimate(denominators, std::sqrt(level));
        return {std::min(above.value, limit) / std::min(below.value, limit), std::min(above.lower, limit) / below.upper,
                above.upper / std::min(below.lower, limit), above.coverage * below.coverage};
    }

    std::vector<double> ranksOf(const std::vector<double> &values)
    {
        std::vector<std::size_t> order(values.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
        std::vector<double> ranks(values.size());
        for (std::size_t first = 0; first < order.size();)
        {
            std::size_t end = first + 1;
            while (end < order.size() && values[order[end]] == values[order[first]])
            {
                ++end;
            }
            for (std::size_t i = first; i < end; ++i)
            {
                ranks[order[i]] = static_cast<double>(first + end + 1) / 2;
            }
            first = end;
        }
        return ranks;
    }

    Friedman friedman(const std::vector<std::vector<double>> &blocks)
    {
        if (blocks.size() < 2 || blocks.front().size() < 2)
        {
            throw std::invalid_argument("Friedman's test needs at least two blocks and two treatments");
        }
        const auto n = static_cast<double>(blocks.size());
        const auto k = static_cast<double>(blocks.front().size());
        Friedman result;
        result.meanRanks.assign(blocks.front().size(), 0.0);
        double ties = 0.0;
        for (const std::vector<double> &block : blocks)
        {
            const std::vector<double> ranks = ranksOf(block);
            for (std::size_t i = 0; i < ranks.size(); ++i)
            {
                result.meanRanks[i] += ranks[i] / n;
            }
            ties += tieCorrection(block);
        }
        double squares = 0.0;
        for (const double rank : result.meanRanks)
        {
            squares += (rank - (k + 1) / 2) * (rank - (k + 1) / 2);
        }
        const double correction = 1.0 - ties / (n * k * (k * k - 1));
        if (correction > 0.0)
        {
            result.statistic = 12 * n * squares / (k * (k + 1)) / correction;
            result.pValue = cdf(complement(boost::math::chi_squared_distribution<double>(k - 1), result.statistic));
        }
        return result;
    }

    double criticalDifference(std::size_t treatments, std::size_t blocks, double significance)
    {
        double low = 0.0;
        double high = 20.0;
        while (high - low > 1e-9)
        {
            const double middle = (low + high) / 2;
            (rangeProbability(middle, treatments) < 1.0 - significance ? low : high) = middle;
        }
        const auto k = static_cast<double>(treatments);
        return low / std::sqrt(2.0) * std::sqrt(k * (k + 1) / (6 * static_cast<double>(blocks)));
    }

    double signedRankPValue(const std::vector<double> &differences)
    {
        std::vector<double> sizes;
        std::vector<bool> positive;
        for (const double difference : differences)
        {
            if (difference != 0.0)
            {
                sizes.push_back(std::abs(difference));
                positive.push_back(difference > 0.0);
            }
        }
        // ranks are doubled, so that those of ties are integers too
        std::vector<std::size_t> ranks;
        std::size_t sum = 0;
        std::size_t total = 0;
        for (const double rank : ranksOf(sizes))
        {
            ranks.push_back(static_cast<std::size_t>(std::lround(2 * rank)));
            sum += positive[ranks.size() - 1] ? ranks.back() : 0;
            total += ranks.back();
        }
        // the probability of each sum of ranks if every sign is a toss of a coin
        std::vector<double> probability(total + 1, 0.0);
        probability[0] = 1.0;
        for (const std::size_t rank : ranks)
        {
            for (std::size_t i = total + 1; i-- > 0;)
            {
                probability[i] = (probability[i] + (i >= rank ? probability[i - rank] : 0.0)) / 2;
            }
        }
        const auto end = probability.begin() + static_cast<std::ptrdiff_t>(std::min(sum, total - sum)) + 1;
        return std::min(1.0, 2 * std::accumulate(probability.begin(), end, 0.0));
    }

    std::vector<double> holmCorrected(const std::vector<double> &pValues)
    {
        std::vector<std::size_t> order(pValues.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pValues[a] < pValues[b]; });
        std::vector<double> corrected(pValues.size());
        double largest = 0.0;
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            largest = std::max(largest, std::min(1.0, static_cast<double>(order.size() - i) * pValues[order[i]]));
            corrected[order[i]] = largest;
        }
        return corrected;
    }
}  // namespace ompl_mfa::report
