#ifndef OMPL_MFA_COLLISION_OCCUPANCY_MAP_
#define OMPL_MFA_COLLISION_OCCUPANCY_MAP_

#include <filesystem>
#include <memory>

#include <fcl/geometry/octree/octree.h>

namespace ompl_mfa::collision
{
    /** \brief Read an OctoMap: .bt (binary) or .ot (full) of an `OcTree`. Cells are obstacles where their occupancy
        reaches the threshold of the map; free and unknown cells are free.
        \throw InputError naming the file and the fault: missing, not an OctoMap, an older or foreign kind of tree,
        truncated, or without any occupied cell. */
    std::shared_ptr<fcl::OcTree<double>> loadOccupancyMap(const std::filesystem::path &file);
}  // namespace ompl_mfa::collision

#endif
