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

#include "ompl_mfa/benchmark/ConfigFile.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using test::inputErrorOf;

        /* Seven lines, so that text appended by a test begins at line 8. */
        const std::string PLANAR =
            "[problem]\nrobot = disc\nrobot.radius = 0.3\nstart.x = 1\nstart.y = 2\ngoal.x = 3\n"
            "goal.y = 4\n";

        BenchmarkConfig parse(const std::string &text)
        {
            std::istringstream in(text);
            return parseBenchmarkConfig(in, "folder/a.cfg");
        }

        std::string errorOf(const std::string &text)
        {
            return inputErrorOf([&] { parse(text); });
        }

        TEST(ConfigFile, ReadsEveryKey)
        {
            const BenchmarkConfig config = parse(PLANAR +
                                                 "name = scene\nworld = w.yaml\nstart.theta = 7\ngoal.theta = -7\n"
                                                 "statespace = reedsshepp\nturningradius = 2.5\nthreshold = 0.25\n"
                                                 "volume.min.x = -1\nvolume.max.x = 10\nvolume.min.y = -2\n"
                                                 "volume.max.y = 20\nobjective = weighted\nobjective.threshold = 5\n"
                                                 "objective.weight.length = 1\nobjective.weight.proximity = 0.5\n"
                                                 "sampler = gaussian\nlongest_valid_segment_fraction = 0.02\n"
                                                 "[benchmark]\ntime_limit = 2\nmem_limit = 300\nrun_count = 4\n"
                                                 "output = logs\nsave_paths = shortest\nsimplify = no\nseed = 9\n"
                                                 "progress_interval = 0.001\n");
            EXPECT_EQ(config.problem.name, "scene");
            EXPECT_EQ(config.problem.world->value, "w.yaml");
            EXPECT_EQ(config.problem.robotKind, RobotKind::Disc);
            EXPECT_EQ(config.problem.robotRadius, 0.3);
            EXPECT_EQ(config.problem.space, StateSpaceKind::ReedsShepp);
            EXPECT_EQ(config.problem.turningRadius, 2.5);
            EXPECT_EQ(config.problem.start.x, 1.0);
            EXPECT_EQ(config.problem.start.theta, 7.0);
            EXPECT_EQ(config.problem.goal.y, 4.0);
            EXPECT_EQ(config.problem.threshold, 0.25);
            ASSERT_TRUE(config.problem.volume);
            EXPECT_EQ(config.problem.volume->min[1], -2.0);
            EXPECT_EQ(config.problem.volume->max[1], 20.0);
            EXPECT_EQ(config.problem.objective, ObjectiveKind::Weighted);
            EXPECT_EQ(*config.problem.objectiveThreshold, 5.0);
            ASSERT_EQ(config.problem.objectiveWeights.size(), 2u);
            EXPECT_EQ(config.problem.objectiveWeights[1], std::make_pair(ObjectiveKind::Proximity, 0.5));
            EXPECT_EQ(config.problem.context.sampler, SamplerKind::Gaussian);
            EXPECT_EQ(config.problem.context.longestValidSegmentFraction, 0.02);
            EXPECT_FALSE(config.problem.context.cellSizeFactor);
            EXPECT_EQ(config.benchmark.timeLimit, 2.0);
            EXPECT_EQ(config.benchmark.memoryLimit, 300.0);
            EXPECT_EQ(config.benchmark.runCount, 4u);
            EXPECT_EQ(config.benchmark.output.string(), "logs");
            EXPECT_EQ(config.benchmark.savePaths, SavePaths::Shortest);
            EXPECT_FALSE(config.benchmark.simplify);
            EXPECT_EQ(config.benchmark.seed, 9u);
            EXPECT_EQ(config.benchmark.progressInterval, 0.001);
        }

        TEST(ConfigFile, DefaultsAreTheDocumentedOnes)
        {
            const BenchmarkConfig config = parse(PLANAR);
            EXPECT_EQ(config.problem.name, "a");
            EXPECT_FALSE(config.problem.world);
            EXPECT_FALSE(config.problem.volume);
            EXPECT_FALSE(config.problem.objective);
            EXPECT_EQ(config.problem.threshold, 1e-6);
            EXPECT_FALSE(config.problem.motionValidation);
            EXPECT_EQ(config.benchmark.savePaths, SavePaths::None);
            EXPECT_TRUE(config.benchmark.simplify);
            EXPECT_EQ(config.benchmark.seed, 1u);
            EXPECT_TRUE(config.planners.empty());
        }

        TEST(ConfigFile, TheKeysOfStartAndGoalDecideTheSpace)
        {
            const std::string spatial = "start.z = 0\ngoal.z = 1\n";
            const std::string turned = "start.theta = 0\ngoal.theta = 1\n";
            const std::string axes =
                "start.axis.x = 1\nstart.axis.y = 0\nstart.axis.z = 0\ngoal.axis.x = 1\n"
                "goal.axis.y = 0\ngoal.axis.z = 0\n";
            EXPECT_EQ(parse(PLANAR).problem.space, StateSpaceKind::R2);
            EXPECT_EQ(parse(PLANAR + spatial).problem.space, StateSpaceKind::R3);
            EXPECT_EQ(parse(PLANAR + turned).problem.space, StateSpaceKind::SE2);
            EXPECT_EQ(parse(PLANAR + spatial + turned + axes).problem.space, StateSpaceKind::SE3);
            EXPECT_EQ(parse(PLANAR + turned + "statespace = dubins\n").problem.space, StateSpaceKind::Dubins);
            EXPECT_EQ(parse(PLANAR + turned + "statespace = DubinsSymmetric\n").problem.space,
                      StateSpaceKind::DubinsSymmetric);
            EXPECT_NE(errorOf(PLANAR + "start.theta = 1\n"), "");
            EXPECT_NE(errorOf(PLANAR + spatial + turned), "");
            EXPECT_NE(errorOf(PLANAR + spatial + turned + "start.axis.x = 1\ngoal.axis.x = 1\n"), "");
        }

        TEST(ConfigFile, PlannersKeepTheirOrderAndTheirOwnParameters)
        {
            const BenchmarkConfig config = parse(PLANAR +
                                                 "[planner]\nrrtstar.range = 3\nprm =\nrrtconnect =\n"
                                                 "rrtconnect.range = 100\nrrtconnect =\nrrtconnect.range = 200\n"
                                                 "rrtstar.goal_bias = 0.1\nprm.name = roadmap\n");
            ASSERT_EQ(config.planners.size(), 4u);
            EXPECT_EQ(config.planners[0].type, "rrtstar");
            ASSERT_EQ(config.planners[0].parameters.size(), 2u);
            EXPECT_EQ(config.planners[0].parameters[1].key, "goal_bias");
            EXPECT_EQ(config.planners[0].parameters[1].origin, "folder/a.cfg:15");
            EXPECT_EQ(config.planners[1].name, "roadmap");
            EXPECT_TRUE(config.planners[1].parameters.empty());
            ASSERT_EQ(config.planners[2].parameters.size(), 1u);
            EXPECT_EQ(config.planners[2].parameters[0].value, "100");
            ASSERT_EQ(config.planners[3].parameters.size(), 1u);
            EXPECT_EQ(config.planners[3].parameters[0].value, "200");
        }

        TEST(ConfigFile, PlannerContextGoesToThePlannerOfTheLatestLine)
        {
            const BenchmarkConfig config =
                parse(PLANAR +
                      "[planner]\nproblem.sampler = gaussian\nkpiece =\nprm =\nproblem.sampler = uniform\n"
                      "kpiece.range = 2\nproblem.projection.cellsize_factor = 4\n");
            ASSERT_EQ(config.planners.size(), 2u);
            EXPECT_EQ(config.planners[0].context.sampler, SamplerKind::Gaussian);
            EXPECT_EQ(config.planners[0].context.cellSizeFactor, 4.0);
            EXPECT_EQ(config.planners[1].context.sampler, SamplerKind::Uniform);
            EXPECT_FALSE(config.planners[1].context.cellSizeFactor);
            EXPECT_FALSE(config.problem.context.sampler);
        }

        TEST(ConfigFile, EveryPlannerHasItsOwnName)
        {
            const BenchmarkConfig config = parse(PLANAR +
                                                 "[planner]\nprm=\nprm=\nrrtstar=\nrrtstar.name=PRM-3\nprm=\naps=\n"
                                                 "anytimepathshortening=\n");
            std::vector<std::string> names;
            for (const auto &spec : config.planners)
            {
                names.push_back(spec.name);
            }
            EXPECT_EQ(names, (std::vector<std::string>{"PRM", "PRM-2", "PRM-3", "PRM-4", "AnytimePathShortening",
                                                       "AnytimePathShortening-2"}));
            EXPECT_EQ(
                errorOf(PLANAR + "[planner]\nprm=\nprm.name=x\nrrt=\nrrt.name=x\n"),
                "folder/a.cfg:11: two planners are named 'x', here and at folder/a.cfg:9; every planner needs its "
                "own name");
            EXPECT_EQ(errorOf(PLANAR + "[planner]\nprm=\nprm.name=x\nprm.name=y\n"),
                      "folder/a.cfg:11: name = y: this planner is already named 'x'");
        }

        TEST(ConfigFile, UnknownKeysNameTheNearestKnownOne)
        {
            EXPECT_EQ(errorOf(PLANAR + "start.tetha = 1\n"),
                      "folder/a.cfg:8: problem.start.tetha = 1: unknown key; did you mean 'start.theta'?");
            EXPECT_EQ(errorOf(PLANAR + "longest_valid_segment_fracton = 1\n"),
                      "folder/a.cfg:8: problem.longest_valid_segment_fracton = 1: unknown key; did you mean "
                      "'longest_valid_segment_fraction'?");
            EXPECT_EQ(errorOf(PLANAR + "[benchmark]\ntimelimit = 1\n"),
                      "folder/a.cfg:9: benchmark.timelimit = 1: unknown key; did you mean 'time_limit'? accepted: "
                      "time_limit, "
                      "mem_limit, run_count, output, save_paths, simplify, seed, progress_interval, iteration_limit");
            EXPECT_EQ(errorOf(PLANAR + "[planner]\nrrtsta =\n"),
                      "folder/a.cfg:9: unknown planner 'rrtsta'; did you mean 'rrtstar'?");
            EXPECT_EQ(
                errorOf(PLANAR + "[planner]\nprm=\nproblem.smapler = uniform\n"),
                "folder/a.cfg:10: planner.problem.smapler = uniform: unknown key; did you mean 'sampler'? accepted: "
                "sampler, nr_attempts, standard_deviation, nr_improve_attempts, longest_valid_segment_fraction, "
                "valid_segment_count_factor, projection.cellsize.0, projection.cellsize.1, projection.cellsize.2, "
                "projection.cellsize_factor");
            EXPECT_EQ(
                errorOf(PLANAR + "[planers]\nprm=\n"),
                "folder/a.cfg:9: planers.prm = : the key belongs to no section; sections are [problem], [benchmark] "
                "and [planner]");
            EXPECT_NE(errorOf("name = x\n" + PLANAR), "");
            EXPECT_NE(errorOf(PLANAR + "objective.weight.lenght = 1\n"), "");
        }

        TEST(ConfigFile, PlannersThatAConfigCannotDescribeSayWhy)
        {
            EXPECT_EQ(errorOf(PLANAR + "[planner]\nvfrrt=\n"),
                      "folder/a.cfg:9: planner 'vfrrt' is not available: it needs a vector field");
            EXPECT_EQ(errorOf(PLANAR + "[planner]\nsyclopest=\n"),
                      "folder/a.cfg:9: planner 'syclopest' is not available: it plans with controls");
        }

        TEST(ConfigFile, ControlProblemsAreRefusedByName)
        {
            EXPECT_EQ(
                errorOf(PLANAR + "control = kinematic_car\n"),
                "folder/a.cfg:8: problem.control = kinematic_car: control-based problems are not supported; remove "
                "the key to plan geometrically");
        }

        TEST(ConfigFile, RepeatedKeysNameBothLines)
        {
            EXPECT_EQ(errorOf(PLANAR + "start.x = 2\n"),
                      "folder/a.cfg:8: problem.start.x = 2: the key is already set at folder/a.cfg:4");
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\nseed = 1\nseed = 2\n"), "");
            EXPECT_EQ(errorOf(PLANAR + "[planner]\nprm=\nprm.max_nearest_neighbors=9\nprm.max_nearest_neighbors=8\n"),
                      "folder/a.cfg:11: max_nearest_neighbors = 8: the key is already set at folder/a.cfg:10");
            EXPECT_NE(errorOf(PLANAR + "[planner]\nprm=\nproblem.sampler=uniform\nproblem.sampler=gaussian\n"), "");
        }

        TEST(ConfigFile, BadValuesNameWhatIsAccepted)
        {
            EXPECT_EQ(errorOf(PLANAR + "threshold = wide\n"),
                      "folder/a.cfg:8: problem.threshold = wide: expected a number of at least 0");
            EXPECT_EQ(errorOf(PLANAR + "objective = shortest\n"),
                      "folder/a.cfg:8: problem.objective = shortest: expected one of length, max_min_clearance, "
                      "mechanical_work, clearance_cost, weighted");
            EXPECT_EQ(errorOf(PLANAR + "motion_validation = continous\n"),
                      "folder/a.cfg:8: problem.motion_validation = continous: expected one of discrete, continuous");
            EXPECT_EQ(errorOf(PLANAR + "[benchmark]\nsave_paths = best\n"),
                      "folder/a.cfg:9: benchmark.save_paths = best: expected one of none, all, shortest");
            EXPECT_NE(errorOf(PLANAR + "threshold = -1\n"), "");
            EXPECT_NE(errorOf(PLANAR + "name =\n"), "");
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\nseed = 0\n"), "");
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\nrun_count = 0\n"), "");
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\ntime_limit = -1\n"), "");
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\nprogress_interval = 0\n"), "");
            EXPECT_EQ(
                errorOf(PLANAR + "[benchmark]\nprogress_interval = 0.0009\n"),
                "folder/a.cfg:9: benchmark.progress_interval = 0.0009: expected a number of at least 0.001, and of a "
                "millionth of time_limit");
            EXPECT_EQ(errorOf(PLANAR + "[benchmark]\ntime_limit = 1e10\n"),
                      "folder/a.cfg:9: benchmark.time_limit = 1e10: expected a number above 0, at most 1e+09");
            EXPECT_NE(errorOf(PLANAR + "[planner]\nprm = 3\n"), "");
            EXPECT_NE(errorOf(PLANAR + "[planner]\nproblem.sampler = uniform\n"), "");
        }

        TEST(ConfigFile, KeysThatNeedEachOther)
        {
            EXPECT_EQ(errorOf("[problem]\nrobot = disc\nstart.x=0\nstart.y=0\ngoal.x=1\ngoal.y=1\n"),
                      "folder/a.cfg:2: problem.robot = disc: a disc needs problem.robot.radius");
            EXPECT_EQ(errorOf("[problem]\nstart.x=0\nstart.y=0\ngoal.x=1\ngoal.y=1\n"),
                      "folder/a.cfg: problem.robot is missing; give a mesh, scene or .urdf file, point, disc, sphere "
                      "or footprint");
            EXPECT_EQ(errorOf("[problem]\nrobot = point\nstart.x=0\nstart.y=0\ngoal.x=1\n"),
                      "folder/a.cfg: problem.goal.y is missing");
            EXPECT_NE(errorOf("[problem]\nrobot = point\nrobot.radius = 1\nstart.x=0\nstart.y=0\ngoal.x=1\ngoal.y=1\n"),
                      "");
            EXPECT_EQ(errorOf(PLANAR + "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 1\n"),
                      "folder/a.cfg:9: the volume is incomplete: problem.volume.max.y missing; give all of it, or "
                      "nothing to plan in the world's box");
            EXPECT_EQ(errorOf(PLANAR + "volume.min.x = 0\nvolume.min.y = 5\nvolume.max.x = 1\nvolume.max.y = 5\n"),
                      "folder/a.cfg:11: problem.volume.max.y = 5: expected more than problem.volume.min.y");
            EXPECT_NE(errorOf(PLANAR + "turningradius = 1\n"), "");
            EXPECT_NE(errorOf(PLANAR + "statespace = dubins\n"), "");
            EXPECT_NE(errorOf(PLANAR + "rotation_weight = 1\n"), "");
            EXPECT_NE(errorOf(PLANAR + "objective.threshold = 1\n"), "");
            EXPECT_NE(errorOf(PLANAR + "objective = weighted\n"), "");
            EXPECT_NE(errorOf(PLANAR + "objective = length\nobjective.weight.length = 1\n"), "");
        }

        TEST(ConfigFile, ARunHasNoMoreSamplesThanItCanKeep)
        {
            EXPECT_EQ(parse(PLANAR + "[benchmark]\ntime_limit = 1000\n").benchmark.progressInterval, 0.01);
            EXPECT_EQ(parse(PLANAR + "[benchmark]\ntime_limit = 1e9\n").benchmark.progressInterval, 1e4);
            EXPECT_EQ(parse(PLANAR + "[benchmark]\ntime_limit = 1000\nprogress_interval = 0.001\n")
                          .benchmark.progressInterval,
                      0.001);
            EXPECT_NE(errorOf(PLANAR + "[benchmark]\ntime_limit = 2000\nprogress_interval = 0.001\n"), "");
        }

        TEST(ConfigFile, ARotationNeedsAnAxis)
        {
            const std::string pose = PLANAR +
                                     "start.z=0\ngoal.z=0\nstart.axis.x=0\nstart.axis.y=0\nstart.axis.z=0\n"
                                     "goal.axis.x=1\ngoal.axis.y=0\ngoal.axis.z=0\ngoal.theta=1\n";
            EXPECT_EQ(parse(pose + "start.theta=0\n").problem.space, StateSpaceKind::SE3);
            EXPECT_EQ(errorOf(pose + "start.theta=1\n"),
                      "folder/a.cfg:4: the rotation axis is (0, 0, 0); give a direction");
        }

        TEST(ConfigFile, FilesThatCannotBeReadAreNamed)
        {
            EXPECT_EQ(inputErrorOf([] { readBenchmarkConfig("no_such.cfg"); }),
                      "no_such.cfg: cannot be read; expected a benchmark config");
            EXPECT_NE(inputErrorOf([] { readBenchmarkConfig("."); }), "");
        }

        TEST(ConfigFile, ResourcesAreSoughtAsGivenBesideTheConfigAndInTheResourceFolder)
        {
            namespace fs = std::filesystem;
            const fs::path root = fs::temp_directory_path() / ("ompl_mfa_resources_" + std::to_string(::getpid()));
            fs::create_directories(root / "configs");
            fs::create_directories(root / "resources");
            std::ofstream(root / "configs" / "near.dae") << "x";
            std::ofstream(root / "resources" / "far.dae") << "x";
            BenchmarkConfig config = parse(PLANAR);
            config.file = root / "configs" / "a.cfg";
            const auto found = [&config](const std::string &name) {
                return findResource(config, {"world", name, "a.cfg:2"});
            };

            ::unsetenv("OMPL_MFA_RESOURCE_DIR");
            EXPECT_EQ(found((root / "resources" / "far.dae").string()), root / "resources" / "far.dae");
            EXPECT_EQ(found("near.dae"), root / "configs" / "near.dae");
            EXPECT_NE(inputErrorOf([&] { found("far.dae"); }), "");
            EXPECT_NE(inputErrorOf([&] { found(root.string()); }), "") << "a folder is not a file";
            ::setenv("OMPL_MFA_RESOURCE_DIR", ("/nowhere:" + (root / "resources").string()).c_str(), 1);
            EXPECT_EQ(found("far.dae"), root / "resources" / "far.dae");
            ::setenv("OMPL_MFA_RESOURCE_DIR", (root / "resources").c_str(), 1);
            EXPECT_EQ(found("far.dae"), root / "resources" / "far.dae");
            const std::string error = inputErrorOf([&] { found("none.dae"); });
            EXPECT_NE(error.find("a.cfg:2: world = none.dae: no such file"), std::string::npos) << error;
            EXPECT_NE(error.find((root / "resources" / "none.dae").string()), std::string::npos) << error;
            ::unsetenv("OMPL_MFA_RESOURCE_DIR");
            fs::remove_all(root);
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
