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

#ifndef OMPL_MFA_PATH_FINE_CHECKS_
#define OMPL_MFA_PATH_FINE_CHECKS_

#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::path
{
    /** \brief Whether motions are checked at the states of a resolution: by OMPL's DiscreteMotionValidator,
        DubinsMotionValidator or ReedsSheppMotionValidator, or one derived from them. Any other motion validator is
        assumed to check motions continuously. */
    OMPL_MFA_EXPORT bool hasDiscreteMotionChecks(const ompl::base::SpaceInformation &si);

    /** \brief Whether all states of a path are valid that OMPL's checkMotion would check with \e factor times the
        space's validSegmentCountFactor: of each motion \e factor times validSegmentCount(), at equal distances. True
        where motions are checked continuously. \e path holds valid motions. */
    OMPL_MFA_EXPORT bool isValidAt(const ompl::base::SpaceInformation &si, const std::vector<ompl::base::State *> &path,
                                   unsigned int factor);
}  // namespace ompl_mfa::path

#endif
