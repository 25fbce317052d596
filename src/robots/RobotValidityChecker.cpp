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

#include "ompl_mfa/robots/RobotValidityChecker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    namespace
    {
        // Memory of a thread for the values of joints. Callers that need two at a time number them.
        template <int Number = 0>
        double *buffer(std::size_t size)
        {
            thread_local std::vector<double> values;
            if (values.size() < size)
            {
                values.resize(size);
            }
            return values.data();
        }

        // OMPL's counters are plain integers, and planners check motions from several threads.
        void count(unsigned int &counter)
        {
            __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
        }
    }  // namespace

    RobotValidityChecker::RobotValidityChecker(const ob::SpaceInformationPtr &si, JointSpace joints,
                                               std::shared_ptr<const RobotCollision> collision)
      : ob::StateValidityChecker(si)
      , joints_(std::move(joints))
      , collision_(std::move(collision))
    {
        if (!collision_ || collision_->kinematics().dimension() != joints_.dimension())
        {
            throw std::invalid_argument("RobotValidityChecker: the collision checker must be of the same joints");
        }
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
    }

    bool RobotValidityChecker::isValid(const ob::State *state) const
    {
        return si_->satisfiesBounds(state) && !collision_->collides(joints_.values(state, buffer(joints_.dimension())));
    }

    double RobotValidityChecker::clearance(const ob::State *state) const
    {
        return collision_->distance(joints_.values(state, buffer(joints_.dimension())));
    }

    RobotMotionValidator::RobotMotionValidator(const ob::SpaceInformationPtr &si,
                                               std::shared_ptr<const RobotValidityChecker> checker)
      : ob::MotionValidator(si)
      , checker_(std::move(checker))
      , clearanceTolerance_(1e-7 * checker_->collision().extent())
    {
    }

    bool RobotMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const bool valid = si_->isValid(s2) && advance(s1, s2, true) >= 1.;
        count(valid ? valid_ : invalid_);
        return valid;
    }

    bool RobotMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                           std::pair<ob::State *, double> &lastValid) const
    {
        const double reached = advance(s1, s2, false);
        const bool valid = reached >= 1. && si_->isValid(s2);
        if (!valid)
        {
            lastValid.second = std::min(reached, std::nextafter(1., 0.));
            // The limits are a box, so a motion that ends outside leaves it once.
            ob::State *state = si_->allocState();
            double inside = 0.;
            double outside = lastValid.second;
            constexpr double BOUNDS_RESOLUTION = 1e-9;
            si_->getStateSpace()->interpolate(s1, s2, outside, state);
            for (inside = si_->satisfiesBounds(state) ? outside : 0.; outside - inside > BOUNDS_RESOLUTION;)
            {
                const double share = 0.5 * (inside + outside);
                si_->getStateSpace()->interpolate(s1, s2, share, state);
                (si_->satisfiesBounds(state) ? inside : outside) = share;
            }
            lastValid.second = inside;
            if (lastValid.first != nullptr)
            {
                si_->getStateSpace()->interpolate(s1, s2, inside, lastValid.first);
            }
            si_->freeState(state);
        }
        count(valid ? valid_ : invalid_);
        return valid;
    }

    double RobotMotionValidator::advance(const ob::State *s1, const ob::State *s2, bool untilFirst) const
    {
        const JointSpace &joints = checker_->joints();
        const double *from = joints.values(s1, buffer<0>(joints.dimension()));
        double *difference = buffer<1>(joints.dimension());
        joints.difference(s1, s2, difference);
        return checker_->collision().advance(from, difference, clearanceTolerance_, untilFirst);
    }
}  // namespace ompl_mfa::robots
