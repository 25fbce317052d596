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

#ifndef OMPL_MFA_BENCHMARK_RESTART_SIMPLIFY_
#define OMPL_MFA_BENCHMARK_RESTART_SIMPLIFY_

#include <atomic>
#include <cstdint>
#include <memory>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief What is often done in practice instead of optimal planning: RRT-Connect is started again and again until
        the time is over, each of its paths is simplified by OMPL's PathSimplifier until that finds nothing more, and
        the path of least cost is kept.

        Starts and goals are those that RRT-Connect takes. Every better path is added to the problem and passed to its
        callback for intermediate solutions at once, as RRT-Connect found it and again when it is simplified; paths that
        fail check() after their simplification are dropped. The objective is the problem's, or path length if it has
        none; solve() returns early when it is satisfied. The condition is not evaluated within an operation of the
        simplification, so that solve() may return late by as much.

        A further solve() keeps the best path and goes on with trees that were not joined yet; another query in the same
        problem definition needs clear() before. */
    class OMPL_MFA_EXPORT RestartSimplify : public ompl::base::Planner
    {
    public:
        explicit RestartSimplify(const ompl::base::SpaceInformationPtr &si);

        void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;

        void setup() override;

        void clear() override;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;

        /** \brief The trees of the latest start of RRT-Connect. */
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \brief The largest length of a motion of RRT-Connect's trees; 0 lets setup() choose, as RRT-Connect does. */
        void setRange(double range);
        double getRange() const;

        /** \brief Cost of the best path, infinite without one. May be called by another thread during solve(). */
        double bestCost() const;

        /** \brief Paths that RRT-Connect has found since the last clear(). May be called by another thread. */
        std::uint64_t pathsFound() const;

    private:
        ompl::base::PlannerStatus findPath(const ompl::base::PlannerTerminationCondition &ptc);
        void startTrees();
        void simplify(const ompl::base::PlannerTerminationCondition &ptc);
        bool improves(const ompl::geometric::PathGeometric &path) const;
        bool isSatisfied() const;
        void keep(const ompl::geometric::PathGeometric &path);
        bool isPublished() const;
        void addSolution();
        void addApproximateSolution() const;
        void forget();

        std::shared_ptr<ompl::geometric::RRTConnect> trees_;
        // RRT-Connect has its problem to itself, a new one for each start
        ompl::base::ProblemDefinitionPtr treesProblem_;
        bool treesJoined_{false};
        ompl::base::OptimizationObjectivePtr objective_;
        std::shared_ptr<ompl::geometric::PathGeometric> best_;
        ompl::base::PathPtr published_;
        std::atomic<double> bestCost_;
        std::atomic<std::uint64_t> pathsFound_{0};
    };
}  // namespace ompl_mfa::benchmark

#endif
