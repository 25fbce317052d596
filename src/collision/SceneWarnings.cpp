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

#include "collision/SceneWarnings.h"

#include <algorithm>

#include <ompl/util/Console.h>

namespace ompl_mfa::collision
{
    void warnOfScene(const std::string &text)
    {
        std::string line = text;
        // Names come from the file and may contain terminal control characters.
        std::replace_if(
            line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
        OMPL_WARN("%s", line.c_str());
    }

    void UnsetFields::add(const std::string &field)
    {
        if (std::find(fields_.begin(), fields_.end(), field) == fields_.end())
        {
            fields_.push_back(field);
        }
    }

    void UnsetFields::warn(const std::string &owner)
    {
        if (fields_.empty())
        {
            return;
        }
        std::string list;
        for (const std::string &field : fields_)
        {
            list += (list.empty() ? "" : ", ") + field;
        }
        fields_.clear();
        warnOfScene(owner + ": not set and taken as identity, as MoveIt does: " + list);
    }

    std::optional<Eigen::Matrix3d> rotationOf(const Eigen::Vector4d &xyzw, const std::string &field, UnsetFields &unset)
    {
        if (xyzw.isZero(0.))
        {
            unset.add(field + " (0 0 0 0)");
            return Eigen::Matrix3d::Identity();
        }
        // A length close to 1 is normal, as files have few digits; a length close to 0 gives no direction.
        const double length = xyzw.stableNorm();
        if (length < 1e-6)
        {
            return std::nullopt;
        }
        return Eigen::Quaterniond(xyzw / length).toRotationMatrix();
    }
}  // namespace ompl_mfa::collision
