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

#ifndef OMPL_MFA_ENGINE_GUIDES_HYPERSPHEROID_CACHE_
#define OMPL_MFA_ENGINE_GUIDES_HYPERSPHEROID_CACHE_

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <ompl/util/ProlateHyperspheroid.h>

namespace ompl_mfa::engine::guides
{
    /** \brief Prolate hyperspheroids by pairs of foci. Making one takes a singular value decomposition, d^3 operations
        in R^d, so those of up to some thousand pairs are kept, in at most a few megabytes. */
    class HyperspheroidCache
    {
    public:
        /** \brief \e dimension >= 2 is the number of coordinates of a focus. */
        explicit HyperspheroidCache(Eigen::Index dimension);

        /** \brief The hyperspheroid with foci \e focus1 and \e focus2, the pair with index \e pair. It is made unless
            the one kept for this index has the same foci. */
        const ompl::ProlateHyperspheroidPtr &of(std::size_t pair, const Eigen::VectorXd &focus1,
                                                const Eigen::VectorXd &focus2);

        /** \brief Number of hyperspheroids kept. */
        std::size_t size() const
        {
            return size_;
        }

        /** \brief Maximum of size(). Up to this many pairs with consecutive indices do not displace each other. */
        std::size_t capacity() const
        {
            return capacity_;
        }

    private:
        struct Slot
        {
            Eigen::VectorXd focus1;
            Eigen::VectorXd focus2;
            ompl::ProlateHyperspheroidPtr hyperspheroid;
        };

        std::size_t capacity_;
        std::size_t size_{0};
        std::vector<Slot> slots_;
    };
}  // namespace ompl_mfa::engine::guides

#endif
