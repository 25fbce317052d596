#ifndef OMPL_MFA_COLLISION_PLY_HEADER_
#define OMPL_MFA_COLLISION_PLY_HEADER_

#include <cstddef>
#include <filesystem>

namespace ompl_mfa::collision
{
    /** \brief How many triangle strips the header of a PLY file announces; 0 for a file of any other kind. */
    std::size_t announcedTriangleStrips(const std::filesystem::path &file);
}  // namespace ompl_mfa::collision

#endif
