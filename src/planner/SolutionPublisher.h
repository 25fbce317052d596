#ifndef OMPL_MFA_PLANNER_SOLUTION_PUBLISHER_
#define OMPL_MFA_PLANNER_SOLUTION_PUBLISHER_

#include <cstdint>
#include <string>

#include <ompl/base/Planner.h>

#include "engine/SearchContext.h"
#include "planner/PublishingSchedule.h"
#include "planner/SearchLock.h"

namespace ompl_mfa
{
    /** \brief Hands the paths of a search to a problem definition. */
    class SolutionPublisher
    {
    public:
        /** \brief To be called at the beginning of each solve(): what follows goes to \e pdef, which may not have the
            path that was published last. */
        void begin(const ompl::base::ProblemDefinitionPtr &pdef);

        /** \brief Publishes the best path of \e context if there is one that was not published and that is due. The
            intermediate solution callback of \e planner's problem definition is called with \e lock released. */
        void publishIfDue(const SearchContext &context, const ompl::base::Planner &planner, SearchLock &lock);

        /** \brief Publishes the best path, or else the partial one, at the end of a solve(); returns its status. */
        ompl::base::PlannerStatus finish(const SearchContext &context, const ompl::base::Planner &planner,
                                         SearchLock &lock);

    private:
        bool isPublished(const SearchContext &context) const;
        void publish(const SearchContext &context, const ompl::base::Planner &planner, SearchLock &lock);

        ompl::base::ProblemDefinitionPtr pdef_;
        PublishingSchedule schedule_;
        ompl::base::PathPtr published_;
        std::uint64_t improvement_{0};  ///< number of the improvement that was published last
    };
}  // namespace ompl_mfa

#endif
