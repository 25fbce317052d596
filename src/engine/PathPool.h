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

#ifndef OMPL_MFA_ENGINE_PATH_POOL_
#define OMPL_MFA_ENGINE_PATH_POOL_

#include <cstddef>
#include <vector>

#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief Tightened paths that cost at most slightly more than the best one and differ from each other: the
        population of the swarm, to which all parts of a search contribute. */
    class PathPool
    {
    public:
        /** \brief A path is kept if its cost is at most this factor times that of the best one. */
        static constexpr double SLACK = 1.15;
        /** \brief Number of slices of a path, at equal fractions of its length. */
        static constexpr unsigned int SLICES = 10;

        struct Member
        {
            path::Waypoints path;
            double cost;
            bool valid;              ///< whether the path was checked at full resolution, not only as a draft
            path::Waypoints slices;  ///< the states on the slices
        };

        /** \brief Keeps up to \e capacity paths; none if that is 0. \e evaluator must outlive the object. */
        PathPool(std::size_t capacity, path::StateChartPtr chart, const path::PathEvaluator &evaluator);

        /** \brief Adds \e path of cost \e cost, if it is no worse than SLACK times \e best. It replaces a member that
           is nearly the same and more expensive, or the most expensive member if the pool is full. */
        void add(const path::Waypoints &path, double cost, bool valid, double best);

        /** \brief Removes the paths that cost more than SLACK times \e best. */
        void prune(double best);

        std::size_t size() const
        {
            return members_.size();
        }

        const Member &operator[](std::size_t i) const
        {
            return members_[i];
        }

        /** \brief Index of the cheapest path; the pool must not be empty. */
        std::size_t brightest() const;

        /** \brief Index of the most expensive path; the pool must not be empty. */
        std::size_t dimmest() const;

    private:
        double meanDistance(const path::Waypoints &a, const path::Waypoints &b) const;

        std::size_t capacity_;
        path::StateChartPtr chart_;
        const path::PathEvaluator &evaluator_;
        std::vector<Member> members_;
    };
}  // namespace ompl_mfa::engine

#endif
