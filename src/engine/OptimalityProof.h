#ifndef OMPL_MFA_ENGINE_OPTIMALITY_PROOF_
#define OMPL_MFA_ENGINE_OPTIMALITY_PROOF_

#include "engine/PairBounds.h"
#include "engine/SearchContext.h"

namespace ompl_mfa
{
    /** \brief Tells when the best path is the best possible by the objective's lower bounds. */
    class OptimalityProof
    {
    public:
        /** \brief \e context outlives the object. */
        explicit OptimalityProof(const SearchContext &context);

        /** \brief Whether no path can be better than the incumbent, which there is. */
        bool holds();

    private:
        bool meetsBounds();
        bool boundsHold();

        const SearchContext &context_;
        PairBounds pairs_;
        unsigned int probes_{0};  ///< detours held against the objective's bounds
    };
}  // namespace ompl_mfa

#endif
