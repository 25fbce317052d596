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

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "ompl_mfa/InputError.h"
#include "report/ResultsReader.h"
#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        /* Values of a row by the names of their columns in lower case; NULL is missing. */
        using Row = std::map<std::string, std::string>;

        class Database
        {
        public:
            explicit Database(const std::string &file)
              : file_(file)
            {
                sqlite3 *connection = nullptr;
                const int status = sqlite3_open_v2(file.c_str(), &connection, SQLITE_OPEN_READONLY, nullptr);
                connection_.reset(connection);
                require(status == SQLITE_OK);
            }

            /* Calls \e visit with each row of a query with one parameter. */
            template <typename Visit>
            void forEach(const std::string &sql, const std::string &parameter, const Visit &visit) const
            {
                sqlite3_stmt *prepared = nullptr;
                require(sqlite3_prepare_v2(connection_.get(), sql.c_str(), -1, &prepared, nullptr) == SQLITE_OK);
                const std::unique_ptr<sqlite3_stmt, Finalize> statement(prepared);
                require(sqlite3_bind_text(prepared, 1, parameter.c_str(), static_cast<int>(parameter.size()),
                                          SQLITE_TRANSIENT) == SQLITE_OK);
                int status = sqlite3_step(prepared);
                for (; status == SQLITE_ROW; status = sqlite3_step(prepared))
                {
                    visit(rowOf(prepared));
                }
                require(status == SQLITE_DONE);
            }

            bool hasColumn(const std::string &table, const std::string &column) const
            {
                bool found = false;
                forEach("SELECT 1 FROM pragma_table_info('" + table + "') WHERE name = ? COLLATE NOCASE", column,
                        [&found](const Row &) { found = true; });
                return found;
            }

            void requireTables() const
            {
                for (const char *table : {"experiments", "plannerConfigs", "runs"})
                {
                    bool found = false;
                    forEach("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ? COLLATE NOCASE", table,
                            [&found](const Row &) { found = true; });
                    if (!found)
                    {
                        throw InputError(file_ + ": has no table " + table +
                                         ", as databases of ompl_benchmark_statistics do");
                    }
                }
            }

        private:
            struct Close
            {
                void operator()(sqlite3 *connection) const
                {
                    sqlite3_close(connection);
                }
            };

            struct Finalize
            {
                void operator()(sqlite3_stmt *statement) const
                {
                    sqlite3_finalize(statement);
                }
            };

            static Row rowOf(sqlite3_stmt *statement)
            {
                Row row;
                for (int i = 0; i < sqlite3_column_count(statement); ++i)
                {
                    const bool isNumber = sqlite3_column_type(statement, i) == SQLITE_FLOAT;
                    const auto *text = sqlite3_column_text(statement, i);
                    if (text != nullptr)
                    {
                        // SQLite's own text of a number has only 15 digits
                        row[lowerCase(sqlite3_column_name(statement, i))] =
                            isNumber ? text::numberText(sqlite3_column_double(statement, i))
                                     : reinterpret_cast<const char *>(text);
                    }
                }
                return row;
            }

            void require(bool success) const
            {
                if (!success)
                {
                    throw InputError(file_ +
                                     ": cannot be read as a database of results: " + sqlite3_errmsg(connection_.get()));
                }
            }

            std::string file_;
            std::unique_ptr<sqlite3, Close> connection_;
        };

        std::string valueOf(const Row &row, const std::string &column)
        {
            const auto found = row.find(column);
            return found == row.end() ? "" : found->second;
        }

        double numberOf(const Row &row, const std::string &column, double unknown)
        {
            double value = unknown;
            text::readNumber(valueOf(row, column), value);
            return value;
        }

        Experiment experimentOf(const Row &row, const std::string &file)
        {
            Experiment experiment;
            experiment.name = valueOf(row, "name");
            experiment.files = {file};
            experiment.version = valueOf(row, "version");
            const std::string program = valueOf(row, "ompl_mfa_version");
            experiment.version += program.empty() ? "" : ", ompl_mfa " + program;
            experiment.host = valueOf(row, "hostname");
            experiment.cpu = processorIn(valueOf(row, "cpuinfo"));
            experiment.start = valueOf(row, "date");
            experiment.seed = valueOf(row, "seed");
            experiment.objective = objectiveIn(valueOf(row, "setup"));
            experiment.timeLimit = numberOf(row, "timelimit", 0.0);
            experiment.memoryLimit = numberOf(row, "memorylimit", 0.0);
            return experiment;
        }

        using Samples = std::vector<std::pair<double, double>>;

        /* Best costs over time by the ids of the runs of an experiment. */
        std::map<std::string, Samples> readProgress(const Database &database, const std::string &experiment)
        {
            std::map<std::string, Samples> progress;
            if (!database.hasColumn("progress", "best_cost"))
            {
                return progress;
            }
            database.forEach(
                "SELECT p.runid, p.time, p.best_cost FROM progress p JOIN runs r ON r.id = p.runid "
                "WHERE r.experimentid = ? AND p.best_cost IS NOT NULL ORDER BY p.runid, p.time",
                experiment,
                [&progress](const Row &row)
                {
                    constexpr double UNKNOWN = std::numeric_limits<double>::quiet_NaN();
                    const double time = numberOf(row, "time", UNKNOWN);
                    const double cost = numberOf(row, "best_cost", UNKNOWN);
                    if (std::isfinite(time) && std::isfinite(cost))
                    {
                        progress[valueOf(row, "runid")].emplace_back(time, cost);
                    }
                });
            return progress;
        }

        /* The name of a planner; configurations of the same name are numbered. */
        std::string distinctName(const Experiment &experiment, const std::string &name)
        {
            std::string distinct = name;
            for (int number = 2; std::any_of(experiment.planners.begin(), experiment.planners.end(),
                                             [&](const PlannerResults &known) { return known.name == distinct; });
                 ++number)
            {
                distinct = name + " (" + std::to_string(number) + ")";
            }
            return distinct;
        }

        void addRuns(const Database &database, const std::string &id, Experiment &experiment)
        {
            std::map<std::string, Samples> progress = readProgress(database, id);
            std::map<std::string, std::size_t> places;
            database.forEach(
                "SELECT r.*, c.name AS planner_name FROM runs r JOIN plannerConfigs c ON c.id = "
                "r.plannerid WHERE r.experimentid = ? ORDER BY r.id",
                id,
                [&](const Row &row)
                {
                    const auto place = places.insert({valueOf(row, "plannerid"), experiment.planners.size()});
                    if (place.second)
                    {
                        experiment.planners.push_back(
                            {distinctName(experiment, plainPlannerName(valueOf(row, "planner_name"))), {}});
                    }
                    experiment.planners[place.first->second].runs.push_back(
                        makeRunResult({row, progress[valueOf(row, "id")]}, experiment.timeLimit));
                });
        }
    }  // namespace

    std::vector<Experiment> readDatabase(const std::string &file)
    {
        const Database database(file);
        database.requireTables();
        std::vector<Experiment> experiments;
        std::vector<std::string> ids;
        database.forEach("SELECT * FROM experiments WHERE id > ? ORDER BY id", "0",
                         [&](const Row &row)
                         {
                             experiments.push_back(experimentOf(row, file));
                             ids.push_back(valueOf(row, "id"));
                         });
        for (std::size_t i = 0; i < ids.size(); ++i)
        {
            addRuns(database, ids[i], experiments[i]);
        }
        return experiments;
    }
}  // namespace ompl_mfa::report
