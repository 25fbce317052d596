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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_TEXT_
#define OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_TEXT_

#include <string>
#include <vector>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::anytime
{
    /** \brief RRT*, Informed RRT*, PRM*, BIT*, ABIT*, AIT*, AnytimePathShortening, RRT-Connect restarted and
       simplified, and those of EIT*, BLIT* and AORRTC that the linked OMPL has; RRT-Connect for its first solutions. */
    std::vector<std::string> peers();

    /** \brief Splits `A,B:KEY=VALUE,KEY=VALUE,C` into `A`, `B:KEY=VALUE,KEY=VALUE` and `C`; `peers` stands for all
        peers(). Throws InputError for an empty list. */
    std::vector<std::string> splitPlanners(const std::string &text);

    /** \brief Reads `PLANNER` or `PLANNER:KEY=VALUE,...`. Throws InputError for an unknown planner or invalid syntax;
        the parameters are checked when the planner is made. */
    benchmark::PlannerSpec parsePlanner(const std::string &text);
}  // namespace ompl_mfa::anytime

#endif
