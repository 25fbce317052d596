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

#include <fstream>
#include <iterator>
#include <vector>

#include "paper/Contender.h"
#include "paper/PlannerContender.h"
#include "paper/Study.h"
#include "paper/StudyRuns.h"
#include "paper/StudyScenes.h"

namespace ompl_mfa::paper
{
    namespace
    {
        constexpr unsigned int SEEDED_SCENES = 20;
        constexpr unsigned int SLICE_RESOLUTION = 400;
        constexpr const char *PLANNER = "mfa_default";

        struct Job
        {
            std::size_t scene;
            std::string algorithm;
            unsigned int run;
        };

        struct Outcome
        {
            Run run;
            Points path;
        };

        bool isPaperScene(const PathScene &scene)
        {
            return scene.name.rfind("paper", 0) == 0;
        }

        std::vector<std::string> algorithmsFor(const PathScene &scene)
        {
            auto algorithms = contenders();
            const auto &without = ablations();
            if (isPaperScene(scene))
            {
                algorithms.insert(algorithms.end(), without.begin(), without.end());
            }
            return algorithms;
        }

        std::vector<Job> makeJobs(const std::vector<PathScene> &scenes, const StudyOptions &options, bool planner)
        {
            std::vector<Job> jobs;
            for (std::size_t scene = 0; scene < scenes.size(); ++scene)
            {
                const unsigned int runs = isPaperScene(scenes[scene]) ? options.paperRuns : options.seededRuns;
                for (const auto &algorithm : planner ? std::vector<std::string>{PLANNER} : algorithmsFor(scenes[scene]))
                {
                    for (unsigned int run = 1; run <= runs; ++run)
                    {
                        jobs.push_back({scene, algorithm, run});
                    }
                }
            }
            return jobs;
        }

        Outcome runJob(const Job &job, const PathScene &scene, double optimum)
        {
            const double target = 1.01 * optimum;
            if (job.algorithm == PLANNER)
            {
                auto result = runPlanner(scene, SLICES, target, job.run);
                return {std::move(result.run), std::move(result.path)};
            }
            PathProblem problem(scene, SLICES);
            Outcome outcome{runContender(job.algorithm, problem, problem.lower(), problem.upper(), target, job.run),
                            {}};
            outcome.path = problem.path(outcome.run.x);
            return outcome;
        }

        void writeRuns(const StudyOptions &options, const std::vector<PathScene> &scenes, const std::vector<Job> &jobs,
                       const std::vector<Outcome> &outcomes, const std::string &prefix)
        {
            auto runs = openTable(options, prefix + "runs.csv",
                                  "scene,algorithm,run,cost,violation,evaluations,evaluations_to_target");
            auto times = openTable(options, prefix + "times.csv", "scene,algorithm,run,seconds,seconds_to_target");
            auto traces = openTable(options, prefix + "convergence.csv", "scene,algorithm,run,hundredth,cost");
            auto paths = openTable(options, prefix + "paths.csv", "scene,algorithm,run,x,y");
            for (std::size_t i = 0; i < jobs.size(); ++i)
            {
                const auto &run = outcomes[i].run;
                const std::string key =
                    scenes[jobs[i].scene].name + "," + jobs[i].algorithm + "," + std::to_string(jobs[i].run) + ",";
                runs << key << run.best.cost << "," << run.best.violation << "," << run.evaluations << ","
                     << run.evaluationsToTarget << "\n";
                times << key << run.seconds << "," << run.secondsToTarget << "\n";
                if (!isPaperScene(scenes[jobs[i].scene]))
                {
                    continue;
                }
                for (std::size_t k = 0; k < run.trace.size(); ++k)
                {
                    traces << key << k + 1 << "," << run.trace[k] << "\n";
                }
                for (const auto &point : outcomes[i].path)
                {
                    paths << key << point.x() << "," << point.y() << "\n";
                }
            }
        }

        Json outcomeToJson(const Outcome &outcome)
        {
            const Run &run = outcome.run;
            Json trace = Json::array();
            for (const double cost : run.trace)
            {
                trace.push_back(numberToJson(cost));
            }
            Json path = Json::array();
            for (const auto &point : outcome.path)
            {
                path.push_back({point.x(), point.y()});
            }
            return {{"cost", numberToJson(run.best.cost)},
                    {"violation", numberToJson(run.best.violation)},
                    {"evaluations", run.evaluations},
                    {"evaluations_to_target", run.evaluationsToTarget},
                    {"seconds", run.seconds},
                    {"seconds_to_target", run.secondsToTarget},
                    {"trace", trace},
                    {"path", path}};
        }

        Outcome outcomeFrom(const Json &json)
        {
            Outcome outcome;
            Run &run = outcome.run;
            run.best = {numberFrom(json.at("violation")), numberFrom(json.at("cost"))};
            run.evaluations = json.at("evaluations");
            run.evaluationsToTarget = json.at("evaluations_to_target");
            run.seconds = json.at("seconds");
            run.secondsToTarget = json.at("seconds_to_target");
            for (const Json &cost : json.at("trace"))
            {
                run.trace.push_back(numberFrom(cost));
            }
            for (const Json &point : json.at("path"))
            {
                outcome.path.emplace_back(point.at(0), point.at(1));
            }
            return outcome;
        }

