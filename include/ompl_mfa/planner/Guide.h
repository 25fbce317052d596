#ifndef OMPL_MFA_PLANNER_GUIDE_
#define OMPL_MFA_PLANNER_GUIDE_

#include <cstdint>

#include "ompl_mfa/path/Waypoints.h"
#include "ompl_mfa/planner/Query.h"
#include "ompl_mfa/planner/SearchGraph.h"

namespace ompl_mfa
{
    /** \brief Finds valid paths in ways that slices cannot express, in turns with the swarm. */
    class Guide
    {
    public:
        virtual ~Guide() = default;

        /** \brief Goes on for about \e work units of PathEvaluator::work(). Returns true as soon as it has a path, then
            in \e path, from one of the query's starts to one of its goals with all motions checked; the next call goes
            on from there. \e bound is the cost that a path should beat in the end (infinite before there is one). */
        virtual bool advance(const Query &query, double bound, std::uint64_t work, Waypoints &path) = 0;

        /** \brief Appends to \e graph the states that the guide has, none of which is known to be invalid, with the
            motions between them that it found valid; nothing where it cannot answer for either. */
        virtual void explain(SearchGraph &graph) const;
    };
}  // namespace ompl_mfa

#endif
