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

#ifndef OMPL_MFA_ROBOTS_UNKNOWN_NAME_
#define OMPL_MFA_ROBOTS_UNKNOWN_NAME_

#include <string>
#include <vector>

namespace ompl_mfa::robots
{
    /** \brief Message for a name that is not one of `known`: `unknown joint 'elbo'; accepted: lift, turn, elbow`. */
    inline std::string unknownName(const std::string &kind, const std::string &name,
                                   const std::vector<std::string> &known)
    {
        std::string text = "unknown " + kind + " '" + name + "'; ";
        text += known.empty() ? "there is none" : "accepted: ";
        for (std::size_t i = 0; i < known.size(); ++i)
        {
            text += (i == 0 ? "" : ", ") + known[i];
        }
        return text;
    }

    /** \brief The names of links, joints and the like. */
    template <typename Named>
    std::vector<std::string> namesOf(const std::vector<Named> &all)
    {
        std::vector<std::string> names;
        names.reserve(all.size());
        for (const Named &one : all)
        {
            names.push_back(one.name);
        }
        return names;
    }
}  // namespace ompl_mfa::robots

#endif
