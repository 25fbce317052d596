#ifndef OMPL_MFA_ENGINE_REFINEMENT_TIGHTENING_PART_
#define OMPL_MFA_ENGINE_REFINEMENT_TIGHTENING_PART_

#include <memory>

#include "engine/SearchPart.h"
#include "engine/refinement/PathTightening.h"

namespace ompl_mfa
{
    /** \brief Tightens the best path in its turns, and at once what other parts propose. */
    class TighteningPart : public SearchPart, public PathRefiner
    {
    public:
        explicit TighteningPart(const SearchContext &context);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        void advance(std::uint64_t work, Findings &findings) override;

        /** \brief A path that refine() made is tightened on from where that stopped, any other one from the
            beginning. */
        void improved(const Proposal &proposal) override;

        const Waypoints &refine(const Waypoints &path, ompl::base::Cost &cost, ompl::base::Cost rival) override;

    private:
        std::unique_ptr<PathTightening> best_;  ///< of the best path
        std::unique_ptr<PathTightening> new_;   ///< of a path that was proposed
        bool refined_{false};                   ///< whether what was tightened last is new_'s
        bool stale_{false};                     ///< whether best_ has to begin with the best path
    };
}  // namespace ompl_mfa

#endif
