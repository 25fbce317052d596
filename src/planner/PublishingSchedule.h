#ifndef OMPL_MFA_PLANNER_PUBLISHING_SCHEDULE_
#define OMPL_MFA_PLANNER_PUBLISHING_SCHEDULE_

#include <cstdint>

namespace ompl_mfa
{
    /** \brief Decides when a better path is handed to the problem definition, so that their number stays bounded
        however long the search refines its path.

        The first path is due at once, and so is each that is better than the last published one by 1 % of its cost
        (of these the first 1000 of a query). Smaller improvements are due once the search has done 5 % more work than
        when it last published: n units of work bring log(n) / log(1.05) of them at the most. */
    class PublishingSchedule
    {
    public:
        /** \brief Forgets what was published. */
        void reset();

        /** \brief Whether a path of cost \e cost, better than all that were published, is due after \e work units of
            work. */
        bool due(double cost, std::uint64_t work) const;

        /** \brief Records that a path of cost \e cost was published after \e work units of work. */
        void published(double cost, std::uint64_t work);

    private:
        bool notable(double cost) const;

        bool any_{false};
        double cost_{0.0};
        std::uint64_t work_{0};
        unsigned int notables_{0};
    };
}  // namespace ompl_mfa

#endif
