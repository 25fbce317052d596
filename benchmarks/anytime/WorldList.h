#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_LIST_
#define OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_LIST_

#include <filesystem>
#include <string>
#include <vector>

#include "anytime/World.h"

namespace ompl_mfa::anytime
{
    /** \brief Wall with a gap, double enclosure, dividing walls and random boxes: unit cubes of 2 to 16 dimensions. */
    std::vector<World> boxWorlds();

    /** \brief Unit squares full of discs whose shortest path squeezes through a gap that is easily missed. */
    std::vector<World> circleWorlds();

    /** \brief Length of the shortest path of the circle world of \e seed that keeps \e margin away from its discs. */
    double circleOptimum(std::uint64_t seed, double margin);

    /** \brief Planar arms of 7 and 12 links that have to fold to get past discs. Angles in radians. */
    std::vector<World> armWorlds();

    /** \brief Every config of SE(2) or SE(3) in \e folder, named \e prefix and the file's stem; none where there is no
        such folder. Throws InputError for a config that cannot be read. */
    std::vector<World> configWorlds(const std::filesystem::path &folder, const std::string &prefix);

    /** \brief Those of the five sample problems of OMPL.app that \e folder holds. */
    std::vector<World> omplAppWorlds(const std::filesystem::path &folder);

    /** \brief The whole suite in its order: worlds of this project and, where they are found, the problems of OMPL.app
        (in $OMPL_MFA_OMPLAPP_DIR or ../shared/omplapp beside the project). */
    std::vector<World> allWorlds();

    /** \brief The worlds whose name contains a match of \e pattern. Throws InputError for a pattern that is not a
        regular expression or matches nothing. */
    std::vector<World> selectWorlds(const std::string &pattern);
}  // namespace ompl_mfa::anytime

#endif
