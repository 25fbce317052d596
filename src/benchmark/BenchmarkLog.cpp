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

#include "ompl_mfa/benchmark/BenchmarkLog.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>
#include <set>

#include "benchmark/LogText.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        void writeBlock(std::ostream &out, const std::string &text)
        {
            out << "<<<|\n" << text << (text.empty() || text.back() == '\n' ? "" : "\n") << "|>>>\n";
        }

        void writeHeader(std::ostream &out, const BenchmarkLog &log)
        {
            out << "OMPL version " << log.version << "\n"
                << "Experiment " << oneWord(log.experiment) << "\n"
                << log.properties.size() << " experiment properties\n";
            for (const auto &property : log.properties)
            {
                out << property.first << " = " << cleanValue(property.second) << "\n";
            }
            out << "Running on " << oneWord(log.host) << "\n"
                << "Starting at " << log.start << "\n";
            writeBlock(out, log.setup);
            writeBlock(out, log.cpu);
            out << log.seed << " is the random seed\n"
                << text::numberText(log.timeLimit, LOG_DIGITS) << " seconds per run\n"
                << text::numberText(log.memoryLimit, LOG_DIGITS) << " MB per run\n"
                << log.runCount << " runs per planner\n"
                << text::numberText(log.duration, LOG_DIGITS) << " seconds spent to collect the data\n"
                << log.enums.size() << " enum type" << (log.enums.size() == 1 ? "" : "s") << "\n";
            for (const LogEnum &entry : log.enums)
            {
                out << entry.property;
                for (const std::string &name : entry.names)
                {
                    out << "|" << name;
                }
                out << "\n";
            }
        }

        void writeRuns(std::ostream &out, const PlannerLog &planner)
        {
            const std::set<std::string> names = propertyNames(planner);
            out << names.size() << " properties for each run\n";
            for (const std::string &name : names)
            {
                out << name << "\n";
            }
            out << planner.runs.size() << " runs\n";
            for (const LogProperties &run : planner.runs)
            {
                for (const std::string &name : names)
                {
                    const auto found = run.find(name);
                    out << (found != run.end() ? cleanValue(found->second) : "") << "; ";
                }
                out << "\n";
            }
        }

        void writeProgress(std::ostream &out, const PlannerLog &planner)
        {
            out << planner.progressNames.size() + 1 << " progress properties for each run\ntime REAL\n";
            for (const std::string &name : planner.progressNames)
            {
                out << name << "\n";
            }
            out << planner.progress.size() << " runs\n";
            for (const auto &samples : planner.progress)
            {
                std::string last;
                for (const ProgressSample &sample : samples)
                {
                    const std::string time = progressTime(sample.time);
                    if (time == last)
                    {
                        continue;
                    }
                    last = time;
                    out << time << ",";
                    for (const std::string &value : sample.values)
                    {
                        out << cleanValue(value) << ",";
                    }
                    out << ";";
                }
                out << "\n";
            }
        }
    }  // namespace

    void writeBenchmarkLog(std::ostream &out, const BenchmarkLog &log)
    {
        const text::PlainNumbers plainNumbers(out);
        writeHeader(out, log);
        out << log.planners.size() << " planners\n";
        for (const PlannerLog &planner : log.planners)
        {
            out << planner.name << "\n" << planner.common.size() << " common properties\n";
            for (const auto &property : planner.common)
            {
                out << property.first << " = " << property.second << "\n";
            }
            writeRuns(out, planner);
            if (!planner.progress.empty())
            {
                writeProgress(out, planner);
            }
            out << ".\n";
        }
    }

    void writeBenchmarkLog(const std::filesystem::path &file, const BenchmarkLog &log)
    {
        const std::filesystem::path unfinished = file.string() + ".unfinished";
        std::ofstream out(unfinished);
        writeBenchmarkLog(out, log);
        out.close();
        std::error_code failed;
        if (out)
        {
            std::filesystem::rename(unfinished, file, failed);
        }
        if (!out || failed)
        {
            throw InputError(file.string() + ": cannot be written: " + std::strerror(errno));
        }
    }
}  // namespace ompl_mfa::benchmark
