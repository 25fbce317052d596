#ifndef OMPL_MFA_ENGINE_END_PAIRS_
#define OMPL_MFA_ENGINE_END_PAIRS_

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/Query.h"

namespace ompl_mfa
{
    /** \brief The pairs of start and goal of a query, each once, as they become known. */
    class EndPairs
    {
    public:
        /** \brief The next pair of numbers into the query's starts and goals; none while there is no new one. */
        std::optional<std::pair<std::size_t, std::size_t>> next(const Query &query);

        /** \brief Has next() return the pair that it returned last once more. */
        void putBack();

    private:
        std::vector<std::size_t> goals_;  ///< of each start: goals with which it was returned
        std::size_t last_{0};             ///< start of the last pair
    };
}  // namespace ompl_mfa

#endif
