#ifndef OMPL_MFA_TEST_ENGINE_SEARCH_PROBLEM_
#define OMPL_MFA_TEST_ENGINE_SEARCH_PROBLEM_

/* What a part of a search needs around it: a problem, the planner that owns the search, and the context. */

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
    /** \brief The context of a search for the query of \e pdef. Nothing is searched but by the parts of the test. */
    class SearchProblem
    {
    public:
        explicit SearchProblem(const ompl::base::ProblemDefinitionPtr &pdef, std::uint64_t seed = 5,
                               const SearchSettings &settings = {},
                               const ompl::base::OptimizationObjectivePtr &objective = nullptr)
          : si(pdef->getSpaceInformation())
          , owner(si)
          , context(ownerOf(pdef), std::make_shared<const StateChart>(si->getStateSpace()),
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

        PathEvaluator &evaluator() const
        {
            return context.evaluator();
        }

        const Waypoints &starts() const
        {
            return context.query.starts();
        }

        const Waypoints &goals() const
        {
            return context.query.goals();
        }

        ompl::base::SpaceInformationPtr si;
        MFA owner;
        ompl::base::PlannerInputStates inputs;
        SearchProgress progress;
        SearchContext context;
        Waypoints path;

    private:
        const ompl::base::Planner &ownerOf(const ompl::base::ProblemDefinitionPtr &pdef)
        {
            owner.setProblemDefinition(pdef);
            return owner;
        }
    };
}  // namespace ompl_mfa::test

#endif
