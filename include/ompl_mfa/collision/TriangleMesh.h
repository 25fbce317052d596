#ifndef OMPL_MFA_COLLISION_TRIANGLE_MESH_
#define OMPL_MFA_COLLISION_TRIANGLE_MESH_

#include <filesystem>
#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/triangle.h>

namespace ompl_mfa::collision
{
    /** \brief The bounding volume hierarchy that every mesh is held in. */
    using MeshGeometry = fcl::BVHModel<fcl::OBBRSS<double>>;

    /** \brief Triangles of a mesh file, all nodes merged. */
    struct TriangleMesh
    {
        std::vector<fcl::Vector3d> vertices;
        std::vector<fcl::Triangle> triangles;

        /** \brief Mean over all vertices that assimp leaves after its post-processing, those of lines and points
            included: what OMPL.app takes as the centre of a robot. */
        fcl::Vector3d vertexMean{fcl::Vector3d::Zero()};
    };

    /** \brief Read a mesh with assimp, by OMPL.app's conventions: every node transform is applied, the root's too,
        and only triangles are kept.
        \throw InputError naming the file, where it is missing or unreadable, has no triangle, or has a coordinate
        that is not finite. */
    TriangleMesh loadMesh(const std::filesystem::path &file);

    /** \brief Build the hierarchy over a mesh, shifted by `offset`.
        \throw std::invalid_argument where the mesh has no triangle. */
    std::shared_ptr<MeshGeometry> makeMeshGeometry(const TriangleMesh &mesh,
                                                   const fcl::Vector3d &offset = fcl::Vector3d::Zero());
}  // namespace ompl_mfa::collision

#endif
