#ifndef OMPL_MFA_MICRO_COLLISION_WORLDS_
#define OMPL_MFA_MICRO_COLLISION_WORLDS_

#include <memory>
#include <string>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/collision/FclStateValidityChecker.h"

namespace ompl_mfa::collision
{
    /** \brief A world of one kind with a robot and its state space. */
    struct World
    {
        std::string name;
        std::shared_ptr<ompl::base::SpaceInformation> si;
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<FclStateValidityChecker> checker;
    };

    /** \brief Worlds of each kind: the paper's scene; primitives; meshes; an occupancy map; and, where `omplAppFolder`
        is there, OMPL.app's problems. */
    std::vector<World> makeWorlds(const std::string &omplAppFolder);
}  // namespace ompl_mfa::collision

#endif
