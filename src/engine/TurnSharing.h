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

#ifndef OMPL_MFA_ENGINE_TURN_SHARING_
#define OMPL_MFA_ENGINE_TURN_SHARING_

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/SearchPart.h"

namespace ompl_mfa::engine
{
    /** \brief Distributes turns among parts: a part's share grows with its recent gain per work and never falls below a
       floor. */
    class TurnSharing
    {
    public:
        /** \brief Adds a part; returns its index: 0, 1, ... */
        std::size_t add(const Share &share);

        /** \brief The index of the next part, given the readiness of each: among the ready parts, the one with the
            least work relative to its share; if none is ready, the same among the waiting ones; nothing if all are
            idle. */
        std::optional<std::size_t> next(const std::vector<Readiness> &readiness);

        /** \brief Records a turn of \e part: its \e work, and each part's gain from it, in any common unit. */
        void record(std::size_t part, double work, const std::vector<double> &gains);

        /** \brief The current fraction of \e part in all shares, in (0, 1]. */
        double share(std::size_t part) const;

    private:
        struct Part
        {
            double share;
            double floor;
            double pass{0.0};  ///< work done, each turn's divided by the share at that time
            double gain{0.0};
            double work{0.0};
        };

        std::optional<std::size_t> leastWorked(const std::vector<Readiness> &readiness, Readiness wanted) const;
        void adapt();

        std::vector<Part> parts_;
    };
}  // namespace ompl_mfa::engine

#endif
