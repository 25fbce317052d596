#ifndef OMPL_MFA_BENCHMARK_COUNTING_VALIDITY_CHECKER_
#define OMPL_MFA_BENCHMARK_COUNTING_VALIDITY_CHECKER_

#include <atomic>
#include <cstdint>

#include "ompl_mfa/collision/FclStateValidityChecker.h"

namespace ompl_mfa
{
    /** \brief Counts the states that are checked. Distance queries of continuous motion validation do not count. */
    class CountingValidityChecker : public collision::FclStateValidityChecker
    {
    public:
        using FclStateValidityChecker::FclStateValidityChecker;

        bool isValid(const ompl::base::State *state) const override
        {
            checkedStates_.fetch_add(1, std::memory_order_relaxed);
            return FclStateValidityChecker::isValid(state);
        }

        /** \brief States checked since construction. */
        std::uint_fast64_t checkedStates() const
        {
            return checkedStates_.load(std::memory_order_relaxed);
        }

    private:
        mutable std::atomic<std::uint_fast64_t> checkedStates_{0};
    };
}  // namespace ompl_mfa

#endif
