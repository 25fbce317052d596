#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_CAMPAIGN_
#define OMPL_MFA_BENCHMARKS_ANYTIME_CAMPAIGN_

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "anytime/PlannerRun.h"

namespace ompl_mfa::anytime
{
    struct CampaignRequest
    {
        std::vector<World> worlds;
        /** \brief As parsePlanner() reads them. */
        std::vector<std::string> planners;
        /** \brief Seeds 1 to this number. */
        std::uint32_t seeds;
        /** \brief Seconds a run, of \e clock. */
        double timeLimit;
        Clock clock;
        /** \brief Runs at a time, each on a core of its own. */
        unsigned int jobs;
    };

    /** \brief Makes the runs that \e runs does not hold yet, seed by seed, so that an interrupted campaign has about as
        many runs of each planner; reports each on \e progress. Throws InputError for a planner that cannot be made
        and for more jobs than cores. */
    void runCampaign(const CampaignRequest &campaign, const std::filesystem::path &runs, std::ostream &progress);
}  // namespace ompl_mfa::anytime

#endif
