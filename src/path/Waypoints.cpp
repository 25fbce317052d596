#include "path/Waypoints.h"

#include <algorithm>
#include <utility>

#include <ompl/geometric/PathGeometric.h>

namespace ompl_mfa
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
            return *this;
        if (space_ != other.space_)
        {
            freeStates();
            space_ = other.space_;
        }
        resize(other.size_);
        for (std::size_t i = 0; i < size_; ++i)
            space_->copyState(states_[i], other.states_[i]);
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
            space_->freeState(state);
        states_.clear();
        size_ = 0;
    }

    std::vector<const ompl::base::State *> Waypoints::pointers() const
    {
        return {states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(size_)};
    }

    void Waypoints::appendTo(ompl::geometric::PathGeometric &path) const
    {
        for (std::size_t i = 0; i < size_; ++i)
            path.append(states_[i]);
    }

    double Waypoints::length() const
    {
        double sum = 0.0;
        for (std::size_t i = 1; i < size_; ++i)
            sum += space_->distance(states_[i - 1], states_[i]);
        return sum;
    }

    void Waypoints::resize(std::size_t size)
    {
        while (states_.size() < size)
            states_.push_back(space_->allocState());
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
}  // namespace ompl_mfa
