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

#ifndef OMPL_MFA_MAPS_DISTANCE_TRANSFORM_
#define OMPL_MFA_MAPS_DISTANCE_TRANSFORM_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ompl_mfa::maps
{
    /** \brief The exact signed Euclidean distance transform of \e occupied, \e height rows of \e width cells, each 0 or
        1: for a free cell the distance from its centre to the nearest centre of an occupied one, in cells; for an
        occupied cell minus the distance to the nearest free one. Without any cell of the other kind the distance is
        width + height. The time is linear in the number of cells.

        Source: A. Meijster, J. Roerdink and W. Hesselink, A General Algorithm for Computing Distance Transforms in
        Linear Time, 2000; P. Felzenszwalb and D. Huttenlocher, Distance Transforms of Sampled Functions, 2012. */
    std::vector<float> signedDistances(const std::vector<std::uint8_t> &occupied, std::size_t width,
                                       std::size_t height);
}  // namespace ompl_mfa::maps

#endif
