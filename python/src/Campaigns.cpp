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

#include "Module.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include <pybind11/stl.h>

#include "benchmark/CampaignLog.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "text/NumberText.h"

namespace py = pybind11;

namespace ompl_mfa::python
{
    namespace
    {
        /* Runs a campaign in this process, which must have one thread. */
        void runCampaign(const std::string &file, const std::string &log, unsigned int jobs, bool resume,
                         bool overwrite, const std::string &database)
        {
            const benchmark::BenchmarkConfig config = benchmark::readBenchmarkConfig(file);
            const benchmark::Campaign campaign = benchmark::makeCampaign(config);
            campaign.validate();
            benchmark::CampaignOptions options;
            options.log = log;
            options.database = database;
            options.jobs = jobs;
            options.resume = resume;
            options.overwrite = overwrite;
            const benchmark::CampaignResult result = campaign.run(options);
            if (result.interruptedBy != 0)
            {
                PyErr_SetNone(PyExc_KeyboardInterrupt);
                throw py::error_already_set();
            }
        }

        /* The name of a column for the property "words TYPE". */
        std::string columnName(const std::string &property)
        {
            std::string name = property.substr(0, property.rfind(' '));
            for (char &letter : name)
            {
                letter = letter == ' ' ? '_' : letter;
            }
            return name;
        }

        /* A value of a property by the type at the end of its name; None if there is none. */
        py::object typedValue(const std::string &property, const std::string &value)
        {
            const std::string type = property.substr(property.rfind(' ') + 1);
            double number = 0.0;
            if (value.empty())
            {
                return py::none();
            }
            if (type == "BOOLEAN")
            {
                return py::bool_(value == "1");
            }
            if (type == "TEXT" || !text::readNumber(value, number))
            {
                return py::str(value);
            }
            if ((type == "INTEGER" || type == "ENUM") && std::isfinite(number))
            {
                return py::int_(static_cast<std::int64_t>(number));
            }
            return py::float_(number);
        }

        py::dict propertiesOf(const benchmark::LogProperties &properties)
        {
            py::dict values;
            for (const auto &property : properties)
            {
                values[py::str(columnName(property.first))] = typedValue(property.first, property.second);
            }
            return values;
        }

        /* Experiment, planners, runs and progress of a journal. */
        py::dict readJournal(const std::string &file)
        {
            std::filesystem::path journal(file);
            if (journal.extension() == ".log")
            {
                journal = benchmark::Campaign::journalFile(journal);
            }
            const benchmark::BenchmarkLog log = benchmark::assembleLog(benchmark::readCampaignRuns(journal));
            py::list runs;
            py::list progress;
            for (const benchmark::PlannerLog &planner : log.planners)
            {
                for (std::size_t i = 0; i < planner.runs.size(); ++i)
                {
                    py::dict run = propertiesOf(planner.runs[i]);
                    const py::str name(planner.name.substr(planner.name.find('_') + 1));
                    run["planner"] = name;
                    runs.append(run);
                    if (i >= planner.progress.size())
                    {
                        continue;
                    }
                    for (const benchmark::ProgressSample &sample : planner.progress[i])
                    {
                        py::dict row;
                        row["planner"] = name;
                        row["run"] = run["run"];
                        row["time"] = sample.time;
                        for (std::size_t j = 0; j < sample.values.size(); ++j)
                        {
                            row[py::str(columnName(planner.progressNames[j]))] =
                                typedValue(planner.progressNames[j], sample.values[j]);
                        }
                        progress.append(row);
                    }
                }
            }
            py::dict result;
            result["experiment"] = log.experiment;
            result["properties"] = propertiesOf(log.properties);
            result["time_limit"] = log.timeLimit;
            result["run_count"] = log.runCount;
            result["seed"] = log.seed;
            result["start"] = log.start;
            result["runs"] = runs;
            result["progress"] = progress;
            return result;
        }
    }  // namespace

    void bindCampaigns(py::module_ &module)
    {
        module.def("run_campaign", &runCampaign, py::arg("config"), py::arg("log"), py::arg("jobs"), py::arg("resume"),
                   py::arg("overwrite"), py::arg("database"));
        module.def("read_journal", &readJournal, py::arg("file"));
        module.def(
            "log_file",
            [](const std::string &config)
            { return benchmark::logFile(benchmark::readBenchmarkConfig(config), 1, 1).string(); },
            py::arg("config"));
    }
}  // namespace ompl_mfa::python
