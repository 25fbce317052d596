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

#ifndef OMPL_MFA_REPORT_STATISTICS_
#define OMPL_MFA_REPORT_STATISTICS_

#include <cstddef>
#include <vector>

namespace ompl_mfa::report
{
    /** \brief A value and its confidence interval. Any of the three numbers may be infinite. */
    struct Estimate
    {
        double value{0.0};
        double lower{0.0};
        double upper{0.0};
        /** \brief Probability, in [0, 1], with which the interval covers the true value, or a lower bound of it. */
        double coverage{0.0};
    };

    /** \brief The median; of an even number of values the mean of the middle two. Infinity counts as a value above all
        others. Throws std::invalid_argument if there are no values. */
    double median(std::vector<double> values);

    /** \brief The median of \e values with the interval between the r-th smallest and the r-th largest of them, where r
        is the largest number for which the interval covers the median of the population with at least \e level,
        whatever its distribution. With too few values it is their range, of a lower coverage. Throws
        std::invalid_argument if there are no values. */
    Estimate medianEstimate(std::vector<double> values, double level);

    /** \brief The share of \e successes among \e runs with the exact interval of Clopper and Pearson. Throws
        std::invalid_argument if there are no runs or fewer than successes. */
    Estimate proportionEstimate(std::size_t successes, std::size_t runs, double level);

    /** \brief The ratio median(\e numerators) / median(\e denominators) of independent samples of times, of which those
        above \e limit, as of runs that were stopped then, are infinite.

        In the value, an infinite median counts as \e limit. The interval joins those of both medians, each with a
        coverage of at least the root of \e level, so that both are right with at least \e level; it is wider than
        necessary. It covers the ratio of runs without the limit: an end whose time was not observed is at least \e
        limit, so that the interval may end with 0 or infinity. */
    Estimate medianRatio(const std::vector<double> &numerators, const std::vector<double> &denominators, double limit,
                         double level);

    /** \brief Ranks from 1 for the smallest value on; equal values share the mean of their ranks. */
    std::vector<double> ranksOf(const std::vector<double> &values);

    /** \brief Friedman's test of whether several treatments differ. */
    struct Friedman
    {
        std::vector<double> meanRanks;  ///< for each treatment; 1 is the best
        double statistic{0.0};          ///< chi-squared, corrected for ties; 0 if all values are equal
        double pValue{1.0};             ///< from the chi-squared distribution
    };

    /** \brief Friedman's test on \e blocks, each with the value of every treatment; smaller is better. Throws
        std::invalid_argument unless there are at least two blocks and two treatments. */
    Friedman friedman(const std::vector<std::vector<double>> &blocks);

    /** \brief Nemenyi's critical difference at \e significance, in (0, 1): mean ranks over \e blocks blocks of two of
        \e treatments treatments that differ by more are significantly different. */
    double criticalDifference(std::size_t treatments, std::size_t blocks, double significance);

    /** \brief Two-sided p-value of Wilcoxon's signed-rank test on \e differences, exact for any number of them and with
        ties. Differences of 0 are left out; 1 if none remains. */
    double signedRankPValue(const std::vector<double> &differences);

    /** \brief \e pValues corrected for testing all of them, by the method of Holm. */
    std::vector<double> holmCorrected(const std::vector<double> &pValues);
}  // namespace ompl_mfa::report

#endif
