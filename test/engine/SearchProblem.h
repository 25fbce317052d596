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

#ifndef OMPL_MFA_TEST_ENGINE_SEARCH_PROBLEM_
#define OMPL_MFA_TEST_ENGINE_SEARCH_PROBLEM_

/* Everything that a part of a search needs: a problem, the planner that owns the search, and the context. */

#include <cstddef>
#include <cstdint>
#include <memory>

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "engine/SearchContext.h"
#include "engine/SearchPart.h"
#include "ompl_mfa/planner/MFA.h"
#include "path/StateChart.h"

namespace ompl_mfa::test
{
    /** \brief The context of a search for the query of \e pdef. Only parts of the test search. */
    class SearchProblem
    {
    public:
        explicit SearchProblem(const ompl::base::ProblemDefinitionPtr &pdef, std::uint64_t seed = 5,
                               const engine::SearchSettings &settings = {},
                               const ompl::base::OptimizationObjectivePtr &objective = nullptr)
          : si(pdef->getSpaceInformation())
          , owner(si)
          , context(ownerOf(pdef), std::make_shared<const path::StateChart>(si->getStateSpace()),
                    objective ? objective : std::make_shared<ompl::base::PathLengthOptimizationObjective>(si), settings,
                    seed, progress)
          , path(si->getStateSpace())
        {
            inputs.use(pdef);
        }

        /** \brief Reads the starts and goals that the problem definition has now. */
        ompl::base::PlannerStatus::StatusType begin()
        {
            const auto status = context.query.begin(inputs, ompl::base::plannerNonTerminatingCondition(), si);
            while (context.query.poll(inputs))
            {
            }
            return status;
        }

        path::PathEvaluator &evaluator() const
        {
            return context.evaluator();
        }

        const path::Waypoints &starts() const
        {
            return context.query.starts();
        }

        const path::Waypoints &goals() const
        {
            return context.query.goals();
        }

        ompl::base::SpaceInformationPtr si;
        MFA owner;
        ompl::base::PlannerInputStates inputs;
        engine::SearchProgress progress;
        engine::SearchContext context;
        path::Waypoints path;

    private:
        const ompl::base::Planner &ownerOf(const ompl::base::ProblemDefinitionPtr &pdef)
        {
            owner.setProblemDefinition(pdef);
            return owner;
        }
    };
}  // namespace ompl_mfa::test

#endif
