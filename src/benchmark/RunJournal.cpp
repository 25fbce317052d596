#include "ompl_mfa/benchmark/RunJournal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "ompl_mfa/InputError.h"

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
    {
        file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
        if (file_ < 0)
        {
            throw InputError(path_.string() + ": cannot be written: " + std::strerror(errno));
        }
        appendLine(headerLine(header_));
    }

    RunJournal::RunJournal(std::filesystem::path file)
      : path_(std::move(file))
    {
        std::ifstream in = openJournal(path_);
        std::string line;
        std::getline(in, line);
        header_ = headerFrom(line, path_);
        // A line without its end was cut off: the run is made again.
        auto whole = static_cast<std::uintmax_t>(in.eof() ? 0 : line.size() + 1);
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
        in.close();
        std::error_code failed;
        std::filesystem::resize_file(path_, whole, failed);
        file_ = open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
        if (failed || file_ < 0)
        {
            throw InputError(path_.string() + ": cannot be written: " + std::strerror(errno));
        }
        if (whole == 0)
        {
            appendLine(headerLine(header_));
        }
    }

    RunJournal::~RunJournal()
    {
        ::close(file_);
    }

    void RunJournal::append(RunRecord record, double duration)
    {
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
