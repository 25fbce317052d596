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
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/Figure.h"
#include "cli/JsonDocument.h"
#include "cli/NumberOption.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "optimizer/TestFunction.h"
#include "text/NearestName.h"
#include "text/NumberText.h"

using ompl_mfa::optimizer::TestFunction;

namespace ompl_mfa::cli
{
    namespace
    {
        struct Options
        {
            std::string function{"sinc"};
            std::vector<std::string> algorithms{"fa", "mfa"};
            unsigned int runs{30};
            unsigned int dimension{2};
            std::int64_t seed{1};
            FireflyOptimizer::Settings settings;
            std::string picture;
            bool json{false};
        };

        struct Run
        {
            double best;
            double shareNearOptimum;
            std::uint64_t evaluations;
            Eigen::MatrixXd population;
        };

        /** \brief All runs of one algorithm, sorted by the share of fireflies near the optimum. */
        struct Result
        {
            std::string algorithm;
            std::vector<Run> runs;
        };

        template <typename Projection>
        double median(const std::vector<Run> &runs, Projection projection)
        {
            std::vector<double> values;
            values.reserve(runs.size());
            for (const auto &run : runs)
            {
                values.push_back(static_cast<double>(projection(run)));
            }
            std::sort(values.begin(), values.end());
            return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
        }

        Run runOnce(TestFunction &function, const FireflyOptimizer::Settings &settings, std::uint64_t seed)
        {
            FireflyOptimizer optimizer(settings, function.lower(), function.upper(), seed);
            const auto never = [] { return false; };
            for (unsigned int generation = 0; generation <= settings.generations; ++generation)
            {
                optimizer.step(function, never);
            }

            unsigned int near = 0;
            for (Eigen::Index i = 0; i < optimizer.population().cols(); ++i)
            {
                near += function.isNearOptimum(optimizer.population().col(i)) ? 1 : 0;
            }
            return {function.valueOf(optimizer.bestBrightness()), static_cast<double>(near) / settings.populationSize,
                    optimizer.evaluations(), optimizer.population()};
        }

        Result runAlgorithm(TestFunction &function, const Options &options, const std::string &algorithm)
        {
            auto settings = options.settings;
            settings.variant = algorithm == "fa" ? FireflyOptimizer::Variant::FA : FireflyOptimizer::Variant::MFA;
            Result result{algorithm, {}};
            for (unsigned int run = 0; run < options.runs; ++run)
            {
                result.runs.push_back(runOnce(function, settings, static_cast<std::uint64_t>(options.seed) + run));
            }
            std::stable_sort(result.runs.begin(), result.runs.end(),
                             [](const Run &a, const Run &b) { return a.shareNearOptimum < b.shareNearOptimum; });
            return result;
        }

        /** \brief Adds the contour of a grid at \e level by marching squares; saddles are not disambiguated. */
        void addLevel(Axes::Segments &segments, const Eigen::MatrixXd &values, const Eigen::Vector2d &lower,
                      const Eigen::Vector2d &cell, double level)
        {
            const auto corner = [&](Eigen::Index i, Eigen::Index j)
            { return Eigen::Vector2d(lower + cell.cwiseProduct(Eigen::Vector2d(double(i), double(j)))); };
            for (Eigen::Index i = 0; i + 1 < values.rows(); ++i)
            {
                for (Eigen::Index j = 0; j + 1 < values.cols(); ++j)
                {
                    const Eigen::Index around[5][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}};
                    Axes::Points crossings;
                    for (int edge = 0; edge < 4; ++edge)
                    {
                        const auto *a = around[edge];
                        const auto *b = around[edge + 1];
                        const double from = values(a[0], a[1]) - level;
                        const double to = values(b[0], b[1]) - level;
                        if ((from < 0.0) != (to < 0.0))
                        {
                            const Eigen::Vector2d start = corner(a[0], a[1]);
                            crossings.emplace_back(start + from / (from - to) * (corner(b[0], b[1]) - start));
                        }
                    }
                    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
                    {
                        segments.emplace_back(crossings[k], crossings[k + 1]);
                    }
                }
            }
        }

        /** \brief Equal steps or, for a function with values over several powers of ten, equal areas. */
        std::vector<double> contourLevels(std::vector<double> values)
        {
            constexpr int LEVELS = 7;
            std::sort(values.begin(), values.end());
            const double range = values.back() - values.front();
            const bool equalSteps = values[values.size() / 2] - values.front() > 0.05 * range;
            std::vector<double> levels;
            for (int level = 1; level <= LEVELS; ++level)
            {
                const double part = static_cast<double>(level) / (LEVELS + 1);
                levels.push_back(equalSteps
                                     ? values.front() + part * range
                                     : values[static_cast<std::size_t>(part * static_cast<double>(values.size()))]);
            }
            return levels;
        }

        Axes::Segments contours(const TestFunction &function)
        {
            constexpr Eigen::Index GRID = 140;
            const Eigen::Vector2d lower = function.lower();
            const Eigen::Vector2d cell = (function.upper() - function.lower()) / double(GRID - 1);
            Eigen::MatrixXd values(GRID, GRID);
            for (Eigen::Index i = 0; i < GRID; ++i)
            {
                for (Eigen::Index j = 0; j < GRID; ++j)
                {
                    values(i, j) = function.value(lower + cell.cwiseProduct(Eigen::Vector2d(double(i), double(j))));
                }
            }
            Axes::Segments segments;
            for (const double level : contourLevels({values.data(), values.data() + values.size()}))
            {
                addLevel(segments, values, lower, cell, level);
            }
            return segments;
        }

