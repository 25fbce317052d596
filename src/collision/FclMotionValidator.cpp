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

#include "ompl_mfa/collision/FclMotionValidator.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/DiscreteMotionValidator.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        // Resolution at which a motion leaves the bounds, as a fraction of the motion.
        constexpr double BOUNDS_RESOLUTION = 1e-9;

        // OMPL's counters are plain integers, and planners check motions from several threads.
        void count(unsigned int &counter)
        {
            __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
        }

        double tolerance(const Scene &scene)
        {
            return scene.objects().empty() ? 1e-7 : 1e-7 * (scene.bounds().max_ - scene.bounds().min_).norm();
        }
    }  // namespace

    FclMotionValidator::FclMotionValidator(const ob::SpaceInformationPtr &si,
                                           std::shared_ptr<const FclStateValidityChecker> checker)
      : ob::MotionValidator(si)
      , checker_(std::move(checker))
      , clearanceTolerance_(tolerance(checker_->query().scene()))
    {
        if (!checker_->placement().interpolatesStraight())
        {
            throw InputError("the motions of the space '" + si->getStateSpace()->getName() +
                             "' are curved, and continuous validation is for straight ones; expected discrete");
        }
    }

    bool FclMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const bool valid = si_->isValid(s2) && advance(s1, s2, true) >= 1.;
        count(valid ? valid_ : invalid_);
        return valid;
    }

    bool FclMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                         std::pair<ob::State *, double> &lastValid) const
    {
        const double reached = advance(s1, s2, false);
        const bool valid = reached >= 1. && si_->isValid(s2);
        if (!valid)
        {
            lastValid.second = std::min(shareWithinBounds(s1, s2, reached), std::nextafter(1., 0.));
            if (lastValid.first != nullptr)
            {
                si_->getStateSpace()->interpolate(s1, s2, lastValid.second, lastValid.first);
            }
        }
        count(valid ? valid_ : invalid_);
        return valid;
    }

    double FclMotionValidator::advance(const ob::State *s1, const ob::State *s2, bool untilFirst) const
    {
        thread_local std::vector<BodyMotion> motions;
        const StatePlacement &placement = checker_->placement();
        if (motions.size() < placement.bodyCount())
        {
            motions.resize(placement.bodyCount());
        }
        for (std::size_t body = 0; body < placement.bodyCount(); ++body)
        {
            motions[body] = placement.motion(s1, s2, body);
        }
        return checker_->query().advance(motions.data(), clearanceTolerance_, untilFirst);
    }

    double FclMotionValidator::shareWithinBounds(const ob::State *s1, const ob::State *s2, double reached) const
    {
        const ob::StateSpacePtr &space = si_->getStateSpace();
        if (space->satisfiesBounds(s2))
        {
            return reached;
        }
        ob::State *state = si_->allocState();
        double inside = 0.;
        double outside = reached;
        for (double share = reached; outside - inside > BOUNDS_RESOLUTION; share = 0.5 * (inside + outside))
        {
            space->interpolate(s1, s2, share, state);
            if (space->satisfiesBounds(state))
            {
                inside = share;
                if (share == reached)
                {
                    break;
                }
            }
            else
            {
                outside = share;
            }
        }
        si_->freeState(state);
        return inside;
    }

    void setCollisionChecking(const ob::SpaceInformationPtr &si,
                              const std::shared_ptr<FclStateValidityChecker> &checker, MotionValidation validation)
    {
        si->setStateValidityChecker(checker);
        if (validation == MotionValidation::Continuous)
        {
            si->setMotionValidator(std::make_shared<FclMotionValidator>(si, checker));
        }
        else
        {
            si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
        }
    }
}  // namespace ompl_mfa::collision
