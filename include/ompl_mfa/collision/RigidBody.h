/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_COLLISION_RIGID_BODY_
#define OMPL_MFA_COLLISION_RIGID_BODY_

#include <memory>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/bv/AABB.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief A rigid body of one or several shapes.

        The origin of its frame is the reference point: a state gives its position, and the body rotates about it. */
    class OMPL_MFA_EXPORT RigidBody
    {
    public:
        /** \brief A shape and its pose in the frame of the body. */
        struct Shape
        {
            std::shared_ptr<fcl::CollisionGeometryd> geometry;
            fcl::Transform3d pose{fcl::Transform3d::Identity()};

            /** \brief Number of points and lines in the mesh file besides the triangles. They are ignored in collision
                checks. */
            std::size_t skippedFaces{0};
        };

        /** \throw std::invalid_argument if there is no shape, or a shape without geometry. */
        explicit RigidBody(std::vector<Shape> shapes);

        /** \brief A ball, or in the plane a disc, about the reference point; radius 0 is a point.
            \throw std::invalid_argument if the radius is negative or not finite. */
        static RigidBody sphere(double radius);

        /** \brief A box centred at the reference point, with its sides along the axes of the body.
            \throw std::invalid_argument if a length is not positive and finite. */
        static RigidBody box(double lengthX, double lengthY, double lengthZ);

        const std::vector<Shape> &shapes() const
        {
            return shapes_;
        }

        /** \brief Number of points and lines in the mesh files of all shapes, which are ignored in collision checks. */
        std::size_t skippedFaces() const;

        /** \brief Smallest axis-aligned bounding box of all shapes, in the frame of the body. */
        fcl::AABBd bounds() const;

        /** \brief Radius of a ball about the reference point that contains the body: the smallest one for spheres,
            boxes and meshes, otherwise computed from the bounding boxes of the shapes. */
        double radius() const
        {
            return radius_;
        }

        /** \brief Radius of an upright cylinder about the reference point that contains the body, as tight as radius().
            Bounds the displacement by a rotation about z. */
        double planarRadius() const
        {
            return planarRadius_;
        }

    private:
        std::vector<Shape> shapes_;
        double radius_{0.};
        double planarRadius_{0.};
    };
}  // namespace ompl_mfa::collision

#endif
