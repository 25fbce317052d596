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

#ifndef OMPL_MFA_TEST_ENGINE_GRAPH_RANDOM_GRAPH_
#define OMPL_MFA_TEST_ENGINE_GRAPH_RANDOM_GRAPH_

/* Graphs given by tables of costs and validity, and OMPL's classes that answer from these tables. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ompl_mfa::engine::graph
{
    namespace ob = ompl::base;

    constexpr double INFINITE = std::numeric_limits<double>::infinity();

    enum class Algebra
    {
        Sum,        ///< less is better
        Gain,       ///< a sum of which more is better
        Bottleneck  ///< the worst motion counts
    };

    struct Motions
    {
        std::size_t from;
        std::size_t to;
        bool bothWays;
    };

    /* A graph with integer costs, which add up without rounding. Vertex i is the state (i, i^2), so that the middle
       of a motion identifies it. */
    struct RandomGraph
    {
        Algebra algebra{Algebra::Sum};
        std::size_t size{0};
        std::vector<Motions> motions;
        std::vector<std::vector<double>> cost;
        std::vector<double> initial;
        std::vector<double> terminal;
        std::vector<std::size_t> starts;
        std::vector<std::size_t> goals;
        std::vector<bool> validVertex;
        std::vector<std::vector<bool>> validMotion;
        std::vector<std::vector<bool>> validMiddle;

        bool isValid(std::size_t from, std::size_t to) const
        {
            return validMotion[from][to] && validMiddle[from][to];
        }
    };

    inline std::ostream &operator<<(std::ostream &out, const RandomGraph &graph)
    {
        out << "algebra " << static_cast<int>(graph.algebra) << ", " << graph.size << " vertices;";
        for (const auto s : graph.starts)
        {
            out << " start " << s << " (" << graph.initial[s] << ")";
        }
        for (const auto g : graph.goals)
        {
            out << " goal " << g << " (" << graph.terminal[g] << ")";
        }
        for (const auto &m : graph.motions)
        {
            out << "; " << m.from << (m.bothWays ? " <-> " : " -> ") << m.to << ": " << graph.cost[m.from][m.to];
            if (m.bothWays)
            {
                out << " / " << graph.cost[m.to][m.from];
            }
            if (!graph.isValid(m.from, m.to))
            {
                out << " invalid";
            }
        }
        return out;
    }

    class TableObjective : public ob::OptimizationObjective
    {
    public:
        TableObjective(const ob::SpaceInformationPtr &si, const RandomGraph &graph)
          : OptimizationObjective(si)
          , graph_(graph)
        {
        }

        static std::size_t number(const ob::State *state)
        {
            return static_cast<std::size_t>(state->as<ob::RealVectorStateSpace::StateType>()->values[0]);
        }

        bool isCostBetterThan(ob::Cost a, ob::Cost b) const override
        {
            return graph_.algebra == Algebra::Gain ? a.value() > b.value() : a.value() < b.value();
        }

        ob::Cost infiniteCost() const override
        {
            return ob::Cost(graph_.algebra == Algebra::Gain ? -INFINITE : INFINITE);
        }

        ob::Cost identityCost() const override
        {
            return ob::Cost(graph_.algebra == Algebra::Bottleneck ? -INFINITE : 0.0);
        }

        ob::Cost combineCosts(ob::Cost a, ob::Cost b) const override
        {
            return ob::Cost(graph_.algebra == Algebra::Bottleneck ? std::max(a.value(), b.value())
                                                                  : a.value() + b.value());
        }

        ob::Cost stateCost(const ob::State *) const override
        {
            return identityCost();
        }

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            return ob::Cost(graph_.cost[number(from)][number(to)]);
        }

        ob::Cost initialCost(const ob::State *state) const override
        {
            return ob::Cost(graph_.initial[number(state)]);
        }

        ob::Cost terminalCost(const ob::State *state) const override
        {
            return ob::Cost(graph_.terminal[number(state)]);
        }

    private:
        const RandomGraph &graph_;
    };

    class TableMotionValidator : public ob::MotionValidator
    {
    public:
        TableMotionValidator(const ob::SpaceInformationPtr &si, const RandomGraph &graph)
          : MotionValidator(si)
          , graph_(graph)
        {
        }

        bool checkMotion(const ob::State *from, const ob::State *to) const override
        {
            return graph_.isValid(TableObjective::number(from), TableObjective::number(to));
        }

        bool checkMotion(const ob::State *from, const ob::State *to, std::pair<ob::State *, double> &) const override
        {
            return checkMotion(from, to);
        }

    private:
        const RandomGraph &graph_;
    };
}  // namespace ompl_mfa::engine::graph

#endif
