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

#include "path/Waypoints.h"

#include <algorithm>
#include <utility>

#include <ompl/geometric/PathGeometric.h>

namespace ompl_mfa::path
{
    Waypoints::Waypoints(ompl::base::StateSpacePtr space)
      : space_(std::move(space))
    {
    }

    Waypoints::Waypoints(const Waypoints &other)
      : space_(other.space_)
    {
        *this = other;
    }

    Waypoints::Waypoints(Waypoints &&other) noexcept
      : Waypoints(other.space_)
    {
        *this = std::move(other);
    }

    Waypoints &Waypoints::operator=(const Waypoints &other)
    {
        if (this == &other)
        {
            return *this;
        }
        if (space_ != other.space_)
        {
            freeStates();
            space_ = other.space_;
        }
        resize(other.size_);
        for (std::size_t i = 0; i < size_; ++i)
        {
            space_->copyState(states_[i], other.states_[i]);
        }
        return *this;
    }

    Waypoints &Waypoints::operator=(Waypoints &&other) noexcept
    {
        space_.swap(other.space_);
        states_.swap(other.states_);
        std::swap(size_, other.size_);
        return *this;
    }

    Waypoints::~Waypoints()
    {
        freeStates();
    }

    void Waypoints::freeStates()
    {
        for (auto *state : states_)
        {
            space_->freeState(state);
        }
        states_.clear();
        size_ = 0;
    }

    bool Waypoints::equals(const Waypoints &other) const
    {
        bool equal = size_ == other.size_;
        for (std::size_t i = 0; equal && i < size_; ++i)
        {
            equal = space_->equalStates(states_[i], other.states_[i]);
        }
        return equal;
    }

    std::vector<const ompl::base::State *> Waypoints::pointers() const
    {
        return {states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(size_)};
    }

    void Waypoints::appendTo(ompl::geometric::PathGeometric &path) const
    {
        for (std::size_t i = 0; i < size_; ++i)
        {
            path.append(states_[i]);
        }
    }

    double Waypoints::length() const
    {
        double sum = 0.0;
        for (std::size_t i = 1; i < size_; ++i)
        {
            sum += space_->distance(states_[i - 1], states_[i]);
        }
        return sum;
    }

    void Waypoints::resize(std::size_t size)
    {
        while (states_.size() < size)
        {
            states_.push_back(space_->allocState());
        }
        size_ = size;
    }

    void Waypoints::append(const ompl::base::State *state)
    {
        resize(size_ + 1);
        space_->copyState(states_[size_ - 1], state);
    }

    void Waypoints::insert(std::size_t i, const ompl::base::State *state)
    {
        append(state);
        const auto first = states_.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = states_.begin() + static_cast<std::ptrdiff_t>(size_);
        std::rotate(first, end - 1, end);
    }

    void Waypoints::erase(std::size_t first, std::size_t last)
    {
        std::rotate(states_.begin() + static_cast<std::ptrdiff_t>(first),
                    states_.begin() + static_cast<std::ptrdiff_t>(last),
                    states_.begin() + static_cast<std::ptrdiff_t>(size_));
        size_ -= last - first;
    }

    void Waypoints::reverse()
    {
        std::reverse(states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(size_));
    }
}  // namespace ompl_mfa::path
