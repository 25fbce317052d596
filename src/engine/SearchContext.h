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

#ifndef OMPL_MFA_ENGINE_SEARCH_CONTEXT_
#define OMPL_MFA_ENGINE_SEARCH_CONTEXT_

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Planner.h>

#include "engine/Incumbent.h"
#include "engine/PathPool.h"
#include "engine/Query.h"
#include "engine/SearchProgress.h"
#include "engine/SearchSettings.h"
#include "engine/Streams.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"

namespace ompl_mfa::engine
{
    /** \brief The data that all parts of a search share: they read it, and only the engine changes it. */
    class SearchContext
    {
    private:
        std::unique_ptr<path::PathEvaluator> evaluator_;  // first, as others refer to it
        std::atomic<double> incumbentCost_;

    public:
        /** \brief \e planner is used to choose the nearest-neighbour structure for the space. \e runSeed != 0 is the
            seed of the run. \e planner and \e shown must outlive the context. */
        SearchContext(const ompl::base::Planner &planner, path::StateChartPtr stateChart,
                      const ompl::base::OptimizationObjectivePtr &objective, SearchSettings frozen,
                      std::uint64_t runSeed, SearchProgress &shown);

        /** \brief Whether a start and a goal state are known. */
        bool hasEnds() const
        {
            return !query.starts().empty() && !query.goals().empty();
        }

        /** \brief The stride of drafts (see PathEvaluator::setStride), by which a check of the best path still has a
           few dozen states; 1 before there is a path of finite cost. */
        unsigned int draftStride() const;

        const ompl::base::SpaceInformationPtr &spaceInformation() const
        {
            return evaluator_->spaceInformation();
        }

        const ompl::base::OptimizationObjective &objective() const
        {
            return *evaluator_->objective();
        }

        /** \brief The evaluator of the search, which counts its work. */
        path::PathEvaluator &evaluator() const
        {
            return *evaluator_;
        }

        const ompl::base::Planner &owner;
        const path::StateChartPtr chart;
        const SearchSettings settings;
        const std::uint64_t seed;
        SearchProgress &progress;
        Query query;
        Incumbent incumbent;
        Incumbent answer;  ///< the path to return: the best one that holds at a finer resolution, see StrictAnswer
        PathPool pool;
        std::vector<path::Waypoints> firstFireflies;  ///< hints, valid or not, for swarms not begun yet
    };
}  // namespace ompl_mfa::engine

#endif
