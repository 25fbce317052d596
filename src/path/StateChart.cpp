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

#include "path/StateChart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <boost/math/constants/constants.hpp>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>
#include <ompl/util/Exception.h>

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        constexpr double PI = boost::math::constants::pi<double>();

        double wrapAngle(double angle)
        {
            angle = std::remainder(angle, 2.0 * PI);
            return angle >= PI ? -PI : angle;
        }

        Eigen::Quaterniond quaternion(const ob::State *state)
        {
            const auto *q = state->as<ob::SO3StateSpace::StateType>();
            return {q->w, q->x, q->y, q->z};
        }

        void setQuaternion(ob::State *state, const Eigen::Quaterniond &value)
        {
            auto *q = state->as<ob::SO3StateSpace::StateType>();
            const Eigen::Quaterniond unit = value.normalized();
            q->x = unit.x();
            q->y = unit.y();
            q->z = unit.z();
            q->w = unit.w();
        }

        /* The unit quaternion exp(v), where v is half a rotation vector. */
        Eigen::Quaterniond exponential(const Eigen::Vector3d &v)
        {
            const double angle = v.norm();
            const double sinc = angle > 1e-9 ? std::sin(angle) / angle : 1.0;
            return {std::cos(angle), sinc * v.x(), sinc * v.y(), sinc * v.z()};
        }

        /* The shorter of the two logarithms of the rotation of q. */
        Eigen::Vector3d logarithm(Eigen::Quaterniond q)
        {
            if (q.w() < 0.0)
            {
                q.coeffs() = -q.coeffs();
            }
            const double sine = q.vec().norm();
            if (sine < 1e-12)
            {
                return q.vec();
            }
            return q.vec() * (std::atan2(sine, q.w()) / sine);
        }

        /* StateSpace::getName is not virtual, and a wrapper (such as a constrained space) stores its name elsewhere. */
        std::string nameOf(const ob::StateSpacePtr &space)
        {
            const auto *wrapper = dynamic_cast<const ob::WrapperStateSpace *>(space.get());
            return wrapper != nullptr ? wrapper->getName() : space->getName();
        }
    }  // namespace

    StateChart::StateChart(ob::StateSpacePtr space)
      : space_(std::move(space))
      , guard_(space_)
    {
        std::vector<std::size_t> chain;
        addLeaves(space_, chain, 1.0);
        std::stable_partition(leaves_.begin(), leaves_.end(),
                              [](const Leaf &leaf) { return leaf.type == LeafType::RealVector; });
        Eigen::Index offset = 0;
        for (auto &leaf : leaves_)
        {
            leaf.offset = offset;
            offset += leaf.dimension;
            (leaf.type == LeafType::RealVector ? positions_ : rotations_) += leaf.dimension;
        }
        rotationReach_.resize(rotations_);
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                rotationReach_.segment(leaf.offset - positions_, leaf.dimension)
                    .setConstant(leaf.scale * (leaf.type == LeafType::SO2 ? PI : 0.5 * PI));
            }
        }
    }

    void StateChart::addLeaves(const ob::StateSpacePtr &space, std::vector<std::size_t> &chain, double scale)
    {
        if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
        {
            for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
            {
                const double weight = compound->getSubspaceWeight(i);
                chain.push_back(i);
                addLeaves(compound->getSubspace(i), chain, weight > 0.0 ? scale * weight : scale);
                chain.pop_back();
            }
            return;
        }
        Leaf leaf{LeafType::RealVector, chain, static_cast<Eigen::Index>(space->getDimension()), 0, scale, nullptr};
        if (const auto *real = dynamic_cast<const ob::RealVectorStateSpace *>(space.get()))
        {
            leaf.bounds = &real->getBounds();
        }
        else if (dynamic_cast<const ob::SO2StateSpace *>(space.get()) != nullptr)
        {
            leaf.type = LeafType::SO2;
        }
        else if (dynamic_cast<const ob::SO3StateSpace *>(space.get()) != nullptr)
        {
            leaf.type = LeafType::SO3;
        }
        else
        {
            throw ompl::Exception("MFA", "cannot plan in the state space '" + nameOf(space) +
                                             "': supported are R^n, SO(2), SO(3), SE(2), SE(3), Dubins, Reeds-Shepp "
                                             "and compounds of these; discrete, time and constrained spaces are not");
        }
        leaves_.push_back(std::move(leaf));
    }

    std::vector<double> StateChart::bounds() const
    {
        std::vector<double> bounds;
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                break;
            }
            bounds.insert(bounds.end(), leaf.bounds->low.begin(), leaf.bounds->low.end());
            bounds.insert(bounds.end(), leaf.bounds->high.begin(), leaf.bounds->high.end());
        }
        return bounds;
    }

    const ob::State *StateChart::substate(const Leaf &leaf, const ob::State *state)
    {
        for (const std::size_t i : leaf.chain)
        {
            state = state->as<ob::CompoundState>()->components[i];
        }
        return state;
    }

    ob::State *StateChart::substate(const Leaf &leaf, ob::State *state)
    {
        for (const std::size_t i : leaf.chain)
        {
            state = state->as<ob::CompoundState>()->components[i];
        }
        return state;
    }

    void StateChart::difference(const ob::State *base, const ob::State *state, Eigen::Ref<Eigen::VectorXd> delta) const
    {
        for (const auto &leaf : leaves_)
        {
            const ob::State *from = substate(leaf, base);
            const ob::State *to = substate(leaf, state);
            switch (leaf.type)
            {
                case LeafType::RealVector:
                {
                    const double *a = from->as<ob::RealVectorStateSpace::StateType>()->values;
                    const double *b = to->as<ob::RealVectorStateSpace::StateType>()->values;
                    for (Eigen::Index i = 0; i < leaf.dimension; ++i)
                    {
                        delta[leaf.offset + i] = leaf.scale * (b[i] - a[i]);
                    }
                    break;
                }
                case LeafType::SO2:
                    delta[leaf.offset] = leaf.scale * wrapAngle(to->as<ob::SO2StateSpace::StateType>()->value -
                                                                from->as<ob::SO2StateSpace::StateType>()->value);
                    break;
                case LeafType::SO3:
                    delta.segment<3>(leaf.offset) =
                        leaf.scale * logarithm(quaternion(from).conjugate() * quaternion(to));
                    break;
            }
        }
    }

    double StateChart::reach(const ob::State *base, const Eigen::Ref<const Eigen::VectorXd> &direction) const
    {
        double reach = std::numeric_limits<double>::infinity();
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                break;
            }
            const double *values = substate(leaf, base)->as<ob::RealVectorStateSpace::StateType>()->values;
            for (Eigen::Index i = 0; i < leaf.dimension; ++i)
            {
                const double step = direction[leaf.offset + i] / leaf.scale;
                const auto k = static_cast<std::size_t>(i);
                if (step > 0.0)
                {
                    reach = std::min(reach, std::max(0.0, leaf.bounds->high[k] - values[i]) / step);
                }
                else if (step < 0.0)
                {
                    reach = std::min(reach, std::min(0.0, leaf.bounds->low[k] - values[i]) / step);
                }
            }
        }
        return reach;
    }

    void StateChart::displace(const ob::State *base, const Eigen::Ref<const Eigen::VectorXd> &delta,
                              ob::State *state) const
    {
        const double shortening = std::min(1.0, reach(base, delta));
        for (const auto &leaf : leaves_)
        {
            const ob::State *from = substate(leaf, base);
            ob::State *to = substate(leaf, state);
            switch (leaf.type)
            {
                case LeafType::RealVector:
                {
                    const double *a = from->as<ob::RealVectorStateSpace::StateType>()->values;
                    double *b = to->as<ob::RealVectorStateSpace::StateType>()->values;
                    for (Eigen::Index i = 0; i < leaf.dimension; ++i)
                    {
                        const auto k = static_cast<std::size_t>(i);
                        // rounding of the shortened step must not leave the bounds either
                        b[i] = std::clamp(a[i] + shortening * delta[leaf.offset + i] / leaf.scale, leaf.bounds->low[k],
                                          leaf.bounds->high[k]);
                    }
                    break;
                }
                case LeafType::SO2:
                    to->as<ob::SO2StateSpace::StateType>()->value =
                        wrapAngle(from->as<ob::SO2StateSpace::StateType>()->value + delta[leaf.offset] / leaf.scale);
                    break;
                case LeafType::SO3:
                {
                    const Eigen::Vector3d v = delta.segment<3>(leaf.offset) / leaf.scale;
                    setQuaternion(to, quaternion(from) * exponential(v));
                    break;
                }
            }
        }
    }

    void StateChart::positions(const ob::State *state, Eigen::Ref<Eigen::VectorXd> values) const
    {
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                break;
            }
            const double *a = substate(leaf, state)->as<ob::RealVectorStateSpace::StateType>()->values;
            for (Eigen::Index i = 0; i < leaf.dimension; ++i)
            {
                values[leaf.offset + i] = leaf.scale * a[i];
            }
        }
    }

    bool StateChart::setPositions(const Eigen::Ref<const Eigen::VectorXd> &values, ob::State *state) const
    {
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                break;
            }
            double *a = substate(leaf, state)->as<ob::RealVectorStateSpace::StateType>()->values;
            for (Eigen::Index i = 0; i < leaf.dimension; ++i)
            {
                a[i] = values[leaf.offset + i] / leaf.scale;
                const auto k = static_cast<std::size_t>(i);
                if (a[i] < leaf.bounds->low[k] || a[i] > leaf.bounds->high[k])
                {
                    return false;
                }
            }
        }
        return true;
    }

    void StateChart::sampleUniform(ompl::RNG &rng, ob::State *state) const
    {
        for (const auto &leaf : leaves_)
        {
            if (leaf.type != LeafType::RealVector)
            {
                break;
            }
            double *a = substate(leaf, state)->as<ob::RealVectorStateSpace::StateType>()->values;
            for (std::size_t i = 0; i < leaf.bounds->low.size(); ++i)
            {
                a[i] = rng.uniformReal(leaf.bounds->low[i], leaf.bounds->high[i]);
            }
        }
        sampleRotations(rng, state);
    }

    void StateChart::sampleRotations(ompl::RNG &rng, ob::State *state) const
    {
        for (const auto &leaf : leaves_)
        {
            ob::State *to = substate(leaf, state);
            if (leaf.type == LeafType::SO2)
            {
                to->as<ob::SO2StateSpace::StateType>()->value = rng.uniformReal(-PI, PI);
            }
            else if (leaf.type == LeafType::SO3)
            {
                double q[4];
                rng.quaternion(q);
                setQuaternion(to, Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
            }
        }
    }
}  // namespace ompl_mfa::path
