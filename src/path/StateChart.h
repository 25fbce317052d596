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

#ifndef OMPL_MFA_PATH_STATE_CHART_
#define OMPL_MFA_PATH_STATE_CHART_

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <ompl/util/RandomNumbers.h>

#include "path/DubinsGuard.h"

namespace ompl_mfa::path
{
    /** \brief Local coordinates of a state space: a vector of R^d for the step from one state to another, and back.

        The space is decomposed into its leaves R^n, SO(2) and SO(3), in any nesting of compounds (SE(2), SE(3), Dubins
        and Reeds-Shepp are such compounds). Coordinates are in the order of the leaves, all positions (R^n) before all
        rotations, and in the unit of the space's distance: each leaf is scaled by the product of its subspace weights
        (1 if that is 0). For a single leaf of weight 1 the norm of a coordinate vector is OMPL's distance.

        - R^n: the difference of the values.
        - SO(2): the difference of the angles, in [-pi, pi).
        - SO(3): the logarithm of base^-1 * state as half a rotation vector, with norm in [0, pi/2]. */
    class StateChart
    {
    public:
        /** \brief Throws ompl::Exception naming the subspace that has no such coordinates (discrete, time,
            constrained, ...) and listing what is supported. */
        explicit StateChart(ompl::base::StateSpacePtr space);

        const ompl::base::StateSpacePtr &space() const
        {
            return space_;
        }

        /** \brief Knows which motions of the space OMPL can compute. The three functions below forward to it and accept
            any pair of states. */
        const DubinsGuard &guard() const
        {
            return guard_;
        }

        double distance(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return guard_.distance(from, to);
        }

        unsigned int validSegmentCount(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return guard_.validSegmentCount(from, to);
        }

        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state) const
        {
            guard_.interpolate(from, to, t, state);
        }

        /** \brief d: the number of coordinates. */
        Eigen::Index dimension() const
        {
            return positions_ + rotations_;
        }

        /** \brief The number of position coordinates, which come first. */
        Eigen::Index positionDimension() const
        {
            return positions_;
        }

        Eigen::Index rotationDimension() const
        {
            return rotations_;
        }

        /** \brief The number of leaves of the space. */
        std::size_t leaves() const
        {
            return leaves_.size();
        }

        /** \brief Index of the first coordinate and number of coordinates of leaf \e i. */
        std::pair<Eigen::Index, Eigen::Index> leafRange(std::size_t i) const
        {
            return {leaves_[i].offset, leaves_[i].dimension};
        }

        /** \brief The present bounds of R^n, which all functions respect: low and high of each leaf in turn, in the
            space's own unit. */
        std::vector<double> bounds() const;

        /** \brief Largest absolute value of each rotation coordinate, in the order of the rotations. */
        const Eigen::VectorXd &rotationReach() const
        {
            return rotationReach_;
        }

        /** \brief Coordinates (d) of \e state relative to \e base. */
        void difference(const ompl::base::State *base, const ompl::base::State *state,
                        Eigen::Ref<Eigen::VectorXd> delta) const;

        /** \brief Computes the state at coordinates \e delta (d) from \e base, clipped to the bounds of the space.

            A displacement that leaves the bounds of R^n is shortened by one factor for all position coordinates, so
            that it keeps its direction. \e state may be \e base itself. */
        void displace(const ompl::base::State *base, const Eigen::Ref<const Eigen::VectorXd> &delta,
                      ompl::base::State *state) const;

        /** \brief The factor by which the step \e direction (at least positionDimension() coordinates) can be scaled
            before it leaves the bounds; infinity if there are none. */
        double reach(const ompl::base::State *base, const Eigen::Ref<const Eigen::VectorXd> &direction) const;

        /** \brief The positions of \e state (positionDimension()), scaled by the weights. */
        void positions(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> values) const;

        /** \brief Sets the positions of \e state from scaled \e values; false if they are out of bounds (the state is
            then unspecified). */
        bool setPositions(const Eigen::Ref<const Eigen::VectorXd> &values, ompl::base::State *state) const;

        /** \brief Draws \e state uniformly from the space. */
        void sampleUniform(ompl::RNG &rng, ompl::base::State *state) const;

        /** \brief Draws the rotations of \e state uniformly and keeps its positions. */
        void sampleRotations(ompl::RNG &rng, ompl::base::State *state) const;

    private:
        enum class LeafType
        {
            RealVector,
            SO2,
            SO3
        };

        struct Leaf
        {
            LeafType type;
            std::vector<std::size_t> chain;  ///< indices of the nested compounds, outermost first
            Eigen::Index dimension;
            Eigen::Index offset;
            double scale;
            const ompl::base::RealVectorBounds *bounds;  ///< present bounds of R^n, or null
        };

        void addLeaves(const ompl::base::StateSpacePtr &space, std::vector<std::size_t> &chain, double scale);

        static const ompl::base::State *substate(const Leaf &leaf, const ompl::base::State *state);
        static ompl::base::State *substate(const Leaf &leaf, ompl::base::State *state);

        ompl::base::StateSpacePtr space_;
        DubinsGuard guard_;
        std::vector<Leaf> leaves_;
        Eigen::Index positions_{0};
        Eigen::Index rotations_{0};
        Eigen::VectorXd rotationReach_;
    };

    using StateChartPtr = std::shared_ptr<const StateChart>;
}  // namespace ompl_mfa::path

#endif
