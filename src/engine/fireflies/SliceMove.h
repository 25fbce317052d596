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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_MOVE_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_MOVE_

#include <array>
#include <cstddef>
#include <functional>

#include <Eigen/Core>

namespace ompl_mfa::engine::fireflies
{
    /** \brief The move of a firefly by one of the paper's equations, slice by slice. Fireflies are vectors of
        coordinates relative to the one that moves, which is the zero vector. */
    struct SliceMove
    {
        enum class Equation : unsigned char
        {
            Attraction,    ///< eq. (16)
            Mutation,      ///< eq. (6)
            BestMutation,  ///< eqs. (6) and (7)
            Worst          ///< eq. (12)
        };

        /** \brief Coordinates (d) of a firefly, given by its index in the pool, on the slice that moves. */
        using Coordinates = std::function<Eigen::VectorXd(std::size_t)>;

        /** \brief The displacement (d) of a slice. \e phase, between 0 and 1, is the slice's position in the window. */
        Eigen::VectorXd displacement(const Coordinates &coordinates, double phase) const;

        Equation equation{Equation::Attraction};

        // indices in the pool
        std::size_t brighter{0};              ///< the firefly that attracts
        std::array<std::size_t, 4> others{};  ///< n1 to n4, pairwise distinct
        std::size_t best{0};
        std::size_t worst{0};

        double beta{0.0};                ///< attraction, eqs. (4) and (15)
        double step{0.0};                ///< alpha as a distance
        Eigen::VectorXd direction;       ///< epsilon (d), the same on all slices
        std::array<double, 3> lambda{};  ///< the random factors of eqs. (6), (7) and (12), in [0, 1)
        Eigen::VectorXd mask;            ///< 1 for each coordinate that moves, eqs. (8) to (11)
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
