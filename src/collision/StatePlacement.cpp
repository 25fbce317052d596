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

#include "ompl_mfa/collision/StatePlacement.h"

#include <cmath>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        template <typename Space>
        bool is(const ob::StateSpacePtr &space)
        {
            return dynamic_cast<const Space *>(space.get()) != nullptr;
        }

        Eigen::Quaterniond orientation(const ob::SE3StateSpace::StateType *state)
        {
            const auto &q = state->rotation();
            return {q.w, q.x, q.y, q.z};
        }
    }  // namespace

    StatePlacement::StatePlacement(const ob::StateSpacePtr &space)
    {
        std::vector<unsigned int> path;
        collect(space, path);
    }

    void StatePlacement::collect(const ob::StateSpacePtr &space, std::vector<unsigned int> &path)
    {
        if (is<ob::SE3StateSpace>(space))
        {
            components_.push_back({Kind::SE3, path});
        }
        else if (is<ob::SE2StateSpace>(space))
        {
            components_.push_back({Kind::SE2, path});
            straight_ = straight_ && !is<ob::DubinsStateSpace>(space) && !is<ob::ReedsSheppStateSpace>(space);
        }
        else if (is<ob::RealVectorStateSpace>(space) && (space->getDimension() == 2 || space->getDimension() == 3))
        {
            components_.push_back({space->getDimension() == 2 ? Kind::R2 : Kind::R3, path});
        }
        else if (space->isCompound() && space->as<ob::CompoundStateSpace>()->getSubspaceCount() > 0)
        {
            const auto *compound = space->as<ob::CompoundStateSpace>();
            for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
            {
                path.push_back(i);
                collect(compound->getSubspace(i), path);
                path.pop_back();
            }
        }
        else
        {
            throw InputError("state space '" + space->getName() + "' of dimension " +
                             std::to_string(space->getDimension()) +
                             " does not place a rigid body; accepted are R^2, R^3, SE(2), SE(3) and compounds of them");
        }
    }

    const ob::State *StatePlacement::descend(const ob::State *state, const Component &component)
    {
        for (const unsigned int index : component.path)
        {
            state = static_cast<const ob::CompoundState *>(state)->components[index];
        }
        return state;
    }

    void StatePlacement::place(const ob::State *state, std::size_t body, fcl::Transform3d &pose) const
    {
        const Component &component = components_[body];
        state = descend(state, component);
        pose.setIdentity();
        switch (component.kind)
        {
            case Kind::R2:
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                pose.translation() << values[0], values[1], 0.;
                break;
            }
            case Kind::R3:
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                pose.translation() << values[0], values[1], values[2];
                break;
            }
            case Kind::SE2:
            {
                const auto *se2 = state->as<ob::SE2StateSpace::StateType>();
                pose.translation() << se2->getX(), se2->getY(), 0.;
                pose.linear() = Eigen::AngleAxisd(se2->getYaw(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
                break;
            }
            case Kind::SE3:
            {
                const auto *se3 = state->as<ob::SE3StateSpace::StateType>();
                pose.translation() << se3->getX(), se3->getY(), se3->getZ();
                pose.linear() = orientation(se3).toRotationMatrix();
                break;
            }
        }
    }

    BodyMotion StatePlacement::motion(const ob::State *from, const ob::State *to, std::size_t body) const
    {
        fcl::Transform3d start;
        fcl::Transform3d end;
        place(from, body, start);
        place(to, body, end);
        BodyMotion motion;
        motion.start = start.translation();
        motion.displacement = end.translation() - start.translation();
        motion.rotation = start.linear();

        const Component &component = components_[body];
        from = descend(from, component);
        to = descend(to, component);
        if (component.kind == Kind::SE2)
        {
            const double turn =
                to->as<ob::SE2StateSpace::StateType>()->getYaw() - from->as<ob::SE2StateSpace::StateType>()->getYaw();
            motion.angle = std::abs(turn) <= M_PI ? turn : turn - std::copysign(2. * M_PI, turn);
        }
        else if (component.kind == Kind::SE3)
        {
            const Eigen::Quaterniond turn = orientation(from->as<ob::SE3StateSpace::StateType>()).conjugate() *
                                            orientation(to->as<ob::SE3StateSpace::StateType>());
            const double sine = turn.vec().norm();
            if (sine > 0.)
            {
                // The shorter of the two rotations, as in SO3StateSpace.
                motion.axis = turn.vec() / (turn.w() < 0. ? -sine : sine);
                motion.angle = 2. * std::atan2(sine, std::abs(turn.w()));
            }
        }
        return motion;
    }
}  // namespace ompl_mfa::collision
