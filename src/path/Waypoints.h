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

#ifndef OMPL_MFA_PATH_WAYPOINTS_
#define OMPL_MFA_PATH_WAYPOINTS_

#include <cstddef>
#include <vector>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace ompl::geometric
{
    class PathGeometric;
}

namespace ompl_mfa::path
{
    /** \brief A sequence of states of one space, which it owns.

        Unlike ompl::geometric::PathGeometric it frees no state before it is destroyed, so that refilling it in a search
        does not allocate. */
    class Waypoints
    {
    public:
        explicit Waypoints(ompl::base::StateSpacePtr space);
        Waypoints(const Waypoints &other);
        Waypoints(Waypoints &&other) noexcept;
        /** \brief Copies the states of \e other and uses its space. */
        Waypoints &operator=(const Waypoints &other);
        /** \brief Swaps states and spaces with \e other. */
        Waypoints &operator=(Waypoints &&other) noexcept;
        ~Waypoints();

        std::size_t size() const
        {
            return size_;
        }

        bool empty() const
        {
            return size_ == 0;
        }

        ompl::base::State *operator[](std::size_t i)
        {
            return states_[i];
        }

        const ompl::base::State *operator[](std::size_t i) const
        {
            return states_[i];
        }

        const ompl::base::State *front() const
        {
            return states_[0];
        }

        const ompl::base::State *back() const
        {
            return states_[size_ - 1];
        }

        const ompl::base::StateSpacePtr &space() const
        {
            return space_;
        }

        /** \brief The sum of the distances from state to state; OMPL must be able to compute the motions (see
            DubinsGuard). */
        double length() const;

        /** \brief Whether both have the same states, in the same order. */
        bool equals(const Waypoints &other) const;

        /** \brief The states in the form of OMPL's callbacks; valid until the next change. */
        std::vector<const ompl::base::State *> pointers() const;

        /** \brief Appends copies of the states to \e path, which must be of the same space. */
        void appendTo(ompl::geometric::PathGeometric &path) const;

        void clear()
        {
            size_ = 0;
        }

        /** \brief Changes the length; new states have unspecified values. */
        void resize(std::size_t size);

        /** \brief Appends a copy of \e state. */
        void append(const ompl::base::State *state);

        /** \brief Inserts a copy of \e state before position \e i, with i <= size(). */
        void insert(std::size_t i, const ompl::base::State *state);

        /** \brief Removes the states first, ..., last - 1. */
        void erase(std::size_t first, std::size_t last);

        /** \brief Reverses the order of the states. */
        void reverse();

    private:
        void freeStates();

        ompl::base::StateSpacePtr space_;
        std::vector<ompl::base::State *> states_;
        std::size_t size_{0};
    };
}  // namespace ompl_mfa::path

#endif
