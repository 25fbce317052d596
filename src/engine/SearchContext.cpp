#include "engine/SearchContext.h"

#include <utility>

namespace ompl_mfa
{
    SearchContext::SearchContext(const ompl::base::Planner &planner, StateChartPtr stateChart,
                                 const ompl::base::OptimizationObjectivePtr &objective, SearchSettings frozen,
                                 std::uint64_t runSeed, SearchProgress &shown)
      : owner(planner)
      , chart(std::move(stateChart))
      , settings(std::move(frozen))
      , seed(runSeed)
      , progress(shown)
      , query(planner.getSpaceInformation()->getStateSpace())
      , incumbent(objective, planner.getSpaceInformation()->getStateSpace(), shown.bestCost)
      , evaluator_(std::make_unique<PathEvaluator>(planner.getSpaceInformation(), objective, settings.threads))
    {
        query.ask(*planner.getProblemDefinition());
    }
}  // namespace ompl_mfa
