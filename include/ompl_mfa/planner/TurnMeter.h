#ifndef OMPL_MFA_PLANNER_TURN_METER_
#define OMPL_MFA_PLANNER_TURN_METER_

#include <chrono>
#include <cstdint>

#include "ompl_mfa/path/PathEvaluator.h"

namespace ompl_mfa
{
    /** \brief Measures what a turn costs, in s: by a clock, or, where a run has to repeat, by counted work.

        The clock is that of the wall: what a validity checker spends in other threads, or waiting for an answer, is
        time that the turn took. Counted work has two prices: that of a state check, which the user declares, and that
        of a unit of bookkeeping, which is the same for all problems. */
    class TurnMeter
    {
    public:
        /** \brief By the clock, or if \e stateCheckTime (s) is positive by the work of \e evaluator, which outlives
            the meter. */
        TurnMeter(const PathEvaluator &evaluator, double stateCheckTime);

        /** \brief Seconds since the meter was made; positive. */
        double spent() const;

    private:
        const PathEvaluator &evaluator_;
        double stateCheckTime_;
        std::uint64_t checks_;
        std::uint64_t bookkeeping_;
        std::chrono::steady_clock::time_point begin_;
    };
}  // namespace ompl_mfa

#endif
