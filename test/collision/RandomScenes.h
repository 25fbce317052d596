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

#ifndef OMPL_MFA_TEST_COLLISION_RANDOM_SCENES_
#define OMPL_MFA_TEST_COLLISION_RANDOM_SCENES_

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <fcl/common/types.h>
#include <octomap/octomap.h>

#include "ompl_mfa/collision/OccupancyMap.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/Scene.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    /** \brief Random numbers of a test, the same in every run. */
    class Random
    {
    public:
        explicit Random(unsigned int seed)
          : generator_(seed)
        {
        }

        double uniform(double low, double high)
        {
            return std::uniform_real_distribution<double>(low, high)(generator_);
        }

        fcl::Vector3d point(double extent)
        {
            return {uniform(-extent, extent), uniform(-extent, extent), uniform(-extent, extent)};
        }

        Eigen::Quaterniond orientation()
        {
            std::normal_distribution<double> normal;
            return Eigen::Quaterniond(normal(generator_), normal(generator_), normal(generator_), normal(generator_))
                .normalized();
        }

        fcl::Transform3d pose(double extent)
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.linear() = orientation().toRotationMatrix();
            pose.translation() = point(extent);
            return pose;
        }

        /** \brief A primitive of a kind, of size around 1. */
        std::shared_ptr<fcl::CollisionGeometryd> primitive(const char *kind)
        {
            const PrimitiveKind &found = *findPrimitiveKind(kind);
            std::vector<double> dimensions;
            for (std::size_t i = 0; i < found.dimensions.size(); ++i)
            {
                dimensions.push_back(uniform(0.1, 1.5));
            }
            return makePrimitive(found, dimensions);
        }

    private:
        std::mt19937_64 generator_;
    };

    /** \brief The surface of a box as a closed mesh of 12 triangles. */
    inline TriangleMesh boxMesh(const fcl::Vector3d &side)
    {
        TriangleMesh mesh;
        for (int corner = 0; corner < 8; ++corner)
        {
            mesh.vertices.emplace_back(((corner & 1) != 0 ? 0.5 : -0.5) * side[0],
                                       ((corner & 2) != 0 ? 0.5 : -0.5) * side[1],
                                       ((corner & 4) != 0 ? 0.5 : -0.5) * side[2]);
        }
        mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return mesh;
    }

    /** \brief A map whose occupied cells are given by their lowest corner, in cells. */
    inline std::shared_ptr<fcl::OcTree<double>> occupancyMap(const std::vector<Eigen::Vector3i> &cells,
                                                             double resolution)
    {
        auto tree = std::make_shared<octomap::OcTree>(resolution);
        for (const Eigen::Vector3i &cell : cells)
        {
            const fcl::Vector3d centre = resolution * (cell.cast<double>() + fcl::Vector3d::Constant(0.5));
            tree->updateNode(centre.x(), centre.y(), centre.z(), true);
        }
        tree->prune();
        auto map = std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
        map->computeLocalAABB();
        return map;
    }
}  // namespace ompl_mfa::collision

#endif
