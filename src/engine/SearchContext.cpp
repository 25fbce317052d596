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

#include "engine/SearchContext.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa::engine
{
    namespace
    {
        /* Fireflies of the swarm of whole paths, unless the user sets the population's size. */
        constexpr std::size_t POOL_CAPACITY = 8;
        /* Greatest stride of a draft, and the least number of states at which it checks the best path. */
        constexpr std::uint64_t MAX_STRIDE = 8;
        constexpr std::uint64_t LEAST_STATES = 48;

        std::size_t poolCapacity(const SearchSettings &settings)
        {
            if (!settings.usesPool())
            {
                return 0;
            }
            return settings.populationSize != 0 ? settings.populationSize : POOL_CAPACITY;
        }
    }  // namespace

    SearchContext::SearchContext(const ompl::base::Planner &planner, path::StateChartPtr stateChart,
                                 const ompl::base::OptimizationObjectivePtr &objective, SearchSettings frozen,
                                 std::uint64_t runSeed, SearchProgress &shown)
      : evaluator_(std::make_unique<path::PathEvaluator>(planner.getSpaceInformation(), objective, frozen.threads))
      , owner(planner)
      , chart(std::move(stateChart))
      , settings(std::move(frozen))
      , seed(runSeed)
      , progress(shown)
      , query(planner.getSpaceInformation()->getStateSpace())
      , incumbent(objective, planner.getSpaceInformation()->getStateSpace(), incumbentCost_)
      , answer(objective, planner.getSpaceInformation()->getStateSpace(), shown.bestCost)
      , pool(poolCapacity(settings), chart, *evaluator_)
    {
        query.ask(*planner.getProblemDefinition());
    }

    unsigned int SearchContext::draftStride() const
    {
        if (!incumbent.hasFinitePath())
        {
            return 1;
        }
        const path::StrideScope full(*evaluator_, 1);
        const std::uint64_t stride = evaluator_->checkWork(incumbent.path()) / LEAST_STATES;
        return static_cast<unsigned int>(std::clamp<std::uint64_t>(stride, 1, MAX_STRIDE));
    }
}  // namespace ompl_mfa::engine