        void draw(const TestFunction &function, const std::vector<Result> &results, const std::string &file)
        {
            const auto lines = contours(function);
            Figure figure;
            for (const auto &result : results)
            {
                const Run &run = result.runs[(result.runs.size() - 1) / 2];
                const std::string title = std::string(result.algorithm == "fa" ? "FA" : "MFA") + " on " +
                                          function.name() + ": " + text::fixedText(100.0 * run.shareNearOptimum, 0) +
                                          " % of the fireflies near the optimum";
                Axes axes(title, "x", "y", function.lower(), function.upper());
                Axes::Points fireflies;
                for (Eigen::Index i = 0; i < run.population.cols(); ++i)
                {
                    fireflies.emplace_back(run.population.col(i));
                }
                axes.addSegments(lines, {0x8fa8bf, 0.8, std::nullopt, 1.0}, "contours of the function");
                axes.addCircle(function.optimum(), 0.05 * (function.upper() - function.lower())[0],
                               {0x1a7f37, 1.5, std::nullopt, 1.0}, "near the global optimum");
                axes.addMarkers(fireflies, 3.5, {0x7a2d00, 0.6, 0xf28e2b, 0.85}, "fireflies at the end, median run");
                figure.addAxes(axes);
            }
            figure.write(file);
        }

        void printJson(const Options &options, const std::vector<Result> &results)
        {
            nlohmann::json document{{"results", nlohmann::json::array()}};
            for (const auto &result : results)
            {
                document["results"].push_back(
                    {{"algorithm", result.algorithm},
                     {"function", options.function},
                     {"dimension", options.dimension},
                     {"runs", options.runs},
                     {"seed", options.seed},
                     {"best_median", median(result.runs, [](const Run &run) { return run.best; })},
                     {"share_near_optimum_median",
                      median(result.runs, [](const Run &run) { return run.shareNearOptimum; })},
                     {"evaluations", median(result.runs, [](const Run &run) { return run.evaluations; })}});
            }
            printDocument(document);
        }

        void printTable(const Options &options, const std::vector<Result> &results)
        {
            std::printf("%s in %u dimensions, %u fireflies, %u generations, %u runs from seed %lld; medians\n",
                        options.function.c_str(), options.dimension, options.settings.populationSize,
                        options.settings.generations, options.runs, static_cast<long long>(options.seed));
            std::printf("%-10s %14s %22s %12s\n", "algorithm", "best value", "share near optimum", "evaluations");
            for (const auto &result : results)
            {
                const double best = median(result.runs, [](const Run &run) { return run.best; });
                const double share = 100.0 * median(result.runs, [](const Run &run) { return run.shareNearOptimum; });
                const double evaluations = median(result.runs, [](const Run &run) { return run.evaluations; });
                std::printf("%-10s %14s %21s%% %12s\n", result.algorithm.c_str(), text::numberText(best, 6).c_str(),
                            text::fixedText(share, 1).c_str(), text::fixedText(evaluations, 0).c_str());
            }
            std::fflush(stdout);
        }

        void optimize(const Options &options)
        {
            for (const auto &algorithm : options.algorithms)
            {
                text::requireKnown("algorithm", algorithm, {"fa", "mfa"});
            }
            TestFunction function(options.function, options.dimension);
            if (!options.picture.empty() && options.dimension != 2)
            {
                throw InputError("--picture with --dimension " + std::to_string(options.dimension) +
                                 " is not accepted; only 2 dimensions can be drawn");
            }
            if (!options.picture.empty())
            {
                pictureFormat(options.picture);
            }
            std::vector<Result> results;
            for (const auto &algorithm : options.algorithms)
            {
                results.push_back(runAlgorithm(function, options, algorithm));
            }
            if (!options.picture.empty())
            {
                draw(function, results,
                     benchmark::writtenPath(options.picture, "--picture " + options.picture).string());
            }
            if (options.json)
            {
                printJson(options, results);
            }
            else
            {
                printTable(options, results);
            }
        }
    }  // namespace

    void addOptimizeCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("optimize", "Optimise a test function with FA and MFA");
        std::string names;
        for (const auto &name : TestFunction::names())
        {
            names += (names.empty() ? "" : ", ") + name;
        }
        command->add_option("--function", options->function, "One of " + names)->capture_default_str();
        command->add_option("--algorithm", options->algorithms, "fa, mfa or both, separated by commas")
            ->delimiter(',')
            ->capture_default_str();
        command->add_option("--runs", options->runs, "Independent runs, seeded one after another")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str();
        command->add_option("--dimension", options->dimension, "Coordinates of the function")
            ->check(CLI::Range(1, 10000))
            ->capture_default_str();
        command->add_option("--seed", options->seed, "Seed of the first run")
            ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()))
            ->capture_default_str();
        command->add_option("--population", options->settings.populationSize, "Fireflies")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str();
        command->add_option("--generations", options->settings.generations, "Generations of a run, Mmax of eq. (13)")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str();
        auto &settings = options->settings;
        addNumberOption(*command, "--gamma", settings.gamma, "Light absorption per squared range")
            ->default_str(text::numberText(settings.gamma));
        addNumberOption(*command, "--alpha", settings.alpha, "Random step in parts of the range")
            ->default_str(text::numberText(settings.alpha));
        addNumberOption(*command, "--eta", settings.eta, "Attraction at distance 0, the paper's beta0")
            ->default_str(text::numberText(settings.eta));
        command->add_option("--picture", options->picture,
                            "Write the final populations to this .svg, .png or .pdf file");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options] { optimize(*options); });
    }
}  // namespace ompl_mfa::cli
