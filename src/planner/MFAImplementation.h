#ifndef OMPL_MFA_PLANNER_MFAIMPLEMENTATION_
#define OMPL_MFA_PLANNER_MFAIMPLEMENTATION_

#include <memory>

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
        what was published. */
    class MFA::Implementation
    {
    public:
        /** \brief Sets a parameter by its member; throws ompl::Exception naming \e planner, the parameter, the value
           and what is accepted. */
        template <typename T>
        void set(const MFA &planner, T SearchSettings::*member, const T &value);

        SearchSettings settings;  ///< as they were set, for the next query
        ompl::base::PlannerAllocator guidePlanner;
        StateChartPtr chart;
        SearchProgress progress;
        std::unique_ptr<Engine> engine;  ///< of the query, from the first solve() on
        SolutionPublisher publisher;
        ompl::RNG rng;  ///< draws the seeds of runs that have none
        mutable SearchLock lock;
    };
}  // namespace ompl_mfa

#endif
