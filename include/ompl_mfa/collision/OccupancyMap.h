#ifndef OMPL_MFA_COLLISION_OCCUPANCY_MAP_
#define OMPL_MFA_COLLISION_OCCUPANCY_MAP_

#include <filesystem>
#include <memory>
#include <string>

#include <fcl/geometry/octree/octree.h>

namespace ompl_mfa::collision
{
    /** \brief Read an OctoMap: .bt (binary) or .ot (full) of an `OcTree`. Cells are obstacles where their occupancy
        reaches the threshold of the map; free and unknown cells are free.
        \throw InputError naming the file and the fault: missing, not an OctoMap, an older or foreign kind of tree,
        truncated, or without any occupied cell. */
    std::shared_ptr<fcl::OcTree<double>> loadOccupancyMap(const std::filesystem::path &file);

    /** \brief Make an occupancy map of the nodes that an `octomap_msgs/Octomap` message holds in its `data`: the
        content of an OctoMap file without its header.
        \param nodes the bytes of `data`
        \param binary as in the message: whether nodes are only free or occupied, as in .bt, or hold occupancies
        \param resolution edge of the smallest cell
        \return null where no cell is occupied
        \throw std::invalid_argument where the nodes are truncated, broken, or followed by other bytes, or the
        resolution is not positive and finite. */
    std::shared_ptr<fcl::OcTree<double>> makeOccupancyMap(const std::string &nodes, bool binary, double resolution);
}  // namespace ompl_mfa::collision

#endif
