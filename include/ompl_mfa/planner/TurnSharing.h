#ifndef OMPL_MFA_PLANNER_TURN_SHARING_
#define OMPL_MFA_PLANNER_TURN_SHARING_

#include <cstdint>
#include <vector>

namespace ompl_mfa
{
    /** \brief Shares work between parts that take turns: each has a share, which grows with what the part gained for
       its work of late and never falls below a floor. */
    class TurnSharing
    {
    public:
        /** \brief Adds a part with a first share and a floor, both positive and relative to those of the others, that
            lets parts without a delay work so much before its first turn; returns its number: 0, 1, ... */
        std::size_t add(double share, double floor, double delay);

        /** \brief The part whose turn it is among those \e available (one flag a part, at least one true): the one
            that has worked least for its share. */
        std::size_t next(const std::vector<bool> &available);

        /** \brief Records a turn of \e part: its \e work and its \e gain, in any unit that is the same for all parts.
         */
        void record(std::size_t part, double work, double gain);

        /** \brief The part of all shares that \e part has now, in (0, 1]. */
        double share(std::size_t part) const;

    private:
        struct Part
        {
            double share;
            double floor;
            double pass{0.0};  ///< work done, divided by the share at the time
            double gain{0.0};
            double work{0.0};
        };

        void adapt();

        std::vector<Part> parts_;
    };
}  // namespace ompl_mfa

#endif
