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

#ifndef OMPL_MFA_ROBOTS_JOINT_SPACE_
#define OMPL_MFA_ROBOTS_JOINT_SPACE_

#include <cstddef>
#include <string>
#include <vector>

#include <ompl/base/StateSpace.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/robots/RobotModel.h"

namespace ompl_mfa::robots
{
    /** \brief The state space of a group of joints: R^n within their limits or, if a joint is continuous or weights are
        given, a compound of one space per joint. Distances, and so path lengths, are L2 in joint space. */
    class OMPL_MFA_EXPORT JointSpace
    {
    public:
        /** \param group joints, by their indices in the model.
            \param weights one factor above 0 for the distance of each joint; empty: all 1.
            \throw std::invalid_argument if a weight is not above 0 or their number is wrong.
            \throw InputError naming a joint whose limits leave it a single value. */
        JointSpace(const RobotModel &model, const std::vector<std::size_t> &group,
                   const std::vector<double> &weights = {});

        const ompl::base::StateSpacePtr &space() const
        {
            return space_;
        }

        std::size_t dimension() const
        {
            return isContinuous_.size();
        }

        /** \brief Names of the joints, in the order of their values. */
        const std::vector<std::string> &names() const
        {
            return names_;
        }

        bool isContinuous(std::size_t joint) const
        {
            return isContinuous_[joint] != 0;
        }

        /** \brief Values of the joints in a state, radians or metres.
            \param buffer used if the state does not hold them in a row; dimension() values.
            \return the values: in the state itself or in the buffer. */
        const double *values(const ompl::base::State *state, double *buffer) const;

        /** \brief Set a state from values of the joints. Those of continuous joints are normalised to [-pi, pi). */
        void setState(const double *values, ompl::base::State *state) const;

        /** \brief Differences of the joints' values on the motion between two states: for continuous joints the shorter
            way round. */
        void difference(const ompl::base::State *from, const ompl::base::State *to, double *difference) const;

    private:
        ompl::base::StateSpacePtr space_;
        std::vector<std::string> names_;
        std::vector<char> isContinuous_;
        bool isCompound_{false};
    };
}  // namespace ompl_mfa::robots

#endif
