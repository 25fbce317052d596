#ifndef OMPL_MFA_ENGINE_GOAL_DISTANCE_
#define OMPL_MFA_ENGINE_GOAL_DISTANCE_

#include <ompl/base/Goal.h>
#include <ompl/base/State.h>

#include "path/DubinsGuard.h"

namespace ompl_mfa
{
    /** \brief Goal::isSatisfied, with the \e distance to the goal where one is asked for. OMPL's own goals that list
        states measure the distance to each of them; where OMPL cannot compute one, those of \e guard are taken instead.
     */
    bool isSatisfied(const ompl::base::Goal &goal, const DubinsGuard &guard, const ompl::base::State *state,
                     double *distance);
}  // namespace ompl_mfa

#endif
