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

#include "paper/StudyRuns.h"

#include <unistd.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <locale>
#include <map>

#include "campaign/Campaign.h"
#include "campaign/Digest.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::paper
{
    namespace
    {
        using campaign::RunProcess;
        using campaign::RunTermination;

        std::string nameOf(const Json &key)
        {
            std::string name;
            for (const auto &field : key.items())
            {
                name += (name.empty() ? "" : ", ") +
                        (field.value().is_string() ? field.value().get<std::string>() : field.value().dump());
            }
            return name;
        }

        campaign::Task makeTask(const StudyRun &run)
        {
            campaign::Task task;
            task.key = run.key;
            task.name = nameOf(run.key);
            task.group = run.key.at("algorithm");
            task.makeWork = [make = run.make, name = task.name]
            {
                campaign::Work work;
                work.state = campaign::makeShared<campaign::RunState>();
                // Runs are limited by evaluations instead of time.
                work.limits.prepare = std::numeric_limits<double>::infinity();
                work.body = [make] { return campaign::jsonLine(make()); };
                work.report = [name](const RunProcess &process)
                {
                    if (process.termination() != RunTermination::Returned)
                    {
                        throw std::runtime_error(name + ": " +
                                                 describeTermination(process.termination(), process.signal()) +
                                                 (process.lastLine().empty() ? "" : ": " + process.lastLine()));
                    }
                    return campaign::RunReport{campaign::parseJson(process.result()), "made", false};
                };
                return work;
            };
            return task;
        }
    }  // namespace

    std::vector<Json> makeStudyRuns(const StudyOptions &options, const std::string &part, const std::string &identity,
                                    const std::vector<StudyRun> &runs)
    {
        std::vector<campaign::Task> tasks;
        std::map<std::string, std::size_t> places;
        for (const StudyRun &run : runs)
        {
            places[campaign::jsonLine(run.key)] = tasks.size();
            tasks.push_back(makeTask(run));
        }
        campaign::RunOptions runOptions;
        runOptions.journal = options.outputFolder + "/" + part + ".journal";
        runOptions.jobs = options.jobs;
        runOptions.resume = options.resume;
        runOptions.overwrite = options.overwrite;
        runOptions.terminal = isatty(STDERR_FILENO) != 0;
        runOptions.progress = runOptions.terminal ? &std::cerr : nullptr;
        campaign::JournalHeader header;
        header.campaign = part + " " + campaign::digestOf({OMPL_MFA_VERSION, identity});
        const campaign::RunsMade made = campaign::makeRuns(header, tasks, runOptions);
        if (made.interruptedBy != 0)
        {
            throw Interrupted(made.interruptedBy, std::to_string(made.missing) + " runs of '" + part +
                                                      "' are still to be made; --resume continues");
        }

        std::vector<Json> results(runs.size());
        campaign::readJournal(runOptions.journal,
                              [&](const Json &record, std::size_t)
                              {
                                  Json key;
                                  for (const auto &field : runs.front().key.items())
                                  {
                                      key[field.key()] = record.at(field.key());
                                  }
                                  const auto place = places.find(campaign::jsonLine(key));
                                  if (place != places.end())
                                  {
                                      results[place->second] = record;
                                  }
                              });
        return results;
    }

    std::ofstream openTable(const StudyOptions &options, const std::string &name, const std::string &header)
    {
        std::ofstream out(options.outputFolder + "/" + name);
        if (!out)
        {
            throw InputError("cannot write '" + options.outputFolder + "/" + name + "'");
        }
        out.imbue(std::locale::classic());
        out << std::setprecision(10) << header << "\n";
        return out;
    }

    Json numberToJson(double value)
    {
        return std::isfinite(value) ? Json(value) : Json(text::numberText(value));
    }

    double numberFrom(const Json &value)
    {
        double number = 0.0;
        if (!value.is_string())
        {
            return value.get<double>();
        }
        if (!text::readNumber(value.get<std::string>(), number))
        {
            throw std::invalid_argument("not a number: " + value.get<std::string>());
        }
        return number;
    }
}  // namespace ompl_mfa::paper
