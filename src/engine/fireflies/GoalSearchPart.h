#ifndef OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_PART_
#define OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_PART_

#include <memory>

#include "engine/SearchPart.h"
#include "engine/fireflies/GoalSearch.h"

namespace ompl_mfa
{
    /** \brief Appends goal states where the goal cannot be sampled but tells distances. */
    class GoalSearchPart : public SearchPart
    {
    public:
        explicit GoalSearchPart(const SearchContext &context);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        void advance(std::uint64_t work, Findings &findings) override;

    private:
        std::unique_ptr<GoalSearch> search_;  ///< made when the first start is known
        std::uint64_t found_{0};
        std::uint64_t due_{0};  ///< work of the evaluator before the next turn
    };
}  // namespace ompl_mfa

#endif
