#ifndef OMPL_MFA_ENGINE_SEARCH_PROGRESS_
#define OMPL_MFA_ENGINE_SEARCH_PROGRESS_

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

#include "engine/PartKind.h"

namespace ompl_mfa
{
    /** \brief Numbers of a search that other threads may read while it runs. */
    class SearchProgress
    {
    public:
        std::atomic<double> bestCost{std::numeric_limits<double>::infinity()};  ///< infinite before the first path
        std::atomic<std::uint64_t> iterations{0};                               ///< firefly generations
        std::atomic<std::uint64_t> evaluations{0};                              ///< path evaluations

        void reset()
        {
            bestCost = std::numeric_limits<double>::infinity();
            iterations = 0;
            evaluations = 0;
            for (auto &spent : spent_)
                spent = 0.0;
        }

        /** \brief Counts \e seconds of work by \e part. Called by the searching thread only. */
        void addTime(PartKind part, double seconds)
        {
            auto &spent = spent_[static_cast<std::size_t>(part)];
            spent.store(spent.load(std::memory_order_relaxed) + seconds, std::memory_order_relaxed);
        }

        /** \brief Seconds that all parts have worked. */
        double time() const
        {
            double sum = 0.0;
            for (const auto &spent : spent_)
                sum += spent.load(std::memory_order_relaxed);
            return sum;
        }

        /** \brief The share of \e part in the work so far, in [0, 1]; 0 before any work. */
        double share(PartKind part) const
        {
            const double sum = time();
            return sum > 0.0 ? spent_[static_cast<std::size_t>(part)].load(std::memory_order_relaxed) / sum : 0.0;
        }

    private:
        std::array<std::atomic<double>, PART_NAMES.size()> spent_{};
    };
}  // namespace ompl_mfa

#endif
