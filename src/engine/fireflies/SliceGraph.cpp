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

#include "engine/fireflies/SliceGraph.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    SliceGraph::SliceGraph(const SliceFrame &frame, path::PathEvaluator &evaluator)
      : frame_(frame)
      , evaluator_(evaluator)
      , candidates_(frame.slices(), path::Waypoints(frame.chart()->space()))
      , graph_(evaluator)
    {
    }

    void SliceGraph::clear()
    {
        for (auto &candidates : candidates_)
        {
            candidates.clear();
        }
    }

    void SliceGraph::addCandidate(std::size_t k, const ob::State *state)
    {
        candidates_[k].append(state);
    }

    void SliceGraph::addCandidates(const path::Waypoints &path)
    {
        for (std::size_t k = 0; k < candidates_.size(); ++k)
        {
            addCandidate(k, path[k + 1]);
        }
    }

    bool SliceGraph::search(double bound, std::uint64_t work, path::Waypoints &path)
    {
        const ob::State *start = frame_.axis().front();
        const ob::State *goal = frame_.axis().back();
        graph_.clear();
        std::vector<std::size_t> layer{graph_.addVertex(start, true)};
        graph_.setStart(layer.front());
        std::vector<std::size_t> next;
        const auto join = [&]
        {
            for (const std::size_t from : layer)
            {
                for (const std::size_t to : next)
                {
                    if (!graph_.addEdge(from, to, false))
                    {
                        return false;
                    }
                }
            }
            evaluator_.addWork(layer.size() * next.size() / 2);
            layer.swap(next);
            return true;
        };
        for (const auto &candidates : candidates_)
        {
            next.clear();
            for (std::size_t i = 0; i < candidates.size(); ++i)
            {
                if (evaluator_.bounds().canBeat(start, candidates[i], goal, bound))
                {
                    next.push_back(graph_.addVertex(candidates[i], false));
                }
            }
            if (!join())
            {
                return false;
            }
        }
        next.assign(1, graph_.addVertex(goal, true));
        graph_.setGoal(next.front());
        return join() && graph_.search(bound, work, path);
    }
}  // namespace ompl_mfa::engine::fireflies
