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

#include <cerrno>
#include <cstring>
#include <fstream>
#include <istream>
#include <utility>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "text/NumberText.h"

namespace ompl_mfa
{
    namespace
    {
        /* Reads a log line by line and knows where it is when something is wrong. */
        class LogReader
        {
        public:
            LogReader(std::istream &in, std::string name)
              : in_(in)
              , name_(std::move(name))
            {
            }

            std::string line()
            {
                std::string text;
                if (!std::getline(in_, text))
                {
                    fail("the log ends here");
                }
                ++number_;
                return text;
            }

            /* The rest of a line that begins with \e start. */
            std::string after(const std::string &start)
            {
                const std::string text = line();
                if (text.compare(0, start.size(), start) != 0)
                {
                    fail("expected '" + start + "', found '" + text.substr(0, 60) + "'");
                }
                return text.substr(start.size());
            }

            /* The number with which a line begins that goes on with \e words. */
            double number(const std::string &words)
            {
                return numberIn(line(), words);
            }

            /* As number(), of a line that was read before. */
            double numberIn(const std::string &text, const std::string &words) const
            {
                const std::size_t end = text.find(' ');
                double value = 0.0;
                if (!readNumber(text.substr(0, end), value) || end == std::string::npos ||
                    text.compare(end + 1, words.size(), words) != 0)
                {
                    fail("expected a number and '" + words + "', found '" + text.substr(0, 60) + "'");
                }
                return value;
            }

            std::size_t count(const std::string &words)
            {
                return countIn(line(), words);
            }

            /* As count(), of a line that was read before. */
            std::size_t countIn(const std::string &text, const std::string &words) const
            {
                const double value = numberIn(text, words);
                if (!(value >= 0.0 && value < 1e9))
                {
                    fail("not a number of things");
                }
                return static_cast<std::size_t>(value);
            }

            std::string block()
            {
                after("<<<|");
                std::string text;
                for (std::string next = line(); next.compare(0, 4, "|>>>") != 0; next = line())
                {
                    text += next + "\n";
                }
                return text;
            }

            std::pair<std::string, std::string> property()
            {
                const std::string text = line();
                const std::size_t middle = text.find(" = ");
                if (middle == std::string::npos)
                {
                    fail("expected 'NAME = VALUE', found '" + text.substr(0, 60) + "'");
                }
                return {text.substr(0, middle), text.substr(middle + 3)};
            }

            LogProperties properties(std::size_t count)
            {
                LogProperties properties;
                for (std::size_t i = 0; i < count; ++i)
                {
                    properties.insert(property());
                }
                return properties;
            }

            [[noreturn]] void fail(const std::string &what) const
            {
                throw InputError(name_ + ":" + std::to_string(number_) + ": " + what);
            }

        private:
            std::istream &in_;
            std::string name_;
            int number_{0};
        };

        std::vector<std::string> split(const std::string &text, const std::string &separator)
        {
            std::vector<std::string> parts;
            std::size_t first = 0;
            for (std::size_t next = 0; (next = text.find(separator, first)) != std::string::npos;)
            {
                parts.push_back(text.substr(first, next - first));
                first = next + separator.size();
            }
            parts.push_back(text.substr(first));
            return parts;
        }

        std::vector<std::string> readNames(LogReader &reader, std::size_t count)
        {
            std::vector<std::string> names;
            for (std::size_t i = 0; i < count; ++i)
            {
                names.push_back(reader.line());
            }
            return names;
        }

        LogProperties readRun(LogReader &reader, const std::vector<std::string> &names)
        {
            const std::vector<std::string> values = split(reader.line(), "; ");
            if (values.size() != names.size() + 1)
            {
                reader.fail("expected " + std::to_string(names.size()) + " values, found " +
                            std::to_string(values.size() - 1));
            }
            LogProperties run;
            for (std::size_t i = 0; i < names.size(); ++i)
            {
                if (!values[i].empty())
                {
                    run[names[i]] = values[i];
                }
            }
            return run;
        }

