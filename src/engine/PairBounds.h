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

#ifndef OMPL_MFA_ENGINE_PAIR_BOUNDS_
#define OMPL_MFA_ENGINE_PAIR_BOUNDS_

#include <cstddef>
#include <limits>
#include <vector>

#include "path/CostBounds.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief Lower bounds of the cost between the starts and the goals of a query. Each pair is computed once; a
        look-up then takes constant time, however many pairs there are. */
    class PairBounds
    {
    public:
        /** \brief \e bounds must outlive the object. */
        explicit PairBounds(const path::CostBounds &bounds);

        /** \brief Processes the states that were appended to \e starts and \e goals since the last call, at most a few
            thousand pairs per call. If there are fewer states than before, the query is a new one. */
        void update(const path::Waypoints &starts, const path::Waypoints &goals);

        /** \brief Whether a path from start \e i can be better than \e bound (infinity: any). True if that start is not
            processed yet. */
        bool startCanBeat(std::size_t i, double bound) const;

        /** \brief The same for a path to goal \e j. */
        bool goalCanBeat(std::size_t j, double bound) const;

        /** \brief Whether a path of cost \e cost is proven optimal: no pair of \e starts and \e goals has a better
            lower bound, and one has just this. If the cost is better than all bounds, they are wrong and nothing is
            proven. */
        bool isBest(double cost, const path::Waypoints &starts, const path::Waypoints &goals) const;

    private:
        void add(const ompl::base::State *start, std::size_t i, const ompl::base::State *goal, std::size_t j);
        bool better(double a, double b) const;

        const path::CostBounds &bounds_;
        std::vector<double> ofStart_;  ///< for each start, the best bound over all goals
        std::vector<double> ofGoal_;   ///< for each goal, the best bound over all starts
        double best_{std::numeric_limits<double>::quiet_NaN()};
    };
}  // namespace ompl_mfa::engine

#endif
