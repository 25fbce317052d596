#ifndef OMPL_MFA_ENGINE_PART_KIND_
#define OMPL_MFA_ENGINE_PART_KIND_

#include <array>

namespace ompl_mfa
{
    /** \brief The parts that a search can have, in the order in which they are registered. */
    enum class PartKind : unsigned char
    {
        Fireflies,
        Recombination,
        Tightening,
        Trees,
        Roadmap,
        GuestPlanner,
        GoalSearch
    };

    /** \brief Names of the parts, by PartKind, as users read them. */
    inline constexpr std::array<const char *, 7> PART_NAMES{"fireflies", "recombination", "tightening", "trees",
                                                            "roadmap",   "guide planner", "goal search"};
}  // namespace ompl_mfa

#endif
