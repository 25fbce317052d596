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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_LOCAL_TREES_
#define OMPL_MFA_ENGINE_REFINEMENT_LOCAL_TREES_

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ompl/util/RandomNumbers.h>

#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief RRT-Connect between two states of a path, within the ellipsoid of the states through which a connection
       of a given length can lead. The trees are small and are discarded after each call.

        J. J. Kuffner and S. M. LaValle, RRT-Connect: an efficient approach to single-query path planning, ICRA 2000. */
    class LocalTrees
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        LocalTrees(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed);

        /** \brief Searches for a path from \e from to \e to, both valid, of about \e longest at most in the unit of the
            space's distance, with a budget of \e work units of PathEvaluator::work(). True if \e found is such a path;
            it was checked as PathEvaluator::checkMotion does now, and is not the straight motion. */
        bool connect(const ompl::base::State *from, const ompl::base::State *to, double longest, std::uint64_t work,
                     path::Waypoints &found);

    private:
        enum class Extension : unsigned char
        {
            Trapped,
            Advanced,
            Reached
        };

        struct Tree
        {
            explicit Tree(const ompl::base::StateSpacePtr &space)
              : states(space)
            {
            }

            void reset(const ompl::base::State *root);

            path::Waypoints states;
            std::vector<std::size_t> parents;
        };

        void sample(const ompl::base::State *from, const Eigen::VectorXd &axis, double longest);
        Extension extend(Tree &tree, bool forward, const ompl::base::State *target);
        void join(path::Waypoints &found) const;

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        ompl::RNG rng_;
        double range_;
        Tree fromTree_;
        Tree toTree_;
        path::Waypoints scratch_;
        Eigen::VectorXd point_;
    };
}  // namespace ompl_mfa::engine::refinement

#endif
