#ifndef OMPL_MFA_COLLISION_MESH_RESOURCE_
#define OMPL_MFA_COLLISION_MESH_RESOURCE_

#include <filesystem>
#include <string>
#include <vector>

namespace ompl_mfa::collision
{
    using Folders = std::vector<std::filesystem::path>;

    /** \brief The file that a mesh's `resource` means: a name, `file://` and a path, or `package://PACKAGE/PATH`.

        A name and a package are sought in `folders`, in their order; a folder may be the package itself.
        \throw InputError listing the places where it was sought, or naming a scheme that is not known. */
    std::filesystem::path findMeshResource(const std::string &resource, const Folders &folders);
}  // namespace ompl_mfa::collision

#endif
