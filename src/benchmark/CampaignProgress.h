#ifndef OMPL_MFA_BENCHMARK_CAMPAIGN_PROGRESS_
#define OMPL_MFA_BENCHMARK_CAMPAIGN_PROGRESS_

#include <iosfwd>
#include <map>
#include <string>

#include "ompl_mfa/benchmark/RunRecord.h"

namespace ompl_mfa
{
    /** \brief Shows how far a campaign is: a bar that is overwritten on a terminal, else one line a run. */
    class CampaignProgress
    {
    public:
        /** \brief \e total runs, of which \e done need not be made. \e out may be null. */
        CampaignProgress(std::ostream *out, bool terminal, std::size_t total, std::size_t done);

        /** \brief Says that run \e run of \e planner is under way; \e secondsLeft is an estimate for the rest. */
        void running(const std::string &planner, unsigned int run, double secondsLeft);

        /** \brief Says how a run ended. */
        void finished(const RunRecord &record);

        /** \brief Ends the line of the bar. */
        void close();

    private:
        void clearLine();

        std::ostream *out_;
        bool terminal_;
        std::size_t total_;
        std::size_t done_;
        std::size_t lineLength_{0};
        double lastShown_{0.0};
    };

    /** \brief "3 s", "2:05" or "1:02:05". */
    std::string formatDuration(double seconds);

    /** \brief How a run ended, in words: "exact solution, cost 12.3", "killed at its time limit", "signal 11 (...)". */
    std::string describeRun(const RunRecord &record);
}  // namespace ompl_mfa

#endif
