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

#ifndef OMPL_MFA_ROBOTS_OBSTACLE_TREE_
#define OMPL_MFA_ROBOTS_OBSTACLE_TREE_

#include <array>
#include <cstddef>
#include <vector>

#include <fcl/math/bv/AABB.h>

namespace ompl_mfa::robots
{
    /** \brief A tree of bounding boxes that do not move. */
    class ObstacleTree
    {
    public:
        ObstacleTree() = default;
        explicit ObstacleTree(const std::vector<fcl::AABBd> &boxes);

        /** \brief Call `visit(index)` for the boxes closer than a distance to the surface of a ball, the closer branch
            of the tree first.
            \param limit called for the distance at each box or branch, as it may shrink during the visit.
            \param visit returns whether to stop. */
        template <typename Limit, typename Visit>
        void visitNear(const fcl::Vector3d &centre, double radius, const Limit &limit, const Visit &visit) const
        {
            if (nodes_.empty())
            {
                return;
            }
            // The tree is balanced, so this is deep enough for any memory.
            std::array<Open, 128> open;
            std::size_t size = 0;
            open[size++] = {0, distance(nodes_[0].box, centre) - radius};
            while (size > 0)
            {
                const Open next = open[--size];
                if (next.distance > limit())
                {
                    continue;
                }
                const Node &node = nodes_[next.node];
                if (node.isLeaf())
                {
                    if (visit(node.item))
                    {
                        return;
                    }
                    continue;
                }
                const Open left{node.left, distance(nodes_[node.left].box, centre) - radius};
                const Open right{node.right, distance(nodes_[node.right].box, centre) - radius};
                const bool leftFirst = left.distance <= right.distance;
                open[size++] = leftFirst ? right : left;
                open[size++] = leftFirst ? left : right;
            }
        }

        /** \brief Distance of a point from a box; 0 inside. */
        static double distance(const fcl::AABBd &box, const fcl::Vector3d &point)
        {
            return (box.min_ - point).cwiseMax(point - box.max_).cwiseMax(0.).norm();
        }

    private:
        struct Node
        {
            fcl::AABBd box;
            std::size_t left{0};
            std::size_t right{0};
            std::size_t item{0};

            bool isLeaf() const
            {
                return left == 0;
            }
        };

        struct Open
        {
            std::size_t node;
            double distance;
        };

        std::size_t build(const std::vector<fcl::AABBd> &boxes, std::vector<std::size_t> &order, std::size_t first,
                          std::size_t last);

        // The root is the first; no node has it as a child.
        std::vector<Node> nodes_;
    };
}  // namespace ompl_mfa::robots

#endif
