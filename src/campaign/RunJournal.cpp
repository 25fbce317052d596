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

#include "campaign/RunJournal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "ompl_mfa/InputError.h"
#include "text/CLocaleScope.h"

namespace ompl_mfa::campaign
{
    namespace
    {
        std::string headerLine(const JournalHeader &header)
        {
            return jsonLine({{"campaign", header.campaign},
                             {"shard", header.shard},
                             {"start", header.start},
                             {"description", header.description}});
        }

        JournalHeader headerFrom(const std::string &line, const std::filesystem::path &file)
        {
            try
            {
                const Json json = parseJson(line);
                JournalHeader header;
                json.at("campaign").get_to(header.campaign);
                json.at("shard").get_to(header.shard);
                json.at("start").get_to(header.start);
                header.description = json.at("description");
                return header;
            }
            catch (const Json::exception &)
            {
                throw InputError(file.string() + ":1: not the first line of a campaign's journal");
            }
        }

        /* Opens and locks a journal for appending. The runs of a campaign that was just killed hold its lock until they
           have ended too, so locking is retried. */
        int lockJournal(const std::filesystem::path &file, int flags)
        {
            constexpr int ATTEMPTS = 40;
            const int opened = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666);
            if (opened < 0)
            {
                throw InputError(file.string() + ": cannot be written: " + std::strerror(errno));
            }
            for (int attempt = 0; flock(opened, LOCK_EX | LOCK_NB) != 0; ++attempt)
            {
                if (attempt == ATTEMPTS)
                {
                    ::close(opened);
                    throw InputError(file.string() + ": in use by another campaign");
                }
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
            }
            return opened;
        }

        /* The header of a journal, and the number of bytes in complete lines of its file. */
        std::pair<JournalHeader, std::size_t> readLines(const std::filesystem::path &file, const RecordVisitor &visit)
        {
            std::ifstream in(file);
            if (!in)
            {
                throw InputError(file.string() + ": cannot be read: " + std::strerror(errno));
            }
            std::string line;
            if (!std::getline(in, line) || in.eof())
            {
                line.clear();
            }
            std::pair<JournalHeader, std::size_t> journal(headerFrom(line, file), line.size() + 1);
            // A line without its end was truncated: the run is repeated.
            for (std::size_t number = 2; std::getline(in, line) && !in.eof(); ++number)
            {
                try
                {
                    const Json record = parseJson(line);
                    journal.first.duration += record.at("duration").get<double>();
                    visit(record, number);
                }
                catch (const Json::exception &error)
                {
                    throw InputError(file.string() + ":" + std::to_string(number) + ": not a run: " + error.what());
                }
                catch (const std::invalid_argument &error)
                {
                    throw InputError(file.string() + ":" + std::to_string(number) + ": " + error.what());
                }
                journal.second += line.size() + 1;
            }
            return journal;
        }
    }  // namespace

    JournalHeader readJournal(const std::filesystem::path &file, const RecordVisitor &visit)
    {
        return readLines(file, visit).first;
    }

    RunJournal::RunJournal(std::filesystem::path file, JournalHeader header)
      : path_(std::move(file))
      , header_(std::move(header))
      , file_(lockJournal(path_, O_CREAT))
    {
        truncate(0);
        header_.duration = 0.0;
        appendLine(headerLine(header_));
    }

    RunJournal::RunJournal(std::filesystem::path file, const RecordVisitor &visit)
      : path_(std::move(file))
      , file_(lockJournal(path_, 0))
    {
        try
        {
            const auto journal = readLines(path_, visit);
            header_ = journal.first;
            truncate(journal.second);
        }
        catch (...)
        {
            ::close(file_);
            throw;
        }
    }

    void RunJournal::truncate(std::size_t size)
    {
        if (ftruncate(file_, static_cast<off_t>(size)) != 0)
        {
            throw InputError(path_.string() + ": cannot be written: " + std::strerror(errno));
        }
    }

    RunJournal::~RunJournal()
    {
        ::close(file_);
    }

    void RunJournal::append(Json record, double duration)
    {
        record["duration"] = duration;
        appendLine(jsonLine(record));
        header_.duration += duration;
    }

    const JournalHeader &RunJournal::header() const
    {
        return header_;
    }

    void RunJournal::appendLine(const std::string &line)
    {
        const std::string text = line + '\n';
        std::size_t written = 0;
        while (written < text.size())
        {
            const ssize_t count = ::write(file_, text.data() + written, text.size() - written);
            if (count < 0 && errno != EINTR)
            {
                throw std::system_error(errno, std::generic_category(), path_.string());
            }
            written += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        fsync(file_);
    }

    std::string jsonLine(const Json &value)
    {
        return value.dump(-1, ' ', false, Json::error_handler_t::replace);
    }

    Json parseJson(const std::string &line)
    {
        // The JSON library reads numbers with strtod().
        const text::CLocaleScope plainNumbers;
        return Json::parse(line);
    }
}  // namespace ompl_mfa::campaign
