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

#ifndef OMPL_MFA_BENCHMARK_NEARBY_STATE_
#define OMPL_MFA_BENCHMARK_NEARBY_STATE_

#include <optional>

#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::benchmark
{
    /** \brief A valid pose near an invalid one. */
    struct NearbyState
    {
        /** \brief Its coordinates have few digits, and it may be farther than `distance` by a fiftieth. */
        ConfigPose pose;
        /** \brief The least distance at which a valid position was found, world units. */
        double distance{0.0};
    };

    /** \brief The nearest valid state of the same orientation as \e pose, which is invalid, up to the distance \e
        farthest (above 0, world units); empty if none is found.

        Positions are tried on circles or spheres of growing radius, in 64 or 206 directions; in the best direction the
        distance is refined by bisection. \e si is the space information, set up, of a problem of kind \e kind. */
    OMPL_MFA_EXPORT std::optional<NearbyState> findNearbyState(const ompl::base::SpaceInformation &si,
                                                               StateSpaceKind kind, const ConfigPose &pose,
                                                               double farthest);
}  // namespace ompl_mfa::benchmark

#endif
