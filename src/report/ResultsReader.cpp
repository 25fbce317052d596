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

#include "report/ResultsReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>

#include "benchmark/CampaignMerge.h"
#include "benchmark/LogText.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        const std::string DATABASE_BEGIN = "SQLite format 3";
        const std::string LOG_BEGIN = "OMPL version";

        std::string beginOf(const std::string &file)
        {
            std::ifstream in(file, std::ios::binary);
            std::string begin(DATABASE_BEGIN.size(), '\0');
            in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
            if (!in.is_open() || in.bad() || in.gcount() == 0)
            {
                throw InputError(file + ": cannot be read, or is empty");
            }
            begin.resize(static_cast<std::size_t>(in.gcount()));
            return begin;
        }

        std::string describeFiles(const Experiment &experiment)
        {
            std::string text;
            for (const std::string &file : experiment.files)
            {
                text += (text.empty() ? "" : ", ") + file;
            }
            return text;
        }

        /* "path cost REAL" is path_cost in databases. */
        std::string columnName(const std::string &property)
        {
            std::string name = property.substr(0, property.rfind(' '));
            std::replace(name.begin(), name.end(), ' ', '_');
            return name;
        }

        RecordedRun recordedRun(const benchmark::PlannerLog &planner, std::size_t index)
        {
            RecordedRun run;
            for (const auto &[property, value] : planner.runs[index])
            {
                run.values[columnName(property)] = value;
            }
            const auto column = std::find(planner.progressNames.begin(), planner.progressNames.end(), "best cost REAL");
            if (column == planner.progressNames.end() || index >= planner.progress.size())
            {
                return run;
            }
            const auto place = static_cast<std::size_t>(column - planner.progressNames.begin());
            for (const benchmark::ProgressSample &sample : planner.progress[index])
            {
                double cost = 0.0;
                if (place < sample.values.size() && text::readNumber(sample.values[place], cost))
                {
                    run.progress.emplace_back(sample.time, cost);
                }
            }
            return run;
        }

        Experiment experimentOf(const benchmark::BenchmarkLog &log, const std::vector<std::string> &files)
        {
            Experiment experiment;
            // as logs and databases have it
            experiment.name = benchmark::oneWord(log.experiment);
            experiment.files = files;
            experiment.version = "OMPL " + log.version;
            const auto program = log.properties.find("ompl_mfa_version TEXT");
            if (program != log.properties.end())
            {
                experiment.version += ", ompl_mfa " + program->second;
            }
            experiment.host = log.host;
            experiment.cpu = processorIn(log.cpu);
            experiment.start = log.start;
            experiment.seed = std::to_string(log.seed);
            experiment.objective = objectiveIn(log.setup);
            experiment.timeLimit = log.timeLimit;
            experiment.memoryLimit = log.memoryLimit;
            for (const benchmark::PlannerLog &planner : log.planners)
            {
                PlannerResults results{plainPlannerName(planner.name), {}};
                for (std::size_t i = 0; i < planner.runs.size(); ++i)
                {
                    results.runs.push_back(makeRunResult(recordedRun(planner, i), log.timeLimit));
                }
                experiment.planners.push_back(results);
            }
            return experiment;
        }

        /* Journals, of which some may be shards of the same campaign. */
        class Journals
        {
        public:
            void add(const std::string &file)
            {
                benchmark::CampaignRuns runs = benchmark::readCampaignRuns(file);
                const auto known = std::find_if(
                    groups_.begin(), groups_.end(),
                    [&](const Group &group) { return group.parts.front().header.campaign == runs.header.campaign; });
                Group &group = known != groups_.end() ? *known : groups_.emplace_back();
                group.parts.push_back(std::move(runs));
                group.files.push_back(file);
            }

            void addTo(std::vector<Experiment> &experiments) const
            {
                for (const Group &group : groups_)
                {
                    const benchmark::CampaignRuns joined = benchmark::mergeRuns(group.parts, group.files, true);
                    experiments.push_back(experimentOf(benchmark::assembleLog(joined), group.files));
                }
            }

        private:
            struct Group
            {
                std::vector<benchmark::CampaignRuns> parts;
                std::vector<std::string> files;
            };

            std::vector<Group> groups_;
        };

        /* The journal of a log, or the journal itself. */
        std::string journalOf(const std::string &file, const std::string &begin)
        {
            if (begin.front() == '{')
            {
                return file;
            }
            std::string journal = benchmark::Campaign::journalFile(file).string();
            if (std::ifstream(journal).is_open())
            {
                return journal;
            }
            if (begin.compare(0, LOG_BEGIN.size(), LOG_BEGIN) == 0)
            {
                throw InputError(file + ": logs are read from their journals, and there is no " + journal +
                                 "; a database that ompl_benchmark_statistics makes of the log is accepted");
            }
            throw InputError(file +
                             ": unknown kind of file; accepted are journals and logs of 'ompl_mfa benchmark' "
                             "and SQLite databases of ompl_benchmark_statistics");
        }

        void requireSame(const Experiment &first, const Experiment &other, const std::string &what,
                         const std::string &firstValue, const std::string &otherValue)
        {
            if (firstValue != otherValue)
            {
                throw InputError("experiment " + first.name + " has " + what + " " + firstValue + " in " +
                                 describeFiles(first) + " and " + otherValue + " in " + describeFiles(other) +
                                 ": such runs cannot be compared");
            }
        }

        void join(Experiment &first, const Experiment &other)
        {
            requireSame(first, other, "seed", first.seed, other.seed);
            requireSame(first, other, "time limit", text::numberText(first.timeLimit),
                        text::numberText(other.timeLimit));
            requireSame(first, other, "memory limit", text::numberText(first.memoryLimit),
                        text::numberText(other.memoryLimit));
            for (const PlannerResults &planner : other.planners)
            {
                if (std::any_of(first.planners.begin(), first.planners.end(),
                                [&](const PlannerResults &known) { return known.name == planner.name; }))
                {
                    throw InputError("planner " + planner.name + " of experiment " + first.name + " is in " +
                                     describeFiles(first) + " and again in " + describeFiles(other) +
                                     ": give only one of them");
                }
                first.planners.push_back(planner);
            }
            const auto addText = [](std::string &text, const std::string &further)
            {
                if (text != further && !further.empty())
                {
                    text += (text.empty() ? "" : "; ") + further;
                }
            };
            addText(first.version, other.version);
            addText(first.host, other.host);
            addText(first.cpu, other.cpu);
            addText(first.start, other.start);
            for (const std::string &file : other.files)
            {
                if (std::find(first.files.begin(), first.files.end(), file) == first.files.end())
                {
                    first.files.push_back(file);
                }
            }
        }

        /* Run k has the same seed for all planners. */
        void requireCommonSeeds(const Experiment &experiment)
        {
            std::map<std::string, std::pair<std::string, std::string>> seeds;
            for (const PlannerResults &planner : experiment.planners)
            {
                for (const RunResult &run : planner.runs)
                {
                    if (run.run.empty() || run.seed.empty())
                    {
                        continue;
                    }
                    const auto &first = seeds.insert({run.run, {run.seed, planner.name}}).first->second;
                    if (first.first != run.seed)
                    {
                        throw InputError(describeFiles(experiment) + ": run " + run.run + " of experiment " +
                                         experiment.name + " has seed " + first.first + " for " + first.second +
                                         " and seed " + run.seed + " for " + planner.name);
                    }
                }
            }
        }

        /* OMPL's description of an objective says if larger values are better. */
        void requireMinimised(const Experiment &experiment)
        {
            if (experiment.objective.rfind("Maximi", 0) == 0)
            {
                throw InputError(describeFiles(experiment) + ": experiment " + experiment.name +
                                 " has the objective '" + experiment.objective +
                                 "'; only objectives that are minimised are accepted");
            }
        }

        void removeEmptyPlanners(Experiment &experiment)
        {
            auto &planners = experiment.planners;
            planners.erase(std::remove_if(planners.begin(), planners.end(),
                                          [](const PlannerResults &planner) { return planner.runs.empty(); }),
                           planners.end());
        }
    }  // namespace

    std::string objectiveIn(const std::string &setup)
    {
        const std::string begin = "Optimization Objective: ";
        const std::size_t found = setup.find(begin);
        if (found == std::string::npos)
        {
            return "";
        }
        const std::size_t start = found + begin.size();
        const std::string line = setup.substr(start, setup.find('\n', start) - start);
        return trimmed(line.substr(0, line.find(" @")));
    }

    std::string processorIn(const std::string &cpu)
    {
        for (const std::string begin : {"Model name:", "model name"})
        {
            const std::size_t found = cpu.find(begin);
            if (found != std::string::npos)
            {
                const std::size_t start = found + begin.size();
                const std::string model = trimmed(cpu.substr(start, cpu.find('\n', start) - start));
                return trimmed(model.substr(model.front() == ':' ? 1 : 0));
            }
        }
        return trimmed(oneLine(cpu));
    }

    std::string plainPlannerName(const std::string &name)
    {
        for (const std::string begin : {"geometric_", "control_"})
        {
            if (name.compare(0, begin.size(), begin) == 0 && name.size() > begin.size())
            {
                return name.substr(begin.size());
            }
        }
        return name;
    }

    std::vector<Experiment> readResults(const std::vector<std::string> &files)
    {
        std::vector<Experiment> read;
        Journals journals;
        for (const std::string &file : files)
        {
            const std::string begin = beginOf(file);
            if (begin == DATABASE_BEGIN)
            {
                const std::vector<Experiment> further = readDatabase(file);
                read.insert(read.end(), further.begin(), further.end());
            }
            else
            {
                journals.add(journalOf(file, begin));
            }
        }
        journals.addTo(read);

        std::vector<Experiment> experiments;
        for (Experiment &experiment : read)
        {
            removeEmptyPlanners(experiment);
            if (experiment.planners.empty())
            {
                continue;
            }
            const auto known = std::find_if(experiments.begin(), experiments.end(),
                                            [&](const Experiment &other) { return other.name == experiment.name; });
            known == experiments.end() ? experiments.push_back(experiment) : join(*known, experiment);
        }
        if (experiments.empty())
        {
            throw InputError(files.front() + ": there are no runs" + (files.size() > 1 ? " in any of the files" : ""));
        }
        for (const Experiment &experiment : experiments)
        {
            requireCommonSeeds(experiment);
            requireMinimised(experiment);
        }
        return experiments;
    }
}  // namespace ompl_mfa::report
