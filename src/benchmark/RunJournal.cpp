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

#include "ompl_mfa/benchmark/RunJournal.h"

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

#include <nlohmann/json.hpp>

#include "ompl_mfa/InputError.h"
#include "text/CLocaleScope.h"

using Json = nlohmann::json;

namespace ompl_mfa
{
    namespace
    {
        std::string headerLine(const JournalHeader &header)
        {
            return Json{{"campaign", header.campaign}, {"shard", header.shard}, {"start", header.start}}.dump();
        }

        JournalHeader headerFrom(const std::string &line, const std::filesystem::path &file)
        {
            try
            {
                const Json json = Json::parse(line);
                JournalHeader header;
                json.at("campaign").get_to(header.campaign);
                json.at("shard").get_to(header.shard);
                json.at("start").get_to(header.start);
                return header;
            }
            catch (const Json::exception &)
            {
                throw InputError(file.string() + ": not the journal of a campaign");
            }
        }

        /* Opens a journal for appending. The runs of a campaign that was just killed hold its lock until they are dead
           too, so it is asked for more than once. */
        int lockJournal(const std::filesystem::path &file, int flags)
        {
            constexpr int ATTEMPTS = 40;
            const int opened = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666);
            if (opened < 0)
            {
                throw InputError(file.string() + (flags == 0 ? ": cannot be read: " : ": cannot be written: ") +
                                 std::strerror(errno));
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

        std::ifstream openJournal(const std::filesystem::path &file)
        {
            std::ifstream in(file);
            if (!in)
            {
                throw InputError(file.string() + ": cannot be read: " + std::strerror(errno));
            }
            return in;
        }
    }  // namespace

    RunJournal::RunJournal(std::filesystem::path file, JournalHeader header)
      : path_(std::move(file))
      , header_(std::move(header))
      , file_(lockJournal(path_, O_CREAT))
    {
        truncate(0);
        appendLine(headerLine(header_));
    }

    RunJournal::RunJournal(std::filesystem::path file)
      : path_(std::move(file))
      , file_(lockJournal(path_, 0))
    {
        try
        {
            readRecords();
        }
        catch (const InputError &)
        {
            ::close(file_);
            throw;
        }
    }

    void RunJournal::readRecords()
    {
        const CLocaleScope plainNumbers;
        std::ifstream in = openJournal(path_);
        std::string line;
        std::getline(in, line);
        header_ = headerFrom(line, path_);
        std::size_t whole = line.size() + 1;
        // A line without its end was cut off: the run is made again.
        for (int number = 2; std::getline(in, line) && !in.eof(); ++number)
        {
            try
            {
                records_.push_back(readRunRecord(line));
                header_.duration += Json::parse(line).at("duration").get<double>();
            }
            catch (const std::exception &error)
            {
                throw InputError(path_.string() + ":" + std::to_string(number) + ": " + error.what());
            }
            whole += line.size() + 1;
        }
        truncate(whole);
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

    void RunJournal::append(RunRecord record, double duration)
    {
        const CLocaleScope plainNumbers;
        Json line = Json::parse(writeRunRecord(record));
        line["duration"] = duration;
        appendLine(line.dump());
        header_.duration += duration;
        records_.push_back(std::move(record));
    }

    const JournalHeader &RunJournal::header() const
    {
        return header_;
    }

    const std::vector<RunRecord> &RunJournal::records() const
    {
        return records_;
    }

    JournalHeader RunJournal::readHeader(const std::filesystem::path &file)
    {
        std::ifstream in = openJournal(file);
        std::string line;
        std::getline(in, line);
        return headerFrom(line, file);
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
}  // namespace ompl_mfa
