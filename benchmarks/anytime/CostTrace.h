#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_COST_TRACE_
#define OMPL_MFA_BENCHMARKS_ANYTIME_COST_TRACE_

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include <ompl/base/Planner.h>

#include "anytime/World.h"

namespace ompl_mfa::anytime
{
    /** \brief What a time limit counts. */
    enum class Clock
    {
        CPU,  ///< the processor time of the run: other programs on the machine do not count
        WALL
    };

    /** \brief "cpu" or "wall". */
    std::string clockName(Clock clock);

    /** \brief Seconds since some moment in the past. */
    double wallTime();

    /** \brief Seconds of processor time of this process, all of its threads together. */
    double cpuTime();

    /** \brief A better path: when, how good, after how many checked states. Seconds since the planner was started. */
    struct Improvement
    {
        double wall;
        double cpu;
        double cost;
        std::uint64_t checks;
    };

    /** \brief Improvements of one run. Of constant size and without pointers: it lives in memory that two processes
        share, and what was written survives the writer. */
    struct ImprovementLog
    {
        static constexpr std::uint32_t CAPACITY = 20000;

        std::atomic<std::uint32_t> count{0};
        Improvement entries[CAPACITY]{};
    };

    /** \brief Follows the cost of a planner's best path while it runs: through the callback for intermediate
        solutions, and by reading the property `best cost` whenever the planner asks whether it should stop, at most
        every 0.2 ms. */
    class CostTrace
    {
    public:
        /** \brief Registers the callback in the problem definition. The clocks start here. \e limit in seconds of
            \e clock. */
        CostTrace(const Problem &problem, const ompl::base::Planner &planner, Clock clock, double limit,
                  ImprovementLog &log);
        ~CostTrace();
        CostTrace(const CostTrace &) = delete;
        CostTrace &operator=(const CostTrace &) = delete;

        /** \brief The planner's termination condition: true once the limit has passed. */
        bool expired();

        /** \brief Logs \e cost if it is better than all before. */
        void offer(double cost);

    private:
        void poll();

        const Problem &problem_;
        Clock clock_;
        double limit_;
        ImprovementLog &log_;
        ompl::base::Planner::PlannerProgressProperty bestCost_;
        double wallStart_;
        double cpuStart_;
        double best_;
        std::mutex mutex_;
        std::atomic<double> nextPoll_{0.0};
        std::atomic<bool> expired_{false};
    };
}  // namespace ompl_mfa::anytime

#endif
