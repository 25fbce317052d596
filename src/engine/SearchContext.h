#ifndef OMPL_MFA_ENGINE_SEARCH_CONTEXT_
#define OMPL_MFA_ENGINE_SEARCH_CONTEXT_

#include <cstdint>
#include <memory>

#include <ompl/base/Planner.h>

#include "engine/Alternatives.h"
#include "engine/Incumbent.h"
#include "engine/Query.h"
#include "engine/SearchProgress.h"
#include "engine/SearchSettings.h"
#include "engine/Streams.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"

namespace ompl_mfa
{
    /** \brief What the search for one query has in common: its parts read it, and only the engine changes it. */
    class SearchContext
    {
    public:
        /** \brief \e planner is the one that searches; it tells which nearest-neighbour structure suits the space.
            \e runSeed != 0 is that of the run. \e planner and \e shown outlive the context. */
        SearchContext(const ompl::base::Planner &planner, StateChartPtr stateChart,
                      const ompl::base::OptimizationObjectivePtr &objective, SearchSettings frozen,
                      std::uint64_t runSeed, SearchProgress &shown);

        /** \brief Whether there are start and goal states. */
        bool hasEnds() const
        {
            return !query.starts().empty() && !query.goals().empty();
        }

        const ompl::base::SpaceInformationPtr &spaceInformation() const
        {
            return evaluator_->spaceInformation();
        }

        const ompl::base::OptimizationObjective &objective() const
        {
            return *evaluator_->objective();
        }

        /** \brief The evaluator of the search, which counts its work. */
        PathEvaluator &evaluator() const
        {
            return *evaluator_;
        }

        const ompl::base::Planner &owner;
        const StateChartPtr chart;
        const SearchSettings settings;
        const std::uint64_t seed;
        SearchProgress &progress;
        Query query;
        Incumbent incumbent;
        Alternatives alternatives;

    private:
        std::unique_ptr<PathEvaluator> evaluator_;
    };
}  // namespace ompl_mfa

#endif
