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

#ifndef OMPL_MFA_TEST_OPTIMIZER_FIREFLY_ORACLE_
#define OMPL_MFA_TEST_OPTIMIZER_FIREFLY_ORACLE_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

/** \brief One run of FA or MFA, written from the formulas with plain loops, as a reference for the optimiser. Shares
    only the order of random draws with it. Costs only, no violations. */
class FireflyOracle
{
public:
    using Point = std::vector<double>;

    struct Parameters
    {
        bool mfa;
        unsigned int size;
        unsigned int epoch;
        double gamma;
        double alpha;
        double eta;
    };

    FireflyOracle(const Parameters &parameters, const Point &lower, const Point &upper,
                  std::function<double(const Point &)> function, std::uint64_t seed)
      : parameters_(parameters)
      , lower_(lower)
      , upper_(upper)
      , function_(std::move(function))
      , engine_(seed)
    {
        for (unsigned int i = 0; i < parameters_.size; ++i)
        {
            Point x;
            for (std::size_t k = 0; k < lower_.size(); ++k)
            {
                x.push_back(lower_[k] + (upper_[k] - lower_[k]) * uniform());
            }
            points.push_back(x);
        }
        for (const auto &x : points)
        {
            costs.push_back(evaluate(x));
        }
    }

    void generation(unsigned int t)
    {
        const double m = parameters_.epoch;
        const double alpha =
            parameters_.mfa ? parameters_.alpha * std::pow(std::pow(1 / (2 * m), 1 / m), t) : parameters_.alpha;
        const double beta0 = parameters_.mfa ? parameters_.eta - t / m : parameters_.eta;
        moves(alpha, beta0);
        if (parameters_.mfa)
        {
            trials();
        }
    }

    std::vector<Point> points;
    std::vector<double> costs;
    Point best;
    double bestCost{INFINITY};

private:
    double uniform()
    {
        return std::ldexp(static_cast<double>(engine_() >> 11), -53);
    }

    double evaluate(const Point &x)
    {
        const double cost = function_(x);
        if (cost < bestCost)
        {
            bestCost = cost;
            best = x;
        }
        return cost;
    }

    std::vector<unsigned int> brightestFirst() const
    {
        std::vector<unsigned int> order;
        for (unsigned int i = 0; i < parameters_.size; ++i)
        {
            order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(),
                         [this](unsigned int a, unsigned int b) { return costs[a] < costs[b]; });
        return order;
    }

    void clamp(Point &x) const
    {
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            x[k] = std::max(lower_[k], std::min(upper_[k], x[k]));
        }
    }

    void moves(double alpha, double beta0)
    {
        const auto order = brightestFirst();
        const auto before = points;
        for (unsigned int rank = 1; rank < parameters_.size; ++rank)
        {
            Point &x = points[order[rank]];
            if (costs[order[rank]] == costs[order.front()])
            {
                for (std::size_t k = 0; k < x.size(); ++k)
                {
                    x[k] += alpha * (upper_[k] - lower_[k]) * (uniform() - 0.5);
                }
                clamp(x);
            }
            for (unsigned int brighter = rank; brighter > 0; --brighter)
            {
                const Point &other = before[order[brighter - 1]];
                if (!(costs[order[brighter - 1]] < costs[order[rank]]))
                {
                    continue;
                }
                double squared = 0.0;
                for (std::size_t k = 0; k < x.size(); ++k)
                {
                    squared += std::pow(10 * (x[k] - other[k]) / (upper_[k] - lower_[k]), 2);
                }
                const double beta = beta0 * std::exp(-parameters_.gamma * squared);
                for (std::size_t k = 0; k < x.size(); ++k)
                {
                    x[k] += beta * (other[k] - x[k]) + alpha * (upper_[k] - lower_[k]) * (uniform() - 0.5);
                }
                clamp(x);
            }
        }
        for (unsigned int i = 0; i < parameters_.size; ++i)
        {
            if (i != order.front())
            {
                costs[i] = evaluate(points[i]);
            }
        }
    }

    void trials()
    {
        const unsigned int worst = brightestFirst().back();
        for (unsigned int i = 0; i < parameters_.size; ++i)
        {
            for (auto &trial : makeTrials(i, worst))
            {
                clamp(trial);
                if (trial == points[i])
                {
                    continue;
                }
                const double cost = evaluate(trial);
                if (cost < costs[i])
                {
                    points[i] = trial;
                    costs[i] = cost;
                }
            }
        }
    }

    std::array<Point, 5> makeTrials(unsigned int i, unsigned int worstIndex)
    {
        std::vector<unsigned int> n;
        while (n.size() < 4)
        {
            const auto drawn = static_cast<unsigned int>(std::floor(uniform() * parameters_.size));
            if (std::count(n.begin(), n.end(), drawn) == 0)
            {
                n.push_back(drawn);
            }
        }
        const Point &worst = points[worstIndex];
        const double l1 = uniform();
        const double l2 = uniform();
        const double l3 = uniform();
        std::array<Point, 5> trials;
        Point new1;
        Point new2;
        for (std::size_t j = 0; j < lower_.size(); ++j)
        {
            new1.push_back(points[n[0]][j] + l1 * (points[n[1]][j] - points[n[2]][j]) +
                           l2 * (points[n[2]][j] - points[n[3]][j]));
            new2.push_back(new1[j] + l3 * (best[j] - worst[j]));
        }
        for (std::size_t j = 0; j < lower_.size(); ++j)
        {
            const double k1 = uniform();
            const double k2 = uniform();
            const double k3 = uniform();
            const double k4 = uniform();
            trials[0].push_back(k1 <= k2 ? new1[j] : best[j]);
            trials[1].push_back(k3 <= k2 ? new1[j] : points[i][j]);
            trials[2].push_back(k4 <= k3 ? new2[j] : points[i][j]);
        }
        trials[3] = new2;
        const double delta = uniform();
        const double psi = uniform();
        for (std::size_t j = 0; j < lower_.size(); ++j)
        {
            trials[4].push_back(delta * worst[j] + psi * (best[j] - worst[j]));
        }
        return trials;
    }

    Parameters parameters_;
    Point lower_;
    Point upper_;
    std::function<double(const Point &)> function_;
    std::mt19937_64 engine_;
};

#endif
