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

#include "engine/refinement/VertexMoves.h"

#include <algorithm>
#include <cstddef>

#include "engine/refinement/CoordinateChoice.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Distance that a vertex keeps from where it would be blocked, as a fraction of the distance between two states
           of a motion check. */
        constexpr double MARGIN = 0.125;
        /* Number of moves after a blocked one for which a vertex has to keep the margin; elsewhere the margin is not
           checked. */
        constexpr unsigned int CAUTION = 2;
        /* Number of random steps that may be evaluated for cost until one is checked for validity. */
        constexpr unsigned int COST_TRIES = 4;

        /* Indices in VertexMoves::scratch_. */
        constexpr std::size_t MOVED = 0;
        constexpr std::size_t CHORD = 1;
        constexpr std::size_t BEYOND = 2;
    }  // namespace

    VertexMoves::VertexMoves(WorkingPath &path, ompl::RNG &rng)
      : path_(path)
      , chart_(path.chart())
      , evaluator_(path.evaluator())
      , rng_(rng)
      , scratch_(chart_->space())
      , delta_(chart_->dimension())
      , beyondDelta_(chart_->dimension())
    {
        scratch_.resize(3);
    }

    /* Whether moving the vertex to \e state is better; the new motions cost \e before and \e after. */
    bool VertexMoves::improves(std::size_t i, const ob::State *state, ob::Cost &before, ob::Cost &after)
    {
        const auto &objective = evaluator_.objective();
        return evaluator_.motionCost(path_[i - 1], state, before) &&
               evaluator_.motionCost(state, path_[i + 1], after) &&
               objective->isCostBetterThan(objective->combineCosts(before, after), path_.cornerCost(i));
    }

    bool VertexMoves::moveVertex(std::size_t i, const ob::State *state, ob::Cost before, ob::Cost after)
    {
        unsigned int &caution = path_.step(i).caution;
        if (!evaluator_.checkMotions({{path_[i - 1], state}, {state, path_[i + 1]}}))
        {
            caution = CAUTION;
            return false;
        }
        if ((caution > 0 && !hasMargin(i, state)) ||
            !evaluator_.checkBetween({{path_[i - 1], state}, {state, path_[i + 1]}}))
        {
            return false;
        }
        caution -= caution > 0 ? 1 : 0;
        path_.move(i, state, before, after);
        return true;
    }

    /* Whether the vertex could move a little beyond its new state, so that the path does not touch an obstacle. Motions
       to the state itself are checked at twice the resolution, those beyond it at the normal one. */
    bool VertexMoves::hasMargin(std::size_t i, const ob::State *state)
    {
        const unsigned int segments = evaluator_.checkedSegments(path_[i - 1], state);
        const double margin = MARGIN * chart_->distance(path_[i - 1], state) / segments;
        const double step = chart_->distance(path_[i], state);
        if (step <= 0.0)
        {
            return false;
        }
        chart_->difference(path_[i], state, beyondDelta_);
        beyondDelta_ *= 1.0 + margin / step;
        chart_->displace(path_[i], beyondDelta_, scratch_[BEYOND]);
        return evaluator_.checkMotions({{path_[i - 1], scratch_[BEYOND]}, {scratch_[BEYOND], path_[i + 1]}});
    }

    bool VertexMoves::replaceVertex(std::size_t i, const ob::State *state)
    {
        ob::Cost before;
        ob::Cost after;
        evaluator_.addWork(2);
        return improves(i, state, before, after) && moveVertex(i, state, before, after);
    }

    bool VertexMoves::pull(std::size_t i)
    {
        const auto &space = chart_->space();
        const double before = chart_->distance(path_[i - 1], path_[i]);
        const double after = chart_->distance(path_[i], path_[i + 1]);
        if (before + after <= 0.0)
        {
            return false;
        }
        chart_->interpolate(path_[i - 1], path_[i + 1], before / (before + after), scratch_[CHORD]);
        space->enforceBounds(scratch_[CHORD]);
        if (path_.step(i).pull * chart_->distance(path_[i], scratch_[CHORD]) < path_.smallestStep())
        {
            path_.step(i).pull = std::min(1.0, 8.0 * path_.step(i).pull);
            return false;
        }
        chart_->interpolate(path_[i], scratch_[CHORD], path_.step(i).pull, scratch_[MOVED]);
        space->enforceBounds(scratch_[MOVED]);
        const bool success = replaceVertex(i, scratch_[MOVED]);
        path_.step(i).pull = success ? std::min(1.0, 1.6 * path_.step(i).pull) : 0.4 * path_.step(i).pull;
        return success;
    }

    /* Restricts the pull toward the chord to one subspace, to some coordinates, or to all directions but a random one.
       The obstacle is often a surface along which the vertex can slide once the normal direction is left out, and
       unneeded rotation unwinds while the position stays. */
    void VertexMoves::selectPart(VertexStep &step)
    {
        step.normal.setZero(chart_->dimension());
        if (selectCoordinates(*chart_, rng_, step.mask))
        {
            return;
        }
        for (Eigen::Index j = 0; j < step.normal.size(); ++j)
        {
            step.normal[j] = rng_.gaussian01();
        }
        step.normal.normalize();
    }

    bool VertexMoves::pullPart(std::size_t i)
    {
        const auto &space = chart_->space();
        const double before = chart_->distance(path_[i - 1], path_[i]);
        const double after = chart_->distance(path_[i], path_[i + 1]);
        if (before + after <= 0.0 || chart_->dimension() < 2)
        {
            return false;
        }
        VertexStep &step = path_.step(i);
        if (!step.partWorked)
        {
            selectPart(step);
        }
        chart_->interpolate(path_[i - 1], path_[i + 1], before / (before + after), scratch_[CHORD]);
        space->enforceBounds(scratch_[CHORD]);
        chart_->difference(path_[i], scratch_[CHORD], delta_);
        delta_ = delta_.cwiseProduct(step.mask);
        delta_ -= delta_.dot(step.normal) * step.normal;
        delta_ *= rng_.uniform01() < 0.3 ? 1.0 : step.partPull;
        if (delta_.norm() < path_.smallestStep())
        {
            step.partWorked = false;
            step.partPull = std::min(1.0, 4.0 * step.partPull);
            return false;
        }
        chart_->displace(path_[i], delta_, scratch_[MOVED]);
        step.partWorked = replaceVertex(i, scratch_[MOVED]);
        step.partPull = step.partWorked ? std::min(1.0, 1.5 * step.partPull) : std::max(1e-4, 0.8 * step.partPull);
        return step.partWorked;
    }

    bool VertexMoves::perturb(std::size_t i)
    {
        VertexSearch &search = path_.step(i).search;
        if (search.sigma() < path_.smallestStep())
        {
            search = VertexSearch(chart_->dimension(), 1e3 * path_.smallestStep());
        }
        for (unsigned int k = 0; k < COST_TRIES && !evaluator_.interrupted(); ++k)
        {
            ob::Cost before;
            ob::Cost after;
            search.draw(rng_, delta_);
            chart_->displace(path_[i], delta_, scratch_[MOVED]);
            evaluator_.addWork(1);
            if (!improves(i, scratch_[MOVED], before, after))
            {
                search.failed();
            }
            else if (moveVertex(i, scratch_[MOVED], before, after))
            {
                search.succeeded();
                return true;
            }
            else
            {
                search.violated();
                return false;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::refinement
