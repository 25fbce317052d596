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
    /** \brief What is kept of a run that is over. */
    struct RunReport
    {
        /** \brief An object for the journal. The fields of the task's key are put before it. */
        Json record;
        /** \brief How the run ended, in words. */
        std::string text;
        /** \brief Whether it did not end as runs should. */
        bool failed{false};
    };

    /** \brief A run that is about to start. */
    struct Work
    {
        /** \brief Called in the process of the run. An InputError that it throws ends the campaign. */
        RunProcess::Body body;
        RunLimits limits;
        /** \brief What `body` shares with this process. */
        std::shared_ptr<const RunState> state;
        /** \brief Called here when the process is over, however it ended. */
        std::function<RunReport(const RunProcess &)> report;
    };

    /** \brief A run of a campaign. */
    struct Task
    {
        /** \brief The fields by which its run is found in the journal; all tasks of a campaign have the same ones. */
        Json key;
        /** \brief What it is called where progress is shown. */
        std::string name;
        /** \brief Runs of the same group take about equally long: its duration is estimated from theirs. */
        std::string group;
        /** \brief Seconds that it may take as long as no run of its group is over. */
        double expected{0.0};
        /** \brief Called when its turn has come. */
        std::function<Work()> makeWork;
    };

    /** \brief How the runs of a campaign are made. */
    struct RunOptions
    {
        std::filesystem::path journal;
        /** \brief Runs at the same time. */
        unsigned int jobs{1};
        /** \brief Whether each of them is bound to a core of its own. */
        bool bindToCores{false};
        /** \brief This is part `shard` of `shards`, counted from 1: it makes every `shards`-th run. */
        unsigned int shard{1};
        unsigned int shards{1};
        /** \brief Makes only the runs that the journal does not have. */
        bool resume{false};
        /** \brief Drops the journal of an interrupted campaign. */
        bool overwrite{false};
        /** \brief Where progress is shown; nowhere if null. */
        std::ostream *progress{nullptr};
        /** \brief Whether `progress` is a terminal, on which one line is overwritten. */
        bool terminal{false};
    };

    /** \brief What came out of a campaign; the runs are in its journal. */
    struct RunsMade
    {
        /** \brief Of the journal. */
        JournalHeader header;
        /** \brief The signal that stopped the campaign before its end; 0 if none did. */
        int interruptedBy{0};
        /** \brief Runs that are still to be made. */
        std::size_t missing{0};
    };

    /** \brief Makes the runs of \e tasks in their order, each in a process of its own, and keeps them in a journal.

        Whatever a run does to its process costs that run alone. Runs that are over are on the disk: a campaign that was
        stopped at any point continues with `resume`. SIGINT, SIGTERM and SIGHUP stop it. Of \e header, `campaign` and
        `description` are used. The calling process must have a single thread.

        Throws InputError when the journal cannot be written, when one of an interrupted or of another campaign is in
        the way, for more jobs than there are cores to bind them to, and when a run refuses what it was asked for. */
    OMPL_MFA_EXPORT RunsMade makeRuns(JournalHeader header, const std::vector<Task> &tasks, const RunOptions &options);

    /** \brief The indices below \e count that part \e shard of \e shards, counted from 1, has. */
    OMPL_MFA_EXPORT std::vector<std::size_t> shareOf(std::size_t count, unsigned int shard, unsigned int shards);
}  // namespace ompl_mfa::campaign

#endif
