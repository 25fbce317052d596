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

#ifndef OMPL_MFA_BENCHMARK_RUN_JOURNAL_
#define OMPL_MFA_BENCHMARK_RUN_JOURNAL_

#include <filesystem>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/RunRecord.h"

namespace ompl_mfa
{
    /** \brief The first line of a journal: which campaign its runs are of. */
    struct JournalHeader
    {
        /** \brief Campaign::fingerprint(). */
        std::string campaign;
        /** \brief "i/n", or empty for a whole campaign. */
        std::string shard;
        /** \brief When the campaign was started for the first time. */
        std::string start;
        /** \brief Seconds spent on the runs so far. */
        double duration{0.0};
    };

    /** \brief The runs of a campaign as they come in, in a file that survives the end of the program at any point.

        A text file with a line of JSON for the header and one for each run; a line is on the disk before append()
        returns. A last line that was cut off is dropped. */
    class OMPL_MFA_EXPORT RunJournal
    {
    public:
        /** \brief Starts a journal, replacing \e file. Throws InputError when it cannot be written or
            is in use. */
        RunJournal(std::filesystem::path file, JournalHeader header);

        /** \brief Opens a journal to continue it. Throws InputError when \e file cannot be read, is no journal or
            is in use. */
        explicit RunJournal(std::filesystem::path file);

        ~RunJournal();

        RunJournal(const RunJournal &) = delete;
        RunJournal &operator=(const RunJournal &) = delete;

        /** \brief Adds a run that ended \e duration seconds after the previous one, or after the start. Throws
            std::system_error when the disk is full. */
        void append(RunRecord record, double duration);

        const JournalHeader &header() const;

        /** \brief All runs, in the order in which they ended. */
        const std::vector<RunRecord> &records() const;

        /** \brief Reads only the header of \e file. Throws InputError when there is none. */
        static JournalHeader readHeader(const std::filesystem::path &file);

    private:
        void readRecords();
        void truncate(std::size_t size);
        void appendLine(const std::string &line);

        std::filesystem::path path_;
        JournalHeader header_;
        std::vector<RunRecord> records_;
        int file_{-1};
    };
}  // namespace ompl_mfa

#endif
