#ifndef OMPL_MFA_ENGINE_FIREFLIES_RECOMBINATION_PART_
#define OMPL_MFA_ENGINE_FIREFLIES_RECOMBINATION_PART_

#include <memory>

#include "engine/SearchPart.h"
#include "engine/fireflies/Swarms.h"

namespace ompl_mfa
{
    /** \brief Splices the paths of the active swarm, the best path and fresh states on the slices into better paths. */
    class RecombinationPart : public SearchPart
    {
    public:
        /** \brief As FireflyPart, whose swarms these are. */
        RecombinationPart(const SearchContext &context, std::shared_ptr<Swarms> swarms, bool guided);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        void advance(std::uint64_t work, Findings &findings) override;

    private:
        std::shared_ptr<Swarms> swarms_;
        bool guided_;
    };
}  // namespace ompl_mfa

#endif
