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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_OBJECTIVE_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_OBJECTIVE_

#include <functional>

#include "engine/fireflies/SliceFrame.h"
#include "engine/fireflies/SliceModes.h"
#include "ompl_mfa/optimizer/ObjectiveFunction.h"
#include "path/PathEvaluator.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief The objective of the fireflies: the brightness of the path at the coordinates of a SliceFrame, or at the
        amplitudes of its modes. Frame, modes and evaluator must outlive it. */
    class SliceObjective : public ObjectiveFunction
    {
    public:
        /** \brief Called with each valid path found by an evaluation. */
        using ValidPathEvent = std::function<void(const path::Waypoints &path, const Brightness &brightness)>;

        /** \brief \e modes may be null. */
        SliceObjective(const SliceFrame &frame, const SliceModes *modes, path::PathEvaluator &evaluator,
                       ValidPathEvent validPath);

        /** \brief Sets the cost that a path has to be better than (infinity: no bound). A path that is not is not
            checked for collision, and is dimmer than any path within the bound, the more so the farther its cost is
            beyond it. Stored brightness is compared as if it had been computed under the present bound; an unchecked
            path that is now within the bound is the dimmest of these. Returns whether the order of any brightness may
            have changed. */
        bool setBound(double bound);

        double bound() const
        {
            return bound_;
        }

        /** \brief The frame's coordinates \e offsets (d) for \e x (d): equal to \e x, or computed from it by the modes.
            False if interrupted. */
        bool toOffsets(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> offsets);

        /** \brief The violation is infinite for a path beyond the bound, which is not checked. */
        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;
        bool isBrighter(const Brightness &a, const Brightness &b) const override;

    private:
        bool withinBound(double cost) const;
        Brightness underBound(const Brightness &brightness) const;

        const SliceFrame &frame_;
        const SliceModes *modes_;
        path::PathEvaluator &evaluator_;
        ValidPathEvent validPath_;
        path::Waypoints path_;
        Eigen::VectorXd coordinates_;
        Eigen::VectorXd scratch_;
        double bound_;
        double beyondBound_;  ///< exceeds the violation of any path within the bound
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
