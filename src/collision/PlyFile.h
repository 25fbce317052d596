#ifndef OMPL_MFA_COLLISION_PLY_FILE_
#define OMPL_MFA_COLLISION_PLY_FILE_

#include <filesystem>

namespace ompl_mfa::collision
{
    /** \brief Throws InputError where a PLY file holds triangle strips or ends before the elements that its header
        announces. Files of other kinds pass.

        assimp keeps one triangle of each strip, takes the last face again for those that are missing from a text file,
        and reads on past the end of a binary one. */
    void requireWholePly(const std::filesystem::path &file);
}  // namespace ompl_mfa::collision

#endif
