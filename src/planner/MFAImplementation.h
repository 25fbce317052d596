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

#ifndef OMPL_MFA_PLANNER_MFAIMPLEMENTATION_
#define OMPL_MFA_PLANNER_MFAIMPLEMENTATION_

#include <memory>
#include <vector>

#include <ompl/util/RandomNumbers.h>

#include "engine/Engine.h"
#include "engine/SearchProgress.h"
#include "engine/SearchSettings.h"
#include "ompl_mfa/planner/MFA.h"
#include "planner/SearchLock.h"
#include "planner/SolutionPublisher.h"

namespace ompl_mfa
{
    /** \brief What MFA adds to the engine: the parameters for the next query, the lock between solve() and readers, and
        the published solutions. */
    class MFA::Implementation
    {
    public:
        /** \brief Sets a parameter by its member; throws ompl::Exception naming \e planner, the parameter, the value
           and what is accepted. */
        template <typename T>
        void set(const MFA &planner, T engine::SearchSettings::*member, const T &value);

        engine::SearchSettings settings;  ///< parameters as set, for the next query
        ompl::base::PlannerAllocator guidePlanner;
        path::StateChartPtr chart;
        engine::SearchProgress progress;
        std::unique_ptr<engine::Engine> engine;       ///< of the present query, made by its first solve()
        std::unique_ptr<engine::Engine> predecessor;  ///< an ended search that the next one inherits from; may be null
        bool sameValidity{true};                      ///< whether what the predecessor knows of validity still holds
        std::uint64_t successors{0};                  ///< number of searches that inherited, since one did not
        std::vector<path::Waypoints> hints;           ///< for the next solve()
        planner::SolutionPublisher publisher;
        ompl::RNG rng;  ///< draws seeds for runs without one
        mutable planner::SearchLock lock;
    };
}  // namespace ompl_mfa

#endif
