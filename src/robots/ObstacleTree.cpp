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

#include "robots/ObstacleTree.h"

#include <algorithm>
#include <numeric>

namespace ompl_mfa::robots
{
    ObstacleTree::ObstacleTree(const std::vector<fcl::AABBd> &boxes)
    {
        std::vector<std::size_t> order(boxes.size());
        std::iota(order.begin(), order.end(), 0);
        if (!boxes.empty())
        {
            build(boxes, order, 0, boxes.size());
        }
    }

    std::size_t ObstacleTree::build(const std::vector<fcl::AABBd> &boxes, std::vector<std::size_t> &order,
                                    std::size_t first, std::size_t last)
    {
        const std::size_t index = nodes_.size();
        nodes_.emplace_back();
        fcl::AABBd box = boxes[order[first]];
        for (std::size_t i = first + 1; i < last; ++i)
        {
            box += boxes[order[i]];
        }
        nodes_[index].box = box;
        if (last - first == 1)
        {
            nodes_[index].item = order[first];
            return index;
        }
        int axis = 0;
        (box.max_ - box.min_).maxCoeff(&axis);
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&order](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(
            at(first), at(middle), at(last),
            [&boxes, axis](std::size_t a, std::size_t b)
            { return boxes[a].min_[axis] + boxes[a].max_[axis] < boxes[b].min_[axis] + boxes[b].max_[axis]; });
        const std::size_t left = build(boxes, order, first, middle);
        const std::size_t right = build(boxes, order, middle, last);
        nodes_[index].left = left;
        nodes_[index].right = right;
        return index;
    }
}  // namespace ompl_mfa::robots
