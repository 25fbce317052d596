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

#ifndef OMPL_MFA_BENCHMARK_PATH_METRICS_
#define OMPL_MFA_BENCHMARK_PATH_METRICS_

#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief Measures that are comparable only between paths with equally spaced states. */
    struct PathMetrics
    {
        /** \brief Smallest clearance of a state, in the units of the validity checker's clearance(). */
        double minimumClearance{0.0};
        /** \brief OMPL's PathGeometric::smoothness(); 0 for a straight motion. */
        double smoothness{0.0};
    };

    /** \brief States along \e path at equal distances of at most \e step > 0 (in the state space), both ends included;
        the vertices of \e path are not kept. At most 5000 motions. */
    OMPL_MFA_EXPORT ompl::geometric::PathGeometric resamplePath(const ompl::geometric::PathGeometric &path,
                                                                double step);

    /** \brief Measures \e path resampled at the space's longest valid segment length. PathGeometric::clearance() is a
        mean over the vertices and smoothness() depends on how far apart they are: neither is comparable between
        planners. */
    OMPL_MFA_EXPORT PathMetrics measurePath(const ompl::geometric::PathGeometric &path);
}  // namespace ompl_mfa::benchmark

#endif
