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

#include "ompl_mfa/benchmark/ResultsDatabase.h"

#include <sqlite3.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "benchmark/LogText.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        /* The tables of ompl_benchmark_statistics; columns for properties are added as they come. */
        const char *const TABLES = R"(
            CREATE TABLE IF NOT EXISTS experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512),
                totaltime REAL, timelimit REAL, memorylimit REAL, runcount INTEGER, version VARCHAR(128),
                hostname VARCHAR(1024), cpuinfo TEXT, date DATETIME, seed VARCHAR(24), setup TEXT);
            CREATE TABLE IF NOT EXISTS plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT,
                name VARCHAR(512) NOT NULL, settings TEXT);
            CREATE TABLE IF NOT EXISTS enums (name VARCHAR(512), value INTEGER, description TEXT,
                PRIMARY KEY (name, value));
            CREATE TABLE IF NOT EXISTS runs (id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER,
                plannerid INTEGER, FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
                FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE);
            CREATE TABLE IF NOT EXISTS progress (runid INTEGER, time REAL, PRIMARY KEY (runid, time),
                FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE);)";

        /* Milliseconds to wait while another program writes to the database. */
        constexpr int PATIENCE = 10000;

        std::string quoted(const std::string &name)
        {
            std::string text = "\"";
            for (const char letter : name)
            {
                text += letter == '"' ? "\"\"" : std::string(1, letter);
            }
            return text + "\"";
        }

        std::string joined(const std::vector<std::string> &words)
        {
            std::string text;
            for (const std::string &word : words)
            {
                text += (text.empty() ? "" : ", ") + word;
            }
            return text;
        }

        /* A value of SQL: NULL, or text, which SQLite converts to the type of the column. */
        struct Value
        {
            bool null{true};
            std::string text;

            Value() = default;

            Value(std::string content)  // NOLINT(google-explicit-constructor): a list of values is written as texts
              : null(false)
              , text(std::move(content))
            {
            }
        };

        using Values = std::vector<Value>;

        /* A value of a run or of a progress sample; what is missing or not finite is NULL. */
        Value measured(const std::string &value)
        {
            const std::string clean = cleanValue(value);
            return clean.empty() || clean == "nan" || clean == "inf" ? Value() : Value(clean);
        }

        /* A column for the property "words TYPE". */
        struct Column
        {
            std::string name;
            std::string type;

            Column(const std::string &property, char separator)
            {
                const std::size_t blank = property.rfind(' ');
                type = blank == std::string::npos ? "TEXT" : property.substr(blank + 1);
                for (const char letter : property.substr(0, blank))
                {
                    if (letter != ' ')
                    {
                        name += letter;
                    }
                    else if (separator != '\0')
                    {
                        name += separator;
                    }
                }
            }
        };

        class Database
        {
        public:
            explicit Database(std::string file)
              : file_(std::move(file))
            {
                sqlite3 *connection = nullptr;
                const int status = sqlite3_open(file_.c_str(), &connection);
                connection_.reset(connection);
                require(status == SQLITE_OK);
                sqlite3_busy_timeout(connection, PATIENCE);
            }

            void execute(const char *sql)
            {
                require(sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK);
            }

            /* A statement with parameters that runs many times. */
            class Statement
            {
            public:
                Statement(Database &database, const std::string &sql)
                  : database_(database)
                {
                    sqlite3_stmt *prepared = nullptr;
                    database.require(sqlite3_prepare_v2(database.connection_.get(), sql.c_str(), -1, &prepared,
                                                        nullptr) == SQLITE_OK);
                    prepared_.reset(prepared);
                }

                /* Runs the statement. Returns the first column of all rows. */
                std::vector<std::string> run(const Values &values = {})
                {
                    sqlite3_stmt *statement = prepared_.get();
                    sqlite3_reset(statement);
                    for (std::size_t i = 0; i < values.size(); ++i)
                    {
                        const int parameter = static_cast<int>(i) + 1;
                        const std::string &text = values[i].text;
                        database_.require((values[i].null ? sqlite3_bind_null(statement, parameter)
                                                          : sqlite3_bind_text(statement, parameter, text.c_str(),
                                                                              static_cast<int>(text.size()),
                                                                              SQLITE_TRANSIENT)) == SQLITE_OK);
                    }
                    std::vector<std::string> rows;
                    int status = sqlite3_step(statement);
                    for (; status == SQLITE_ROW; status = sqlite3_step(statement))
                    {
                        const auto *text = sqlite3_column_text(statement, 0);
                        rows.emplace_back(text == nullptr ? "" : reinterpret_cast<const char *>(text));
                    }
                    database_.require(status == SQLITE_DONE);
                    return rows;
                }

            private:
                struct Finalize
                {
                    void operator()(sqlite3_stmt *statement) const
                    {
                        sqlite3_finalize(statement);
                    }
                };

                Database &database_;
                std::unique_ptr<sqlite3_stmt, Finalize> prepared_;
            };

            std::vector<std::string> run(const std::string &sql, const Values &values = {})
            {
                return Statement(*this, sql).run(values);
            }

            /* The id of the row that was inserted last. */
            std::string lastId() const
            {
                return std::to_string(sqlite3_last_insert_rowid(connection_.get()));
            }

            bool hasColumn(const std::string &table, const std::string &column)
            {
                return !run("SELECT 1 FROM pragma_table_info(?) WHERE name = ? COLLATE NOCASE", {table, column})
                            .empty();
            }

            void addColumn(const std::string &table, const Column &column)
            {
                if (!hasColumn(table, column.name))
                {
                    run("ALTER TABLE " + table + " ADD " + quoted(column.name) + " " + column.type);
                }
            }

            /* A statement that inserts a row of \e columns into \e table; what breaks a primary key is left out. */
            Statement insertion(const std::string &table, const std::vector<std::string> &columns)
            {
                std::vector<std::string> names;
                names.reserve(columns.size());
                for (const std::string &column : columns)
                {
                    names.push_back(quoted(column));
                }
                return {*this, "INSERT OR IGNORE INTO " + table + " (" + joined(names) + ") VALUES (" +
                                   joined(std::vector<std::string>(columns.size(), "?")) + ")"};
            }

        private:
            struct Close
            {
                void operator()(sqlite3 *connection) const
                {
                    sqlite3_close(connection);
                }
            };

            void require(bool success) const
            {
                if (!success)
                {
                    throw InputError(
                        file_ + ": cannot be written as a database of results: " + sqlite3_errmsg(connection_.get()));
                }
            }

            std::string file_;
            std::unique_ptr<sqlite3, Close> connection_;
        };

        void addEnums(Database &database, const BenchmarkLog &log)
        {
            for (const LogEnum &entry : log.enums)
            {
                if (!database.run("SELECT 1 FROM enums WHERE name = ?", {entry.property}).empty())
                {
                    continue;
                }
                for (std::size_t i = 0; i < entry.names.size(); ++i)
                {
                    database.run("INSERT INTO enums VALUES (?, ?, ?)",
                                 {entry.property, std::to_string(i), entry.names[i]});
                }
            }
        }

        /* Removes what an interrupted part of this campaign has left. */
        void removeEarlierPart(Database &database, const BenchmarkLog &log)
        {
            const auto campaign = log.properties.find("campaign TEXT");
            if (campaign != log.properties.end() && database.hasColumn("experiments", "campaign"))
            {
                database.run("DELETE FROM experiments WHERE campaign = ? AND date = ? AND name = ?",
                             {campaign->second, log.start, oneWord(log.experiment)});
            }
        }

        std::string endedByLineBreak(const std::string &text)
        {
            return text.empty() || text.back() == '\n' ? text : text + "\n";
        }

        /* Returns the id of the experiment. */
        std::string addExperiment(Database &database, const BenchmarkLog &log)
        {
            std::vector<std::string> columns{"name",     "totaltime", "timelimit", "memorylimit", "runcount", "version",
                                             "hostname", "cpuinfo",   "date",      "seed",        "setup"};
            Values values{oneWord(log.experiment),
                          text::numberText(log.duration, LOG_DIGITS),
                          text::numberText(log.timeLimit, LOG_DIGITS),
                          text::numberText(log.memoryLimit, LOG_DIGITS),
                          std::to_string(log.runCount),
                          "OMPL " + log.version,
                          oneWord(log.host),
                          endedByLineBreak(log.cpu),
                          log.start,
                          std::to_string(log.seed),
                          endedByLineBreak(log.setup)};
            for (const auto &property : log.properties)
            {
                Column column(property.first, '\0');
                std::replace(column.name.begin(), column.name.end(), '-', '_');
                database.addColumn("experiments", column);
                columns.push_back(column.name);
                values.emplace_back(cleanValue(property.second));
            }
            database.insertion("experiments", columns).run(values);
            return database.lastId();
        }

        /* Returns the id of the planner with its settings. */
        std::string addPlanner(Database &database, const PlannerLog &planner)
        {
            std::string settings;
            for (const auto &property : planner.common)
            {
                settings += property.first + " = " + property.second + "\n;";
            }
            const auto known =
                database.run("SELECT id FROM plannerConfigs WHERE name = ? AND settings = ?", {planner.name, settings});
            if (!known.empty())
            {
                return known.front();
            }
            database.run("INSERT INTO plannerConfigs VALUES (NULL, ?, ?)", {planner.name, settings});
            return database.lastId();
        }

        /* Returns the ids of the runs. */
        std::vector<std::string> addRuns(Database &database, const PlannerLog &planner, const std::string &experiment)
        {
            const std::string id = addPlanner(database, planner);
            const std::set<std::string> names = propertyNames(planner);
            std::vector<std::string> columns{"experimentid", "plannerid"};
            for (const std::string &name : names)
            {
                const Column column(name, '_');
                database.addColumn("runs", column);
                columns.push_back(column.name);
            }
            std::vector<std::string> ids;
            Database::Statement insertion = database.insertion("runs", columns);
            for (const LogProperties &run : planner.runs)
            {
                Values values{experiment, id};
                for (const std::string &name : names)
                {
                    const auto found = run.find(name);
                    values.push_back(found == run.end() ? Value() : measured(found->second));
                }
                insertion.run(values);
                ids.push_back(database.lastId());
            }
            return ids;
        }

        void addProgress(Database &database, const PlannerLog &planner, const std::vector<std::string> &runs)
        {
            std::vector<std::string> columns{"runid", "time"};
            for (const std::string &name : planner.progressNames)
            {
                const Column column(name, '_');
                database.addColumn("progress", column);
                columns.push_back(column.name);
            }
            Database::Statement insertion = database.insertion("progress", columns);
            for (std::size_t i = 0; i < planner.progress.size(); ++i)
            {
                for (const ProgressSample &sample : planner.progress[i])
                {
                    Values values{runs[i], progressTime(sample.time)};
                    for (const std::string &value : sample.values)
                    {
                        values.push_back(measured(value));
                    }
                    insertion.run(values);
                }
            }
        }
    }  // namespace

    void prepareDatabase(const std::filesystem::path &file)
    {
        Database(file.string()).execute(TABLES);
    }

    void addToDatabase(const std::filesystem::path &file, const BenchmarkLog &log)
    {
        Database database(file.string());
        database.execute("PRAGMA foreign_keys = ON");
        // a transaction that is not committed is undone when the database is closed
        database.execute("BEGIN IMMEDIATE");
        database.execute(TABLES);
        removeEarlierPart(database, log);
        addEnums(database, log);
        const std::string experiment = addExperiment(database, log);
        for (const PlannerLog &planner : log.planners)
        {
            const std::vector<std::string> runs = addRuns(database, planner, experiment);
            if (!planner.progress.empty())
            {
                addProgress(database, planner, runs);
            }
        }
        database.execute("COMMIT");
    }
}  // namespace ompl_mfa::benchmark
