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

#include <algorithm>
#include <vector>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/optimizer/RandomSource.h"
#include "optimizer/TestFunction.h"
#include "paper/Contender.h"
#include "paper/Study.h"
#include "paper/StudyRuns.h"

using ompl_mfa::optimizer::TestFunction;

namespace ompl_mfa::paper
{
    namespace
    {
        struct Job
        {
            std::string function;
            unsigned int dimension;
            bool moved;
            std::string algorithm;
            unsigned int run;
        };

        /** \brief Shifts every coordinate of the optimum down by 5 to 15 % of the cube's edge, differently in each
            run. */
        Eigen::VectorXd drawShift(const Job &job)
        {
            const TestFunction function(job.function, job.dimension);
            RandomSource random(job.run);
            Eigen::VectorXd shift = Eigen::VectorXd::Zero(job.dimension);
            for (unsigned int k = 0; job.moved && k < job.dimension; ++k)
            {
                shift[k] = -(0.05 + 0.1 * random.uniform()) * (function.upper() - function.lower())[k];
            }
            return shift;
        }

        std::vector<Job> makeJobs(unsigned int runs)
        {
            std::vector<Job> jobs;
            for (const auto &function : TestFunction::names())
            {
                for (const unsigned int dimension : {2U, 10U, 30U})
                {
                    if (function == "sinc" && dimension != 2)
                    {
                        continue;
                    }
                    for (const auto &algorithm : contenders())
                    {
                        for (unsigned int run = 1; run <= runs; ++run)
                        {
                            jobs.push_back({function, dimension, true, algorithm, run});
                            if (algorithm == "mfa" || algorithm == "fa" || algorithm == "de")
                            {
                                jobs.push_back({function, dimension, false, algorithm, run});
                            }
                        }
                    }
                }
            }
            return jobs;
        }

        double errorOf(const Job &job)
        {
            TestFunction function(job.function, job.dimension, drawShift(job));
            const Run run = runContender(job.algorithm, function, function.lower(), function.upper(), -1e300, job.run);
            const double optimum = function.evaluate(function.optimum(), nullptr).cost;
            return std::max(0.0, run.best.cost - optimum);
        }

        /** \brief The populations of Figs. 5 and 6: for each algorithm the run with the median share of fireflies near
            the optimum. */
        void writePopulations(const StudyOptions &options)
        {
            auto out = openTable(options, "populations.csv", "algorithm,run,share,x,y");
            for (const auto variant : {FireflyOptimizer::Variant::FA, FireflyOptimizer::Variant::MFA})
            {
                for (unsigned int run = 1; run <= 30; ++run)
                {
                    TestFunction function("sinc", 2);
                    FireflyOptimizer::Settings settings;
                    settings.variant = variant;
                    FireflyOptimizer optimizer(settings, function.lower(), function.upper(), run);
                    for (unsigned int generation = 0; generation <= settings.generations; ++generation)
                    {
                        optimizer.step(function, [] { return false; });
                    }
                    const auto &x = optimizer.population();
                    double near = 0.0;
                    for (Eigen::Index i = 0; i < x.cols(); ++i)
                    {
                        near += function.isNearOptimum(x.col(i)) ? 1.0 : 0.0;
                    }
                    for (Eigen::Index i = 0; i < x.cols(); ++i)
                    {
                        out << (variant == FireflyOptimizer::Variant::FA ? "fa," : "mfa,") << run << ","
                            << near / settings.populationSize << "," << x(0, i) << "," << x(1, i) << "\n";
                    }
                }
            }
        }
    }  // namespace

    void studyFunctions(const StudyOptions &options)
    {
        const auto jobs = makeJobs(options.functionRuns);
        std::vector<StudyRun> runs;
        runs.reserve(jobs.size());
        for (const Job &job : jobs)
        {
            runs.push_back({{{"function", job.function},
                             {"dimension", job.dimension},
                             {"moved", job.moved},
                             {"algorithm", job.algorithm},
                             {"run", job.run}},
                            [job] {
                                return Json{{"error", numberToJson(errorOf(job))}};
                            }});
        }
        const std::vector<Json> results = makeStudyRuns(options, "functions", "", runs);
        auto out = openTable(options, "functions.csv", "function,dimension,moved,algorithm,run,error");
        for (std::size_t i = 0; i < jobs.size(); ++i)
        {
            out << jobs[i].function << "," << jobs[i].dimension << "," << (jobs[i].moved ? 1 : 0) << ","
                << jobs[i].algorithm << "," << jobs[i].run << "," << numberFrom(results[i].at("error")) << "\n";
        }
        writePopulations(options);
    }
}  // namespace ompl_mfa::paper
