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

#include "robots/JointGoal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    JointGoal::JointGoal(const ob::SpaceInformationPtr &si, JointSpace joints, std::vector<JointBox> boxes)
      : ob::GoalSampleableRegion(si)
      , joints_(std::move(joints))
      , boxes_(std::move(boxes))
    {
        setThreshold(1e-6);
    }

    void JointGoal::sampleGoal(ob::State *state) const
    {
        const JointBox &box = boxes_[samples_ % boxes_.size()];
        std::vector<double> values = box.preferred;
        if (samples_ >= boxes_.size())
        {
            for (std::size_t i = 0; i < values.size(); ++i)
            {
                values[i] = random_.uniformReal(box.lower[i], box.upper[i]);
            }
        }
        ++samples_;
        joints_.setState(values.data(), state);
    }

    unsigned int JointGoal::maxSampleCount() const
    {
        const bool arePoints =
            std::all_of(boxes_.begin(), boxes_.end(), [](const JointBox &box) { return box.isPoint(); });
        return arePoints ? static_cast<unsigned int>(boxes_.size()) : std::numeric_limits<unsigned int>::max();
    }

    double JointGoal::distanceGoal(const ob::State *state) const
    {
        constexpr double TURN = 6.283185307179586;
        std::vector<double> buffer(joints_.dimension());
        const double *values = joints_.values(state, buffer.data());
        double nearest = std::numeric_limits<double>::infinity();
        for (const JointBox &box : boxes_)
        {
            double sum = 0.;
            for (std::size_t i = 0; i < box.lower.size(); ++i)
            {
                const double middle = 0.5 * (box.lower[i] + box.upper[i]);
                const double offset =
                    joints_.isContinuous(i) ? std::remainder(values[i] - middle, TURN) : values[i] - middle;
                const double outside = std::max(0., std::abs(offset) - 0.5 * (box.upper[i] - box.lower[i]));
                sum += outside * outside;
            }
            nearest = std::min(nearest, std::sqrt(sum));
        }
        return nearest;
    }
}  // namespace ompl_mfa::robots
