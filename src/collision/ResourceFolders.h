#ifndef OMPL_MFA_COLLISION_RESOURCE_FOLDERS_
#define OMPL_MFA_COLLISION_RESOURCE_FOLDERS_

#include <filesystem>
#include <vector>

namespace ompl_mfa::collision
{
    /** \brief The folders that the environment variable OMPL_MFA_RESOURCE_DIR names, in its order and separated by
        colons: further places where files are sought. */
    std::vector<std::filesystem::path> resourceFolders();
}  // namespace ompl_mfa::collision

#endif
