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

#include "benchmark/ProblemSpace.h"

#include <numeric>
#include <stdexcept>
#include <vector>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateProjections.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        template <typename Space>
        ob::StateSpacePtr bounded(const std::shared_ptr<Space> &space, const ob::RealVectorBounds &bounds)
        {
            space->setBounds(bounds);
            return space;
        }

        /* R^n with a projection to all of its coordinates. OMPL's defaults are an identity that aborts in 1.5.2 (it
           confuses the size in bytes with the dimension) and, above two dimensions, random directions. */
        class PositionSpace : public ob::RealVectorStateSpace
        {
        public:
            using RealVectorStateSpace::RealVectorStateSpace;

            void registerProjections() override
            {
                std::vector<unsigned int> components(getDimension());
                std::iota(components.begin(), components.end(), 0U);
                registerDefaultProjection(
                    std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(this, components));
            }
        };
    }  // namespace

    unsigned int positionDimension(StateSpaceKind kind)
    {
        return kind == StateSpaceKind::R3 || kind == StateSpaceKind::SE3 ? 3 : 2;
    }

    std::string spaceName(StateSpaceKind kind)
    {
        static const char *const NAMES[] = {"R^2",         "R^3",   "SE(2)", "SE(3)", "Dubins", "symmetric Dubins",
                                            "Reeds-Shepp", "joints"};
        return NAMES[static_cast<std::size_t>(kind)];
    }

    ob::StateSpacePtr makeStateSpace(const ProblemConfig &problem, const ob::RealVectorBounds &bounds)
    {
        const double radius = problem.turningRadius;
        ob::StateSpacePtr space;
        switch (problem.space)
        {
            case StateSpaceKind::R2:
            case StateSpaceKind::R3:
                return bounded(std::make_shared<PositionSpace>(positionDimension(problem.space)), bounds);
            case StateSpaceKind::Dubins:
                return bounded(std::make_shared<ob::DubinsStateSpace>(radius), bounds);
            case StateSpaceKind::DubinsSymmetric:
                return bounded(std::make_shared<ob::DubinsStateSpace>(radius, true), bounds);
            case StateSpaceKind::ReedsShepp:
                return bounded(std::make_shared<ob::ReedsSheppStateSpace>(radius), bounds);
            case StateSpaceKind::SE2:
                space = bounded(std::make_shared<ob::SE2StateSpace>(), bounds);
                break;
            case StateSpaceKind::SE3:
                space = bounded(std::make_shared<ob::SE3StateSpace>(), bounds);
                break;
            case StateSpaceKind::Joints:
                throw std::invalid_argument("makeStateSpace: an arm makes its own space");
        }
        if (problem.rotationWeight)
        {
            space->as<ob::CompoundStateSpace>()->setSubspaceWeight(1, *problem.rotationWeight);
        }
        return space;
    }

    ob::ScopedState<> makeState(const ob::StateSpacePtr &space, StateSpaceKind kind, const ConfigPose &pose)
    {
        ob::ScopedState<> state(space);
        const double position[] = {pose.x, pose.y, pose.z};
        for (unsigned int i = 0; i < positionDimension(kind); ++i)
        {
            *space->getValueAddressAtIndex(state.get(), i) = position[i];
        }
        if (kind == StateSpaceKind::SE3)
        {
            state->as<ob::SE3StateSpace::StateType>()->rotation().setAxisAngle(pose.axis[0], pose.axis[1], pose.axis[2],
                                                                               pose.theta);
        }
        else if (kind != StateSpaceKind::R2 && kind != StateSpaceKind::R3)
        {
            state->as<ob::SE2StateSpace::StateType>()->setYaw(pose.theta);
        }
        if (space->isCompound())
        {
            // OMPL aborts on angles beyond pi and on quaternions that are not of unit length
            auto *rotation = state->as<ob::CompoundState>()->components[1];
            space->as<ob::CompoundStateSpace>()->getSubspace(1)->enforceBounds(rotation);
        }
        return state;
    }

    std::string describePose(StateSpaceKind kind, const ConfigPose &pose)
    {
        std::string text = "(" + text::numberText(pose.x) + ", " + text::numberText(pose.y);
        if (positionDimension(kind) == 3)
        {
            text += ", " + text::numberText(pose.z);
        }
        if (kind != StateSpaceKind::R2 && kind != StateSpaceKind::R3)
        {
            text += ", theta " + text::numberText(pose.theta);
        }
        return text + ")";
    }
}  // namespace ompl_mfa::benchmark
