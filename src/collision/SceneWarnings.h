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

#ifndef OMPL_MFA_COLLISION_SCENE_WARNINGS_
#define OMPL_MFA_COLLISION_SCENE_WARNINGS_

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace ompl_mfa::collision
{
    /** \brief Write a warning about a file to OMPL's console, always on one line. */
    void warnOfScene(const std::string &text);

    /** \brief The unset fields of an object, which MoveIt treats as identity. */
    class UnsetFields
    {
    public:
        /** \brief Add a field, unless it has already been added. */
        void add(const std::string &field);

        /** \brief Write one warning for all fields, if there are any, and clear them.
            \param owner the object named in the warning, with its file and line. */
        void warn(const std::string &owner);

    private:
        std::vector<std::string> fields_;
    };

    /** \brief Rotation of a quaternion x y z w of any length. A quaternion of zeros is unset: it yields identity and is
        added to the unset fields.
        \return empty if the length is close to 0 but not 0. */
    std::optional<Eigen::Matrix3d> rotationOf(const Eigen::Vector4d &xyzw, const std::string &field,
                                              UnsetFields &unset);
}  // namespace ompl_mfa::collision

#endif