        std::vector<ProgressSample> readSamples(LogReader &reader, const std::vector<std::string> &names,
                                                std::size_t timeColumn)
        {
            std::vector<ProgressSample> samples;
            const std::vector<std::string> texts = split(reader.line(), ";");
            for (std::size_t i = 0; i + 1 < texts.size(); ++i)
            {
                std::vector<std::string> values = split(texts[i], ",");
                if (values.size() != names.size() + 1)
                {
                    reader.fail("expected " + std::to_string(names.size()) + " values in a sample, found " +
                                std::to_string(values.size() - 1));
                }
                values.pop_back();
                double time = 0.0;
                if (!readNumber(values[timeColumn], time))
                {
                    reader.fail("expected the time of a sample, found '" + values[timeColumn] + "'");
                }
                values.erase(values.begin() + static_cast<std::ptrdiff_t>(timeColumn));
                samples.push_back({time, std::move(values)});
            }
            return samples;
        }

        void readProgress(LogReader &reader, const std::string &countLine, PlannerLog &planner)
        {
            std::vector<std::string> names =
                readNames(reader, reader.countIn(countLine, "progress properties for each run"));
            std::size_t timeColumn = 0;
            while (timeColumn < names.size() && names[timeColumn] != "time REAL")
            {
                ++timeColumn;
            }
            if (timeColumn == names.size())
            {
                reader.fail("no 'time REAL' among the progress properties");
            }
            const std::size_t runs = reader.count("runs");
            for (std::size_t i = 0; i < runs; ++i)
            {
                planner.progress.push_back(readSamples(reader, names, timeColumn));
            }
            names.erase(names.begin() + static_cast<std::ptrdiff_t>(timeColumn));
            planner.progressNames = std::move(names);
        }

        PlannerLog readPlanner(LogReader &reader)
        {
            PlannerLog planner;
            planner.name = reader.line();
            planner.common = reader.properties(reader.count("common properties"));
            const std::vector<std::string> names = readNames(reader, reader.count("properties for each run"));
            const std::size_t runs = reader.count("runs");
            for (std::size_t i = 0; i < runs; ++i)
            {
                planner.runs.push_back(readRun(reader, names));
            }
            const std::string next = reader.line();
            if (next != ".")
            {
                readProgress(reader, next, planner);
                reader.after(".");
            }
            return planner;
        }
    }  // namespace

    BenchmarkLog readBenchmarkLog(std::istream &in, const std::string &name)
    {
        LogReader reader(in, name);
        BenchmarkLog log;
        log.version = reader.after("OMPL version ");
        log.experiment = reader.after("Experiment ");
        log.properties = reader.properties(reader.count("experiment properties"));
        log.host = reader.after("Running on ");
        log.start = reader.after("Starting at ");
        log.setup = reader.block();
        log.cpu = reader.block();
        log.seed = static_cast<std::uint64_t>(reader.number("is the random seed"));
        log.timeLimit = reader.number("seconds per run");
        log.memoryLimit = reader.number("MB per run");
        log.runCount = static_cast<unsigned int>(reader.count("runs per planner"));
        log.duration = reader.number("seconds spent to collect the data");
        const std::size_t enums = reader.count("enum type");
        for (std::size_t i = 0; i < enums; ++i)
        {
            std::vector<std::string> names = split(reader.line(), "|");
            const std::string property = names.front();
            names.erase(names.begin());
            log.enums.push_back({property, std::move(names)});
        }
        const std::size_t planners = reader.count("planners");
        for (std::size_t i = 0; i < planners; ++i)
        {
            log.planners.push_back(readPlanner(reader));
        }
        return log;
    }

    BenchmarkLog readBenchmarkLog(const std::filesystem::path &file)
    {
        std::ifstream in(file);
        if (!in)
        {
            throw InputError(file.string() + ": cannot be read: " + std::strerror(errno));
        }
        return readBenchmarkLog(in, file.string());
    }
}  // namespace ompl_mfa
