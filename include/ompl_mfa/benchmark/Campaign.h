/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_BENCHMARK_CAMPAIGN_
#define OMPL_MFA_BENCHMARK_CAMPAIGN_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::benchmark
{
    /** \brief Settings of all runs of a campaign. */
    struct RunSettings
    {
        /** \brief Seconds. */
        double timeLimit{5.0};
        /** \brief Megabytes (2^20 bytes). */
        double memoryLimit{4096.0};
        /** \brief Seconds between two samples of the progress properties. */
        double progressInterval{0.01};
        /** \brief Evaluations of the termination condition before the planner has to stop; 0: no limit. */
        std::uint64_t iterationLimit{0};
        bool simplify{true};
        /** \brief Whether the path of an exact solution is stored in the journal. */
        bool keepPath{false};
    };

    /** \brief Makes the problem of a run. Called in the run's own process, after the seed is set. */
    using ProblemAllocator = std::function<ompl::geometric::SimpleSetupPtr()>;

    /** \brief The seed of run \e run of every planner in a campaign with seed \e base: an output of SplitMix64
        (Steele, Lea and Flood, 2014) for the state base + (run + 1) 0x9e3779b97f4a7c15, folded to [1, 2^31 - 1]. */
    OMPL_MFA_EXPORT std::uint32_t runSeed(std::uint64_t base, unsigned int run);

    /** \brief Makes the problem of this number, from 0, of a campaign's set. Called as a ProblemAllocator. */
    using NumberedProblemAllocator = std::function<ompl::geometric::SimpleSetupPtr(std::size_t)>;

    /** \brief One planner of a campaign, with its problems. */
    struct CampaignPlanner
    {
        /** \brief Unique in its campaign. Logs add OMPL's prefix "geometric_". */
        std::string name;
        NumberedProblemAllocator makeProblem;
        ompl::base::PlannerAllocator makePlanner;
    };

    /** \brief What is run: everything but the machine that determines the results. */
    struct CampaignDescription
    {
        std::string name;
        std::vector<CampaignPlanner> planners;
        RunSettings settings;
        /** \brief Runs of each planner, over all problems. */
        unsigned int runCount{100};
        /** \brief One entry per problem of a set: the properties that its runs have in logs. Run k of every planner is
           of problem k modulo their number. If empty, there is one problem. */
        std::vector<LogProperties> problems;
        /** \brief Run k of every planner has the seed runSeed(seed, k). */
        std::uint64_t seed{1};
        SavePaths savePaths{SavePaths::None};
        /** \brief Anything else that distinguishes this campaign from others: the text of its files. */
        std::string identity;
    };

    /** \brief How a campaign is run. */
    struct CampaignOptions
    {
        /** \brief The log; its journal and the paths are written to the same folder. */
        std::filesystem::path log;
        /** \brief An SQLite database to which the runs are added, see addToDatabase(); none if empty. */
        std::filesystem::path database;
        /** \brief Number of simultaneous runs. */
        unsigned int jobs{1};
        /** \brief Makes only shard `shard` of `shards`, counted from 1. */
        unsigned int shard{1};
        unsigned int shards{1};
        /** \brief Makes only the runs missing in the journal. */
        bool resume{false};
        /** \brief Discards the journal of an interrupted campaign. */
        bool overwrite{false};
        /** \brief Seconds after the time limit at which a planner that has not returned is killed; if negative, 1 s
            plus a tenth of the limit. */
        double grace{-1.0};
        /** \brief Where progress is shown. */
        std::ostream *progress{nullptr};
        /** \brief Whether `progress` is a terminal, on which one line is overwritten. */
        bool terminal{false};
    };

    /** \brief Result of a campaign. */
    struct CampaignResult
    {
        BenchmarkLog log;
        /** \brief The signal that interrupted the campaign; 0 if none did. */
        int interruptedBy{0};
        /** \brief Number of runs still to be made. */
        std::size_t missing{0};
    };

    /** \brief Runs planners on a problem, each run in a separate process, and writes OMPL's benchmark log.

        A run that damages its process affects no other run. Finished runs are on the disk: a campaign stopped at any
        point continues with `resume`. The calling process must be single-threaded. */
    class OMPL_MFA_EXPORT Campaign
    {
    public:
        /** \brief Throws InputError if there is no planner or no run, or if two planners have the same name. */
        explicit Campaign(CampaignDescription description);

        /** \brief Makes the problem and the planners once, in a separate process. Passes on their InputErrors. */
        void validate() const;

        /** \brief Makes the runs and writes the log. On SIGINT, SIGTERM or SIGHUP it writes a log of the finished runs
            and returns. Throws InputError if the log or the database cannot be written, or if there already is a
           journal of an interrupted or of another campaign. */
        CampaignResult run(const CampaignOptions &options) const;

        /** \brief A digest of the description, by which logs and journals of the same campaign are recognised. */
        std::string fingerprint() const;

        /** \brief All runs as (planner, run), in the order in which they are started; shard i of n makes every n-th.

            Runs of all planners alternate, and each shard has an equal number of runs of each planner, so that neither
            the time of the day nor a slower machine affects one planner more than the others. */
        std::vector<std::pair<std::size_t, unsigned int>> runs() const;

        const CampaignDescription &description() const;

        /** \brief The journal file of the log \e log. */
        static std::filesystem::path journalFile(const std::filesystem::path &log);

    private:
        CampaignDescription description_;
    };

    /** \brief The campaign of a config, as `ompl_mfa benchmark` runs it. Loads world and robot.

        Throws InputError as ProblemFactory does, and for a planner parameter `seed`, as the campaign sets the seeds. */
    OMPL_MFA_EXPORT Campaign makeCampaign(const BenchmarkConfig &config);

    /** \brief The log of a config: NAME.log in the folder given by its key `output`, or else in that of the config; for
        a shard NAME.I-of-N.log. Campaign::run() creates missing folders. */
    OMPL_MFA_EXPORT std::filesystem::path logFile(const BenchmarkConfig &config, unsigned int shard,
                                                  unsigned int shards);
}  // namespace ompl_mfa::benchmark

#endif
