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
#include <array>
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

    namespace
    {
        // States of a motion for a check; the memory is reused by the next one of the thread.
        class MotionStates
        {
        public:
            MotionStates(const JointSpace &joints, const ob::State *s1, const ob::State *s2)
              : dimension_(joints.dimension())
              , from_(joints.values(s1, buffer<0>(dimension_)))
              , difference_(buffer<1>(dimension_))
            {
                joints.difference(s1, s2, difference_);
            }

            void add(double share)
            {
                double *state = buffer<2>(BLOCK * dimension_) + count_ * dimension_;
                for (std::size_t i = 0; i < dimension_; ++i)
                {
                    state[i] = from_[i] + share * difference_[i];
                }
                states_[count_++] = state;
            }

            bool isFull() const
            {
                return count_ == BLOCK;
            }

            std::size_t size() const
            {
                return count_;
            }

            const double *const *states() const
            {
                return states_.data();
            }

            void clear()
            {
                count_ = 0;
            }

        private:
            // As many as are checked at once.
            static constexpr std::size_t BLOCK = 4;

            std::size_t dimension_;
            const double *from_;
            double *difference_;
            std::array<const double *, BLOCK> states_{};
            std::size_t count_{0};
        };

        // The whole numbers from 1 to `last` in an order in which each halves a gap between those before it.
        class HalvingOrder
        {
        public:
            explicit HalvingOrder(unsigned int last)
              : last_(last)
            {
                while (stride_ <= last)
                {
                    stride_ *= 2;
                }
            }

            // 0 after the last one.
            unsigned int next()
            {
                while (stride_ > 0)
                {
                    const unsigned int number = place_ * stride_;
                    if (number <= last_ && number > 0)
                    {
                        place_ += 2;
                        return number;
                    }
                    stride_ /= 2;
                    place_ = 1;
                }
                return 0;
            }

        private:
            unsigned int last_;
            unsigned int stride_{1};
            unsigned int place_{1};
        };
    }  // namespace

    RobotDiscreteValidator::RobotDiscreteValidator(const ob::SpaceInformationPtr &si,
                                                   std::shared_ptr<const RobotValidityChecker> checker)
      : ob::MotionValidator(si)
      , checker_(std::move(checker))
    {
    }

    bool RobotDiscreteValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        bool valid = si_->isValid(s2);
        const unsigned int segments = si_->getStateSpace()->validSegmentCount(s1, s2);
        if (valid && segments > 1)
        {
            MotionStates states(checker_->joints(), s1, s2);
            HalvingOrder order(segments - 1);
            unsigned int number = order.next();
            while (valid && number != 0)
            {
                states.add(static_cast<double>(number) / segments);
                number = order.next();
                if (states.isFull() || number == 0)
                {
                    valid = !checker_->collision().anyCollides(states.states(), states.size());
                    states.clear();
                }
            }
        }
        count(valid ? valid_ : invalid_);
        return valid;
    }

    bool RobotDiscreteValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                             std::pair<ob::State *, double> &lastValid) const
    {
        const unsigned int segments = std::max(1U, si_->getStateSpace()->validSegmentCount(s1, s2));
        MotionStates states(checker_->joints(), s1, s2);
        unsigned int free = 1;
        for (unsigned int number = 1; number < segments && free == number;)
        {
            states.clear();
            for (; number < segments && !states.isFull(); ++number)
            {
                states.add(static_cast<double>(number) / segments);
            }
            free += static_cast<unsigned int>(checker_->collision().firstColliding(states.states(), states.size()));
        }
        const bool valid = free == segments && si_->isValid(s2);
        if (!valid)
        {
            lastValid.second = static_cast<double>(free - 1) / segments;
            if (lastValid.first != nullptr)
            {
                si_->getStateSpace()->interpolate(s1, s2, lastValid.second, lastValid.first);
            }
        }
        count(valid ? valid_ : invalid_);
        return valid;
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
