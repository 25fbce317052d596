#ifndef OMPL_MFA_COLLISION_CLOSED_MESH_
#define OMPL_MFA_COLLISION_CLOSED_MESH_

#include <memory>
#include <string>
#include <vector>

#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    /** \brief The solid that a closed surface mesh bounds.

        FCL knows a mesh as a surface, so a body wholly inside of it touches nothing. This tells whether a point is
        inside: a ray upward crosses the surface an odd number of times. Const functions are safe to call from several
        threads and allocate nothing. */
    class ClosedMesh
    {
    public:
        /** \param mesh its vertices are used where they are, so it must outlive this
            \param name what an error calls it
            \throw InputError where an edge belongs to an odd number of triangles: the surface has a rim. */
        ClosedMesh(const MeshGeometry &mesh, const std::string &name);
        ~ClosedMesh();
        ClosedMesh(const ClosedMesh &) = delete;
        ClosedMesh &operator=(const ClosedMesh &) = delete;

        /** \brief Whether a point, in the frame of the mesh, is inside. Points on the surface may go either way. */
        bool contains(const fcl::Vector3d &point) const;

        /** \brief A vertex of each connected part of the surface: where none of the surface touches a solid, each part
            is inside of it or outside as a whole, as this vertex is. */
        static std::vector<fcl::Vector3d> partVertices(const MeshGeometry &mesh);

    private:
        struct Index;

        const MeshGeometry &mesh_;
        std::unique_ptr<Index> index_;
    };
}  // namespace ompl_mfa::collision

#endif
