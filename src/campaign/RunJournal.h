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

#ifndef OMPL_MFA_CAMPAIGN_RUN_JOURNAL_
#define OMPL_MFA_CAMPAIGN_RUN_JOURNAL_

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::campaign
{
    using Json = nlohmann::ordered_json;

    /** \brief The first line of a journal, which identifies its campaign. */
    struct JournalHeader
    {
        /** \brief Journals with the same identity hold runs of the same campaign. */
        std::string campaign;
        /** \brief "i/n", or empty for a whole campaign. */
        std::string shard;
        /** \brief Time at which the campaign was first started. */
        std::string start;
        /** \brief Data common to all runs. */
        Json description;
        /** \brief Seconds spent on the runs so far; in a file, the sum over its runs. */
        double duration{0.0};
    };

    /** \brief Called with a run of a journal and its line number. */
    using RecordVisitor = std::function<void(const Json &record, std::size_t line)>;

    /** \brief Reads a journal and passes each of its runs to \e visit, in the order in which they ended; a truncated
        last line is ignored. Throws InputError if \e file cannot be read or is not a journal; a std::invalid_argument
        or an exception of the JSON library thrown by \e visit becomes an InputError "FILE:LINE: ...". */
    OMPL_MFA_EXPORT JournalHeader readJournal(const std::filesystem::path &file, const RecordVisitor &visit);

    /** \brief The finished runs of a campaign, in a file that remains valid if the program ends at any point.

        A text file with one JSON object per line, first the header and then one per run; a line is on the disk before
        append() returns. A truncated last line is removed. */
    class OMPL_MFA_EXPORT RunJournal
    {
    public:
        /** \brief Starts a journal, replacing \e file. Throws InputError if it cannot be written or
            is in use. */
        RunJournal(std::filesystem::path file, JournalHeader header);

        /** \brief Opens a journal to continue it; its runs are passed to \e visit. Throws InputError as readJournal()
            does, and if \e file cannot be written or is in use. */
        RunJournal(std::filesystem::path file, const RecordVisitor &visit);

        ~RunJournal();

        RunJournal(const RunJournal &) = delete;
        RunJournal &operator=(const RunJournal &) = delete;

        /** \brief Adds a run that ended \e duration seconds after the previous one, or after the start; stored in its
            field `duration`. Throws std::system_error if the disk is full. */
        void append(Json record, double duration);

        const JournalHeader &header() const;

    private:
        void truncate(std::size_t size);
        void appendLine(const std::string &line);

        std::filesystem::path path_;
        JournalHeader header_;
        int file_{-1};
    };

    /** \brief \e value as a line of JSON without its end. Invalid UTF-8, which a run may have printed, is replaced. */
    OMPL_MFA_EXPORT std::string jsonLine(const Json &value);

    /** \brief Reverse of jsonLine(), in any locale. Throws an exception of the JSON library for invalid text. */
    OMPL_MFA_EXPORT Json parseJson(const std::string &line);
}  // namespace ompl_mfa::campaign

#endif
