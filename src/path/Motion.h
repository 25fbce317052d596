#ifndef OMPL_MFA_PATH_MOTION_
#define OMPL_MFA_PATH_MOTION_

#include <ompl/base/State.h>

namespace ompl_mfa
{
    /** \brief A motion between two states that belong to somebody else. */
    struct Motion
    {
        const ompl::base::State *from;
        const ompl::base::State *to;
    };
}  // namespace ompl_mfa

#endif
