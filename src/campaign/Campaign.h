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

#ifndef OMPL_MFA_CAMPAIGN_CAMPAIGN_
#define OMPL_MFA_CAMPAIGN_CAMPAIGN_

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "campaign/RunJournal.h"
#include "campaign/RunProcess.h"
#include "ompl_mfa/Export.h"

namespace ompl_mfa::campaign
{
    /** \brief Report of a finished run. */
    struct RunReport
    {
        /** \brief An object for the journal, to which the fields of the task's key are prepended. */
        Json record;
        /** \brief How the run ended, in words. */
        std::string text;
        /** \brief Whether the run failed. */
        bool failed{false};
    };

    /** \brief A run that is about to start. */
    struct Work
    {
        /** \brief Called in the process of the run. An InputError ends the campaign. */
        RunProcess::Body body;
        RunLimits limits;
        /** \brief Memory that `body` shares with this process. */
        std::shared_ptr<const RunState> state;
        /** \brief Called in this process after that of the run has ended, however it ended. */
        std::function<RunReport(const RunProcess &)> report;
    };

    /** \brief A run of a campaign. */
    struct Task
    {
        /** \brief The fields that identify its run in the journal; the same ones in all tasks of a campaign. */
        Json key;
        /** \brief Name in progress messages. */
        std::string name;
        /** \brief Runs of the same group take about equally long, so the duration is estimated from the finished
            ones. */
        std::string group;
        /** \brief Estimated seconds until a run of its group has finished. */
        double expected{0.0};
        /** \brief Called before the run starts. */
        std::function<Work()> makeWork;
    };

    /** \brief Options for the runs of a campaign. */
    struct RunOptions
    {
        std::filesystem::path journal;
        /** \brief Number of simultaneous runs. */
        unsigned int jobs{1};
        /** \brief Whether each run is bound to a separate core. */
        bool bindToCores{false};
        /** \brief Makes only shard `shard` of `shards`, counted from 1: every `shards`-th run. */
        unsigned int shard{1};
        unsigned int shards{1};
        /** \brief Makes only the runs missing in the journal. */
        bool resume{false};
        /** \brief Discards the journal of an interrupted campaign. */
        bool overwrite{false};
        /** \brief Where progress is shown; nowhere if null. */
        std::ostream *progress{nullptr};
        /** \brief Whether `progress` is a terminal, on which one line is overwritten. */
        bool terminal{false};
    };

    /** \brief Result of a campaign; the runs are in its journal. */
    struct RunsMade
    {
        /** \brief Header of the journal. */
        JournalHeader header;
        /** \brief The signal that interrupted the campaign; 0 if none did. */
        int interruptedBy{0};
        /** \brief Number of runs still to be made. */
        std::size_t missing{0};
    };

    /** \brief Makes the runs of \e tasks in order, each in a separate process, and stores them in a journal.

        A run that damages its process affects no other run. Finished runs are on the disk: a campaign stopped at any
        point continues with `resume`. SIGINT, SIGTERM and SIGHUP stop it. Only `campaign` and `description` of \e
        header are used. The calling process must be single-threaded.

        Throws InputError if the journal cannot be written, if there already is one of an interrupted or of another
        campaign, for more jobs than cores to bind them to, and if a run throws one. */
    OMPL_MFA_EXPORT RunsMade makeRuns(JournalHeader header, const std::vector<Task> &tasks, const RunOptions &options);

    /** \brief The indices below \e count that belong to shard \e shard of \e shards, counted from 1. */
    OMPL_MFA_EXPORT std::vector<std::size_t> shareOf(std::size_t count, unsigned int shard, unsigned int shards);
}  // namespace ompl_mfa::campaign

#endif