        /** \brief Text of the scene file: the input that determines a run. */
        std::string textOf(const std::string &file)
        {
            std::ifstream in(file, std::ios::binary);
            return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        }

        std::vector<PathScene> allScenes(const StudyOptions &options)
        {
            auto scenes = paperScenes(options.worldFile);
            const auto seeded = seededScenes(SEEDED_SCENES);
            scenes.insert(scenes.end(), seeded.begin(), seeded.end());
            return scenes;
        }

        void studyPlanning(const StudyOptions &options, bool planner)
        {
            const auto scenes = allScenes(options);
            std::vector<double> optima;
            optima.reserve(scenes.size());
            for (const auto &scene : scenes)
            {
                optima.push_back(oracle::shortestPath(scene.world, scene.start, scene.goal).length);
            }
            const auto jobs = makeJobs(scenes, options, planner);
            std::vector<StudyRun> runs;
            runs.reserve(jobs.size());
            for (const Job &job : jobs)
            {
                runs.push_back({{{"scene", scenes[job.scene].name}, {"algorithm", job.algorithm}, {"run", job.run}},
                                [&scene = scenes[job.scene], job, optimum = optima[job.scene]]
                                { return outcomeToJson(runJob(job, scene, optimum)); }});
            }
            std::vector<Outcome> outcomes;
            outcomes.reserve(jobs.size());
            for (const Json &result :
                 makeStudyRuns(options, planner ? "planner" : "paths", textOf(options.worldFile), runs))
            {
                outcomes.push_back(outcomeFrom(result));
            }
            writeRuns(options, scenes, jobs, outcomes, planner ? "planner_" : "");
        }
    }  // namespace

    void writeScenes(const StudyOptions &options)
    {
        auto table =
            openTable(options, "scenes.csv", "scene,obstacles,start_x,start_y,goal_x,goal_y,optimum,slice_optimum");
        auto obstacles = openTable(options, "obstacles.csv", "scene,obstacle,radius,x,y");
        auto paths = openTable(options, "optima.csv", "scene,x,y");
        for (const auto &scene : allScenes(options))
        {
            const auto exact = oracle::shortestPath(scene.world, scene.start, scene.goal);
            table << scene.name << "," << scene.world.obstacles.size() << "," << scene.start.x() << ","
                  << scene.start.y() << "," << scene.goal.x() << "," << scene.goal.y() << "," << exact.length << ","
                  << PathProblem(scene, SLICES).sliceOptimum(SLICE_RESOLUTION) << "\n";
            for (std::size_t k = 0; k < scene.world.obstacles.size(); ++k)
            {
                const auto &obstacle = scene.world.obstacles[k];
                for (const auto &vertex : obstacle.vertices)
                {
                    obstacles << scene.name << "," << k << "," << obstacle.radius << "," << vertex.x() << ","
                              << vertex.y() << "\n";
                }
            }
            for (const auto &point : exact.path)
            {
                paths << scene.name << "," << point.x() << "," << point.y() << "\n";
            }
        }
    }

    void studyPaths(const StudyOptions &options)
    {
        studyPlanning(options, false);
    }

    void studyPlanner(const StudyOptions &options)
    {
        studyPlanning(options, true);
    }

    void studySlices(const StudyOptions &options)
    {
        const PathScene scene = paperScenes(options.worldFile).front();
        const double optimum = oracle::shortestPath(scene.world, scene.start, scene.goal).length;
        const std::vector<unsigned int> counts{4, 6, 8, 12, 16, 24};
        const std::vector<std::string> algorithms{"ga", "fa", "fa_long", "mfa", "sade", "abc"};
        std::vector<double> optima;
        std::vector<StudyRun> runs;
        for (const unsigned int slices : counts)
        {
            optima.push_back(PathProblem(scene, slices).sliceOptimum(SLICE_RESOLUTION));
            for (const auto &algorithm : algorithms)
            {
                for (unsigned int run = 1; run <= options.sliceRuns; ++run)
                {
                    runs.push_back({{{"slices", slices}, {"algorithm", algorithm}, {"run", run}},
                                    [&scene, slices, algorithm, optimum, run]
                                    {
                                        PathProblem problem(scene, slices);
                                        Outcome outcome;
                                        outcome.run = runContender(algorithm, problem, problem.lower(), problem.upper(),
                                                                   1.01 * optimum, run);
                                        outcome.path = problem.path(outcome.run.x);
                                        return outcomeToJson(outcome);
                                    }});
                }
            }
        }
        const std::vector<Json> results = makeStudyRuns(options, "slices", textOf(options.worldFile), runs);
        auto table = openTable(options, "slices.csv", "slices,slice_optimum,algorithm,run,cost,violation");
        for (std::size_t i = 0; i < results.size(); ++i)
        {
            const Json &key = runs[i].key;
            const Run run = outcomeFrom(results[i]).run;
            table << key.at("slices").get<unsigned int>() << "," << optima[i / options.sliceRuns / algorithms.size()]
                  << "," << key.at("algorithm").get<std::string>() << "," << key.at("run").get<unsigned int>() << ","
                  << run.best.cost << "," << run.best.violation << "\n";
        }
    }
}  // namespace ompl_mfa::paper
