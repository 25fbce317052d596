#ifndef OMPL_MFA_ENGINE_TURN_SHARING_
#define OMPL_MFA_ENGINE_TURN_SHARING_

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/SearchPart.h"

namespace ompl_mfa
{
    /** \brief Shares work between parts that take turns: each has a share, which grows with what the part gained for
       its work of late and never falls below a floor. */
    class TurnSharing
    {
    public:
        /** \brief Adds a part; returns its number: 0, 1, ... */
        std::size_t add(const Share &share);

        /** \brief The number of the part whose turn it is, by the readiness of each: of those that are ready the one
            that has worked least for its share, or of those that wait where none is ready; none where all are idle. */
        std::optional<std::size_t> next(const std::vector<Readiness> &readiness);

        /** \brief Records a turn of \e part: its \e work, and what each part gained by it, in any unit that is the
            same for all parts. */
        void record(std::size_t part, double work, const std::vector<double> &gains);

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

        std::optional<std::size_t> leastWorked(const std::vector<Readiness> &readiness, Readiness wanted) const;
        void adapt();

        std::vector<Part> parts_;
    };
}  // namespace ompl_mfa

#endif
