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

#include "ompl_mfa/robots/JointSpace.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    namespace
    {
        // OMPL's distance in a compound is the sum of those of its parts.
        class EuclideanCompound : public ob::CompoundStateSpace
        {
        public:
            double distance(const ob::State *first, const ob::State *second) const override
            {
                double sum = 0.;
                for (unsigned int i = 0; i < getSubspaceCount(); ++i)
                {
                    const double part =
                        getSubspaceWeight(i) * getSubspace(i)->distance(first->as<ob::CompoundState>()->components[i],
                                                                        second->as<ob::CompoundState>()->components[i]);
                    sum += part * part;
                }
                return std::sqrt(sum);
            }

            double getMaximumExtent() const override
            {
                double sum = 0.;
                for (unsigned int i = 0; i < getSubspaceCount(); ++i)
                {
                    const double part = getSubspaceWeight(i) * getSubspace(i)->getMaximumExtent();
                    sum += part * part;
                }
                return std::sqrt(sum);
            }

            unsigned int validSegmentCount(const ob::State *first, const ob::State *second) const override
            {
                // As in spaces that are no compounds: steps of a length in this space, not in one of the joints.
                return getValidSegmentCountFactor() *
                       static_cast<unsigned int>(std::ceil(distance(first, second) / getLongestValidSegmentLength()));
            }
        };

        // The first joints, which move most of the robot. OMPL has no projection for compounds, and its projection of
        // spaces of one or two dimensions aborts in 1.5.2.
        class FirstJoints : public ob::ProjectionEvaluator
        {
        public:
            FirstJoints(const ob::StateSpace *space, const JointSpace &joints, const std::vector<double> &cells)
              : ob::ProjectionEvaluator(space)
              , joints_(joints)
            {
                setCellSizes(cells);
            }

            unsigned int getDimension() const override
            {
                return static_cast<unsigned int>(cellSizes_.size());
            }

            void project(const ob::State *state, Eigen::Ref<Eigen::VectorXd> projection) const override
            {
                std::vector<double> buffer(joints_.dimension());
                const double *values = joints_.values(state, buffer.data());
                std::copy(values, values + getDimension(), projection.data());
            }

        private:
            JointSpace joints_;
        };

        constexpr std::size_t LARGEST_PROJECTION = 3;
        constexpr double CELLS = 20.;
        constexpr double PI = 3.141592653589793;

        std::shared_ptr<ob::RealVectorStateSpace> realSpace(const std::vector<const Joint *> &joints)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>();
            for (const Joint *joint : joints)
            {
                if (!(joint->lower < joint->upper))
                {
                    throw InputError("joint '" + joint->name + "' can only be at " + text::numberText(joint->lower) +
                                     "; leave it out of the group");
                }
                space->addDimension(joint->name, joint->lower, joint->upper);
            }
            return space;
        }
    }  // namespace

    JointSpace::JointSpace(const RobotModel &model, const std::vector<std::size_t> &group,
                           const std::vector<double> &weights)
    {
        if (!weights.empty() &&
            (weights.size() != group.size() ||
             std::any_of(weights.begin(), weights.end(), [](double weight) { return !(weight > 0.); })))
        {
            throw std::invalid_argument("JointSpace: a weight above 0 for each joint is needed, or none");
        }
        std::vector<const Joint *> joints;
        for (const std::size_t index : group)
        {
            joints.push_back(&model.joints()[index]);
            names_.push_back(joints.back()->name);
            isContinuous_.push_back(joints.back()->type == JointType::Continuous ? 1 : 0);
        }
        const bool isWeighted = std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 1.; });
        isCompound_ = isWeighted || std::count(isContinuous_.begin(), isContinuous_.end(), 1) > 0;
        if (!isCompound_)
        {
            space_ = realSpace(joints);
        }
        else
        {
            auto compound = std::make_shared<EuclideanCompound>();
            for (std::size_t i = 0; i < joints.size(); ++i)
            {
                ob::StateSpacePtr part = isContinuous_[i] != 0
                                             ? ob::StateSpacePtr(std::make_shared<ob::SO2StateSpace>())
                                             : ob::StateSpacePtr(realSpace({joints[i]}));
                part->setName(names_[i]);
                compound->addSubspace(part, weights.empty() ? 1. : weights[i]);
            }
            compound->lock();
            space_ = compound;
        }
        space_->setName("joints of " + model.name());
        if (isCompound_ || joints.size() < LARGEST_PROJECTION)
        {
            std::vector<double> cells;
            for (std::size_t i = 0; i < std::min(joints.size(), LARGEST_PROJECTION); ++i)
            {
                cells.push_back((std::min(joints[i]->upper, PI) - std::max(joints[i]->lower, -PI)) / CELLS);
            }
            JointSpace view = *this;
            // Owned by the space, so it must not own the space.
            view.space_.reset();
            space_->registerDefaultProjection(std::make_shared<FirstJoints>(space_.get(), view, cells));
        }
    }

    const double *JointSpace::values(const ob::State *state, double *buffer) const
    {
        if (!isCompound_)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values;
        }
        for (std::size_t i = 0; i < dimension(); ++i)
        {
            const ob::State *part = state->as<ob::CompoundState>()->components[i];
            buffer[i] = isContinuous_[i] != 0 ? part->as<ob::SO2StateSpace::StateType>()->value
                                              : part->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }
        return buffer;
    }

    void JointSpace::setState(const double *values, ob::State *state) const
    {
        if (!isCompound_)
        {
            std::copy(values, values + dimension(), state->as<ob::RealVectorStateSpace::StateType>()->values);
            return;
        }
        for (std::size_t i = 0; i < dimension(); ++i)
        {
            ob::State *part = state->as<ob::CompoundState>()->components[i];
            if (isContinuous_[i] != 0)
            {
                part->as<ob::SO2StateSpace::StateType>()->value = values[i];
                space_->as<ob::CompoundStateSpace>()->getSubspace(static_cast<unsigned int>(i))->enforceBounds(part);
            }
            else
            {
                part->as<ob::RealVectorStateSpace::StateType>()->values[0] = values[i];
            }
        }
    }

    void JointSpace::difference(const ob::State *from, const ob::State *to, double *difference) const
    {
        constexpr double TURN = 6.283185307179586;
        for (std::size_t i = 0; i < dimension(); ++i)
        {
            if (!isCompound_)
            {
                difference[i] = to->as<ob::RealVectorStateSpace::StateType>()->values[i] -
                                from->as<ob::RealVectorStateSpace::StateType>()->values[i];
                continue;
            }
            const ob::State *a = from->as<ob::CompoundState>()->components[i];
            const ob::State *b = to->as<ob::CompoundState>()->components[i];
            difference[i] = isContinuous_[i] != 0 ? std::remainder(b->as<ob::SO2StateSpace::StateType>()->value -
                                                                       a->as<ob::SO2StateSpace::StateType>()->value,
                                                                   TURN)
                                                  : b->as<ob::RealVectorStateSpace::StateType>()->values[0] -
                                                        a->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }
    }
}  // namespace ompl_mfa::robots
