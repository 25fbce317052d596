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

#include "engine/fireflies/SliceObjective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ompl_mfa::engine::fireflies
{
    SliceObjective::SliceObjective(const SliceFrame &frame, const SliceModes *modes, path::PathEvaluator &evaluator,
                                   ValidPathEvent validPath)
      : frame_(frame)
      , modes_(modes)
      , evaluator_(evaluator)
      , validPath_(std::move(validPath))
      , path_(frame.chart()->space())
      , coordinates_(frame.dimension())
      , bound_(std::numeric_limits<double>::infinity())
      , beyondBound_(frame.chart()->space()->getMaximumExtent() * static_cast<double>(frame.slices() + 1))
    {
    }

    bool SliceObjective::setBound(double bound)
    {
        const bool changed = bound != bound_;
        bound_ = bound;
        return changed;
    }

    bool SliceObjective::toOffsets(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> offsets)
    {
        if (modes_ == nullptr)
        {
            offsets = x;
            return true;
        }
        const std::size_t atOnce = modes_->slicesAtOnce();
        for (std::size_t k = 0; k < frame_.slices(); k += atOnce)
        {
            if (k > 0 && evaluator_.stopped())
            {
                return false;
            }
            modes_->toCoordinates(x, k, std::min(atOnce, frame_.slices() - k), offsets);
        }
        return true;
    }

    Brightness SliceObjective::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        if (!toOffsets(x, coordinates_))
        {
            return {};
        }
        frame_.toWaypoints(coordinates_, path_, scratch_);
        const ompl::base::Cost cost = evaluator_.cost(path_);
        if (evaluator_.interrupted())
        {
            return {};
        }
        if (!withinBound(cost.value()))
        {
            return {std::numeric_limits<double>::infinity(), cost.value()};
        }
        // a rival beyond the present bound is worse than every path within it
        const bool lost = rival != nullptr && !withinBound(rival->cost);
        const Brightness brightness = evaluator_.evaluate(path_, cost, lost ? nullptr : rival);
        if (brightness.isFeasible())
        {
            validPath_(path_, brightness);
        }
        return brightness;
    }

    bool SliceObjective::withinBound(double cost) const
    {
        return !std::isfinite(bound_) || evaluator_.isBetter(cost, bound_);
    }

    /* Stored brightness may have been computed under another bound: it is compared as if under the present one. */
    Brightness SliceObjective::underBound(const Brightness &brightness) const
    {
        if (withinBound(brightness.cost))
        {
            return brightness;
        }
        return {beyondBound_ + std::abs(brightness.cost - bound_), brightness.cost};
    }

    bool SliceObjective::isBrighter(const Brightness &a, const Brightness &b) const
    {
        return evaluator_.isBrighter(underBound(a), underBound(b));
    }
}  // namespace ompl_mfa::engine::fireflies
