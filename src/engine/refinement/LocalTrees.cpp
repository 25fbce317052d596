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

#include "engine/refinement/LocalTrees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "path/TreeStep.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Greatest length of a motion of the trees, as a fraction of the space's extent. */
        constexpr double RANGE = 0.2;
        /* States of a tree whose distances take as long as a unit of work. */
        constexpr std::size_t DISTANCES_A_WORK = 8;

        /* Indices in LocalTrees::scratch_. */
        constexpr std::size_t SAMPLE = 0;
        constexpr std::size_t STEP = 1;
    }  // namespace

    void LocalTrees::Tree::reset(const ob::State *root)
    {
        states.clear();
        states.append(root);
        parents.assign(1, 0);
    }

    LocalTrees::LocalTrees(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , rng_(seed)
      , range_(RANGE * chart_->space()->getMaximumExtent())
      , fromTree_(chart_->space())
      , toTree_(chart_->space())
      , scratch_(chart_->space())
      , point_(chart_->dimension())
    {
        scratch_.resize(2);
    }

    bool LocalTrees::connect(const ob::State *from, const ob::State *to, double longest, std::uint64_t work,
                             path::Waypoints &found)
    {
        const std::uint64_t limit = evaluator_.work() + work;
        fromTree_.reset(from);
        toTree_.reset(to);
        Eigen::VectorXd axis(chart_->dimension());
        chart_->difference(from, to, axis);
        for (bool forward = true; evaluator_.work() < limit && !evaluator_.stopped(); forward = !forward)
        {
            Tree &tree = forward ? fromTree_ : toTree_;
            Tree &other = forward ? toTree_ : fromTree_;
            evaluator_.addWork(1);
            sample(from, axis, longest);
            if (extend(tree, forward, scratch_[SAMPLE]) == Extension::Trapped)
            {
                continue;
            }
            const std::size_t added = tree.states.size() - 1;
            Extension extension = Extension::Advanced;
            while (extension == Extension::Advanced && evaluator_.work() < limit && !evaluator_.interrupted())
            {
                extension = extend(other, !forward, tree.states[added]);
            }
            if (extension == Extension::Reached)
            {
                join(found);
                return true;
            }
        }
        return false;
    }

    /* Uniform in the prolate hyperspheroid with its foci at the ends: in the chart's coordinates a ball that is
       stretched along the axis. It is turned by the reflection that takes the first coordinate's axis to it. */
    void LocalTrees::sample(const ob::State *from, const Eigen::VectorXd &axis, double longest)
    {
        const Eigen::Index d = point_.size();
        for (Eigen::Index j = 0; j < d; ++j)
        {
            point_[j] = rng_.gaussian01();
        }
        const double norm = point_.norm();
        point_ *= norm > 0.0 ? std::pow(rng_.uniform01(), 1.0 / static_cast<double>(d)) / norm : 0.0;
        const double focal = axis.norm();
        const double major = std::max(longest, focal);
        point_ *= 0.5 * std::sqrt(std::max(0.0, major * major - focal * focal));
        if (focal > 0.0)
        {
            point_[0] *= major / std::sqrt(std::max(1e-12 * major * major, major * major - focal * focal));
            Eigen::VectorXd mirror = -axis / focal;
            mirror[0] += 1.0;
            const double squared = mirror.squaredNorm();
            if (squared > 1e-24)
            {
                point_ -= 2.0 * mirror.dot(point_) / squared * mirror;
            }
        }
        point_ += 0.5 * axis;
        chart_->displace(from, point_, scratch_[SAMPLE]);
    }

    /* Motions lead away from the root of the first tree and toward that of the second. */
    LocalTrees::Extension LocalTrees::extend(Tree &tree, bool forward, const ob::State *target)
    {
        const path::TreeStep grow{*chart_, forward};
        std::size_t nearest = 0;
        double least = grow.distance(tree.states[0], target);
        for (std::size_t i = 1; i < tree.states.size(); ++i)
        {
            const double d = grow.distance(tree.states[i], target);
            if (d < least)
            {
                least = d;
                nearest = i;
            }
        }
        evaluator_.addWork(1 + tree.states.size() / DISTANCES_A_WORK);
        evaluator_.addDistances(tree.states.size());
        ob::State *step = scratch_[STEP];
        const ob::State *near = tree.states[nearest];
        const bool reaches = grow.toward(near, target, least, range_, step);
        // a curve that leaves the bounds may end where it began, again and again
        if ((!reaches && grow.distance(step, target) >= least) || !grow.check(evaluator_, near, step))
        {
            return Extension::Trapped;
        }
        tree.states.append(step);
        tree.parents.push_back(nearest);
        return reaches ? Extension::Reached : Extension::Advanced;
    }

    void LocalTrees::join(path::Waypoints &found) const
    {
        found.clear();
        for (std::size_t i = fromTree_.states.size() - 1; i != 0; i = fromTree_.parents[i])
        {
            found.append(fromTree_.states[i]);
        }
        found.append(fromTree_.states[0]);
        found.reverse();
        // both trees contain the state at which they met
        for (std::size_t i = toTree_.states.size() - 1; i != 0;)
        {
            i = toTree_.parents[i];
            found.append(toTree_.states[i]);
        }
    }
}  // namespace ompl_mfa::engine::refinement
