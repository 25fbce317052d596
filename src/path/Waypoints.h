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

namespace ompl_mfa
{
    /** \brief A sequence of states of one space that owns its states and reuses their memory when it changes length.

        Unlike ompl::geometric::PathGeometric it never frees a state before it is destroyed, so that filling it again
        and again in a search allocates nothing. */
    class Waypoints
    {
    public:
        explicit Waypoints(ompl::base::StateSpacePtr space);
        Waypoints(const Waypoints &other);
        Waypoints(Waypoints &&other) noexcept;
        /** \brief Copies the states of \e other, in its space. */
        Waypoints &operator=(const Waypoints &other);
        /** \brief Takes the states of \e other and its space; \e other is left with those that were here. */
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

        /** \brief The sum of the distances from state to state; OMPL can compute the motions (see DubinsGuard). */
        double length() const;

        /** \brief The states as OMPL's callbacks take them; valid until the next change. */
        std::vector<const ompl::base::State *> pointers() const;

        /** \brief Appends copies of the states to \e path, which is of the same space. */
        void appendTo(ompl::geometric::PathGeometric &path) const;

        void clear()
        {
            size_ = 0;
        }

        /** \brief Changes the length; states beyond the old length have unspecified values. */
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
}  // namespace ompl_mfa

#endif
