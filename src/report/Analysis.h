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

#ifndef OMPL_MFA_REPORT_ANALYSIS_
#define OMPL_MFA_REPORT_ANALYSIS_

#include <array>
#include <map>
#include <string>
#include <vector>

#include "report/Results.h"
#include "report/Statistics.h"

namespace ompl_mfa::report
{
    /** \brief Level of all intervals. */
    constexpr double CONFIDENCE = 0.95;

    /** \brief A quality whose time is measured: the first path, or a cost at most `excess` above the best known. */
    struct Level
    {
        const char *name;
        double excess;
    };

    constexpr std::array<Level, 5> LEVELS{
        {{"first path", 0.0}, {"10 %", 0.1}, {"5 %", 0.05}, {"1 %", 0.01}, {"0.1 %", 0.001}}};

    /** \brief The time to one level of one planner. Times are in seconds, infinite for runs that do not get there. */
    struct LevelTime
    {
        Estimate time;
        std::size_t reached{0};
        /** \brief The other planner with the least median; empty if none of them gets there. */
        std::string peer;
        /** \brief Whether `speed` has a meaning: this planner or the peer gets there. */
        bool isCompared{false};
        /** \brief The peer's median divided by this planner's. */
        Estimate speed;
        /** \brief 1 if `speed` is a lower bound, because the peer does not get there and counts with the time limit; -1
            if it is an upper bound, because this planner does not; otherwise 0. */
        int bound{0};
    };

    /** \brief The results of all runs at one time. */
    struct CurvePoint
    {
        double time{0.0};
        Estimate solved;  ///< share of the runs, in [0, 1]
        Estimate cost;    ///< median; infinite for runs without a path
    };

    /** \brief The statistics of one planner in one experiment. */
    struct PlannerSummary
    {
        std::string name;
        std::size_t runs{0};
        std::size_t solved{0};
        std::size_t ended{0};
        Estimate success;
        Estimate finalCost;
        std::vector<LevelTime> levels;  ///< as in LEVELS
        std::vector<CurvePoint> curve;
    };

    /** \brief The statistics of one experiment. */
    struct ExperimentSummary
    {
        std::string name;
        /** \brief The best cost known: the lowest of these runs, or the reference if that is lower; infinite if there
            is none. */
        double bestCost{0.0};
        bool isReference{false};
        /** \brief The end of all curves, in seconds. */
        double timeLimit{0.0};
        std::vector<PlannerSummary> planners;
    };

    /** \brief Shares of the experiments in which a planner needs at most a factor times the time of the best one. */
    struct PerformanceProfile
    {
        std::string level;
        /** \brief Experiments in which some planner gets to the level. */
        std::size_t experiments{0};
        std::vector<double> factors;
        /** \brief For each planner of the ranking a share per factor. */
        std::vector<std::vector<double>> shares;
    };

    /** \brief The planners ranked over all experiments by one measure. */
    struct Ranking
    {
        std::string measure;
        Friedman test;
        /** \brief Mean ranks that differ by more are significantly different (Nemenyi, 5 %). */
        double criticalDifference{0.0};
        /** \brief Planners, as indices of Comparison::planners, from the best mean rank on. */
        std::vector<std::size_t> order;
        /** \brief In the order of `order`: the p-value of the difference from the best planner by Wilcoxon's
            signed-rank test, corrected by Holm's method for all pairs; 1 for the best planner itself. */
        std::vector<double> againstBest;
    };

    /** \brief Statistics over several experiments, of the planners that are in all of them. */
    struct Comparison
    {
        std::vector<std::string> planners;
        std::vector<PerformanceProfile> profiles;
        std::vector<Ranking> rankings;
    };

    /** \brief The statistics of \e experiment. \e reference is a cost known from elsewhere, infinite for none. */
    ExperimentSummary summarize(const Experiment &experiment, double reference);

    /** \brief The comparison over \e experiments; without planners, profiles and rankings if there are not at least two
        experiments with at least two common planners. */
    Comparison compare(const std::vector<ExperimentSummary> &experiments);
}  // namespace ompl_mfa::report

#endif
