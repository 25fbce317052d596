#ifndef OMPL_MFA_ENGINE_FIREFLIES_FIREFLY_PART_
#define OMPL_MFA_ENGINE_FIREFLIES_FIREFLY_PART_

#include <memory>

#include "engine/SearchPart.h"
#include "engine/fireflies/Swarms.h"

namespace ompl_mfa
{
    /** \brief Flies the swarms, generation after generation. */
    class FireflyPart : public SearchPart
    {
    public:
        /** \brief \e guided says whether guides should search for a first path before the fireflies do. */
        FireflyPart(const SearchContext &context, std::shared_ptr<Swarms> swarms, bool guided);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        void advance(std::uint64_t work, Findings &findings) override;
        void explain(SearchGraph &graph) const override;

    private:
        void proposeFirefly(Findings &findings);

        std::shared_ptr<Swarms> swarms_;
        bool guided_;
    };

    /** \brief Whether guides should still search alone: where a first path is not found yet, the first turn of a swarm
        takes thousands of state checks. */
    bool guidesFirst(const SearchContext &context);

    /** \brief Fireflies and recombination begin to improve a path after this many times the time that it took: where a
        first path is hard to find, another is too. */
    inline constexpr double FIREFLIES_DELAY = 10.0;
}  // namespace ompl_mfa

#endif
