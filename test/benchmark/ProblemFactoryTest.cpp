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

#include "ompl_mfa/benchmark/ProblemFactory.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"
#include "ompl_mfa/collision/FclMotionValidator.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;
        namespace fs = std::filesystem;
        using test::inputErrorOf;

        const std::string WALL =
            "world:\n  collision_objects:\n    - id: wall\n"
            "      primitives: [{type: box, dimensions: [1.0, 4.0, 1.0]}]\n"
            "      primitive_poses: [{position: [5.0, 2.0, 0.0], orientation: [0, 0, 0, 1]}]\n";

        const std::string PLANAR =
            "[problem]\nworld = wall.yaml\nrobot = disc\nrobot.radius = 0.5\nstart.x = 1\n"
            "start.y = 2\ngoal.x = 9\ngoal.y = 2\n";

        const std::string VOLUME = "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 10\nvolume.max.y = 10\n";

        class ProblemFactoryTest : public testing::Test
        {
        protected:
            ProblemFactoryTest()
              : folder_(fs::temp_directory_path() / ("ompl_mfa_problem_" + std::to_string(::getpid())))
            {
                fs::create_directories(folder_);
                write("wall.yaml", WALL);
            }

            ~ProblemFactoryTest() override
            {
                fs::remove_all(folder_);
            }

            void write(const std::string &name, const std::string &text) const
            {
                std::ofstream(folder_ / name) << text;
            }

            BenchmarkConfig config(const std::string &text) const
            {
                write("a.cfg", text);
                return readBenchmarkConfig(folder_ / "a.cfg");
            }

            std::string errorOf(const std::string &text) const
            {
                return inputErrorOf([&] { ProblemFactory(config(text)).create(); });
            }

            std::string at(unsigned int line) const
            {
                return (folder_ / "a.cfg").string() + ":" + std::to_string(line) + ": ";
            }

            fs::path folder_;
        };

        double fractionOf(const ompl::geometric::SimpleSetup &setup)
        {
            return setup.getStateSpace()->getLongestValidSegmentFraction();
        }

        TEST_F(ProblemFactoryTest, MakesAReadyPlanarProblem)
        {
            const auto setup = ProblemFactory(config(PLANAR + VOLUME)).create();
            EXPECT_EQ(setup->getStateSpace()->getName(), "R^2");
            EXPECT_EQ(fractionOf(*setup), 0.01);
            EXPECT_EQ(setup->getStateSpace()->getValidSegmentCountFactor(), 1u);
            const auto &si = setup->getSpaceInformation();
            EXPECT_TRUE(si->isSetup());
            ob::ScopedState<> state(si);
            for (const double x : {3.95, 5.0, 6.05})
            {
                state[0] = x;
                state[1] = 2.0;
                EXPECT_EQ(si->isValid(state.get()), std::abs(x - 5.0) > 1.0) << x;
            }
            state[1] = 4.6;
            state[0] = 5.0;
            EXPECT_TRUE(si->isValid(state.get())) << "above the wall and half a metre";
            const auto *goal = setup->getGoal()->as<ob::GoalState>();
            EXPECT_EQ(goal->getThreshold(), 1e-6);
            EXPECT_EQ(goal->getState()->as<ob::RealVectorStateSpace::StateType>()->values[0], 9.0);
            EXPECT_FALSE(setup->getOptimizationObjective());
            EXPECT_TRUE(setup->solve(5.0));
        }

        TEST_F(ProblemFactoryTest, PointRobotsTouchAtTheSurface)
        {
            const auto setup =
                ProblemFactory(config("[problem]\nworld=wall.yaml\nrobot=point\nstart.x=4.49\nstart.y=1\ngoal.x=9\n"
                                      "goal.y=1\n" +
                                      VOLUME))
                    .create();
            EXPECT_NEAR(setup->getStateValidityChecker()->clearance(setup->getProblemDefinition()->getStartState(0)),
                        0.01, 1e-6);
        }

        TEST_F(ProblemFactoryTest, StartAndGoalAreCheckedAndNamed)
        {
            const auto with = [](const std::string &from, const std::string &to)
            {
                std::string text = PLANAR + VOLUME;
                text.replace(text.find(from), from.size(), to);
                return text;
            };
            EXPECT_EQ(errorOf(with("start.x = 1", "start.x = 5")),
                      at(5) + "start (5, 2) is in collision with the world 'wall.yaml'");
            EXPECT_EQ(errorOf(with("goal.x = 9", "goal.x = 5.9"))
                          .rfind(at(7) + "goal (5.9, 2) is in collision with the world 'wall.yaml' by 0.1", 0),
                      0U);
            EXPECT_EQ(errorOf(with("start.y = 2", "start.y = -3")),
                      at(5) + "start (1, -3) is outside the bounds [0, 10] x [0, 10]");
        }

        TEST_F(ProblemFactoryTest, WithoutAVolumeTheWorldsBoxIsEnlargedToHoldStartAndGoal)
        {
            const auto setup = ProblemFactory(config(PLANAR)).create();
            const auto &bounds = setup->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
            EXPECT_EQ(bounds.low[0], 1.0);
            EXPECT_EQ(bounds.high[0], 9.0);
            EXPECT_NEAR(bounds.low[1], 0.0, 1e-9);
            EXPECT_NEAR(bounds.high[1], 4.0, 1e-9);
        }

        TEST_F(ProblemFactoryTest, AProblemWithoutWorldNeedsAVolume)
        {
            const std::string empty = "[problem]\nrobot=point\nstart.x=1\nstart.y=1\ngoal.x=2\ngoal.y=2\n";
            EXPECT_NE(errorOf(empty).find("neither problem.world nor problem.volume.*"), std::string::npos);
            EXPECT_EQ(errorOf(empty + VOLUME), "");
        }

        TEST_F(ProblemFactoryTest, FilesThatCannotBeUsedAreErrorsAndNeverAnEmptyWorld)
        {
            const auto world = [](const std::string &file)
            {
                std::string text = PLANAR + VOLUME;
                text.replace(text.find("wall.yaml"), 9, file);
                return text;
            };
            write("empty.yaml", "");
            write("broken.yaml", "world: [");
            write("negative.yaml",
                  "world:\n  collision_objects:\n    - id: ball\n"
                  "      primitives: [{type: sphere, dimensions: [-1.0]}]\n");
            write("empty.obj", "# nothing\n");
            for (const char *file :
                 {"none.yaml", "none.dae", "empty.yaml", "broken.yaml", "negative.yaml", "empty.obj"})
            {
                const std::string error = errorOf(world(file));
                EXPECT_EQ(error.find(at(2) + "problem.world = " + file + ": "), 0u) << error;
                EXPECT_EQ(error.find('\n'), std::string::npos) << "one line";
            }
            std::string robot = PLANAR + VOLUME;
            robot.replace(robot.find("disc\nrobot.radius = 0.5"), 23, "none.dae");
            EXPECT_EQ(errorOf(robot).find(at(3) + "problem.robot = none.dae: no such file"), 0u);
        }

        TEST_F(ProblemFactoryTest, ContextOfOnePlannerDoesNotReachTheNext)
        {
            const ProblemFactory factory(
                config(PLANAR + VOLUME +
                       "longest_valid_segment_fraction = 0.02\n[planner]\nrrtstar =\n"
                       "problem.longest_valid_segment_fraction = 0.005\n"
                       "problem.sampler = gaussian\nproblem.standard_deviation = 0.25\nprm =\n"));
            const auto first = factory.create(factory.config().planners[0]);
            const auto second = factory.create(factory.config().planners[1]);
            EXPECT_EQ(fractionOf(*first), 0.005);
            EXPECT_EQ(fractionOf(*second), 0.02);
            const auto gaussian = std::dynamic_pointer_cast<ob::GaussianValidStateSampler>(
                first->getSpaceInformation()->allocValidStateSampler());
            ASSERT_TRUE(gaussian);
            EXPECT_EQ(gaussian->getStdDev(), 0.25);
            EXPECT_TRUE(std::dynamic_pointer_cast<ob::UniformValidStateSampler>(
                second->getSpaceInformation()->allocValidStateSampler()));
            EXPECT_TRUE(std::dynamic_pointer_cast<ompl::geometric::RRTstar>(first->getPlanner()));
        }

        TEST_F(ProblemFactoryTest, SegmentFractionsTakeEffect)
        {
            const auto coarse = ProblemFactory(config(PLANAR + VOLUME)).create();
            const auto fine =
                ProblemFactory(config(PLANAR + VOLUME + "longest_valid_segment_fraction = 0.001\n")).create();
            EXPECT_NEAR(coarse->getStateSpace()->getLongestValidSegmentLength() /
                            fine->getStateSpace()->getLongestValidSegmentLength(),
                        10.0, 1e-9);
        }

        TEST_F(ProblemFactoryTest, ContextValuesAreChecked)
        {
            const auto with = [this](const std::string &line) { return errorOf(PLANAR + VOLUME + line + "\n"); };
            EXPECT_EQ(with("sampler = gausian"), at(13) +
                                                     "problem.sampler = gausian: expected one of uniform, gaussian, "
                                                     "obstacle_based, max_clearance, bridge_test");
            for (const char *sampler : {"uniform", "gaussian", "obstacle_based", "max_clearance", "bridge_test"})
            {
                EXPECT_EQ(with(std::string("sampler = ") + sampler), "");
            }
            EXPECT_EQ(with("standard_deviation = 1"),
                      at(13) +
                          "problem.standard_deviation = 1: the sampler 'uniform' has no such setting; gaussian and "
                          "bridge_test have it");
            EXPECT_EQ(with("nr_improve_attempts = 3\nsampler = bridge_test"),
                      at(13) +
                          "problem.nr_improve_attempts = 3: the sampler 'bridge_test' has no such setting; "
                          "max_clearance has it");
            EXPECT_NE(with("nr_attempts = 2.5"), "");
            EXPECT_EQ(with("valid_segment_count_factor = 0"),
                      at(13) + "problem.valid_segment_count_factor = 0: expected a whole number from 1 to 4294967295");
            EXPECT_NE(with("longest_valid_segment_fraction = fine"), "");
            EXPECT_NE(with("longest_valid_segment_fraction = 0"), "");
            EXPECT_EQ(with("longest_valid_segment_fraction = 1.5"),
                      at(13) + "problem.longest_valid_segment_fraction = 1.5: expected a number above 0 and below 1");
            EXPECT_EQ(
                with("projection.cellsize.2 = 1"),
                at(13) + "problem.projection.cellsize.2 = 1: the projection of the space 'R^2' has dimensions 0 to 1");
            EXPECT_EQ(with("projection.cellsize.1 = 1"), "");
        }

        TEST_F(ProblemFactoryTest, SettingsReachSpaceProjectionAndSampler)
        {
            const auto setup = ProblemFactory(config(PLANAR + VOLUME +
                                                     "valid_segment_count_factor = 3\nprojection.cellsize.1 = 0.5\n"
                                                     "projection.cellsize_factor = 4\nsampler = max_clearance\n"
                                                     "nr_attempts = 17\nnr_improve_attempts = 5\n"))
                                   .create();
            EXPECT_EQ(setup->getStateSpace()->getValidSegmentCountFactor(), 3u);
            const auto projection = setup->getStateSpace()->getDefaultProjection();
            EXPECT_NEAR(projection->getCellSizes(0), 4 * 10.0 / 20, 1e-9) << "a twentieth of the bounds, four times";
            EXPECT_NEAR(projection->getCellSizes(1), 4 * 0.5, 1e-9);
            const auto sampler = std::dynamic_pointer_cast<ob::MaximizeClearanceValidStateSampler>(
                setup->getSpaceInformation()->allocValidStateSampler());
            ASSERT_TRUE(sampler);
            EXPECT_EQ(sampler->getNrAttempts(), 17u);
            EXPECT_EQ(sampler->getNrImproveAttempts(), 5u);
        }

        TEST_F(ProblemFactoryTest, CurvedMotionsAreOnlyCheckedAtStates)
        {
            EXPECT_EQ(errorOf(PLANAR + VOLUME +
                              "start.theta = 0\ngoal.theta = 0\nstatespace = dubins\n"
                              "motion_validation = continuous\n"),
                      at(16) +
                          "problem.motion_validation = continuous: the motions of the space 'Dubins' are curved, and "
                          "continuous validation is for straight ones; expected discrete");
        }

        TEST_F(ProblemFactoryTest, MotionValidationIsTheConfigs)
        {
            using collision::FclMotionValidator;
            const auto continuous =
                ProblemFactory(config(PLANAR + VOLUME + "motion_validation = continuous\n")).create();
            const auto discrete = ProblemFactory(config(PLANAR + VOLUME)).create();
            const auto isContinuous = [](const ompl::geometric::SimpleSetup &setup)
            {
                return static_cast<bool>(
                    std::dynamic_pointer_cast<FclMotionValidator>(setup.getSpaceInformation()->getMotionValidator()));
            };
            EXPECT_TRUE(isContinuous(*continuous));
            EXPECT_FALSE(isContinuous(*discrete));
        }

        TEST_F(ProblemFactoryTest, TheInsideOfAMeshIsFreeOrSolid)
        {
            std::string mesh;
            for (const char *corner : {"2 2", "8 2", "8 8", "2 8"})
            {
                mesh += "v " + std::string(corner) + " -3\nv " + corner + " 3\n";
            }
            const char *const faces[] = {"1 3 4", "1 4 2", "3 5 6", "3 6 4", "5 7 8", "5 8 6",
                                         "7 1 2", "7 2 8", "1 5 3", "1 7 5", "2 4 6", "2 6 8"};
            for (const char *face : faces)
            {
                mesh += std::string("f ") + face + "\n";
            }
            write("box.obj", mesh);
            write("open.obj", mesh.substr(0, mesh.rfind("f ")));
            const auto inside = [this](const std::string &world, const std::string &line)
            {
                return errorOf("[problem]\nworld=" + world +
                               "\nrobot=disc\nrobot.radius=0.5\nstart.x=5\nstart.y=5\n"
                               "goal.x=1\ngoal.y=1\n" +
                               VOLUME + line);
            };
            EXPECT_EQ(inside("box.obj", ""), "") << "as in OMPL.app";
            EXPECT_EQ(inside("box.obj", "mesh_interior = free\n"), "");
            EXPECT_NE(inside("box.obj", "mesh_interior = solid\n").find("start (5, 5) is in collision"),
                      std::string::npos);
            EXPECT_EQ(inside("open.obj", "mesh_interior = free\n"), "");
            EXPECT_EQ(inside("open.obj", "mesh_interior = solid\n").find(at(2) + "problem.world = open.obj: "), 0u);
            EXPECT_NE(inside("box.obj", "mesh_interior = hollow\n"), "");
        }

        TEST_F(ProblemFactoryTest, SeedZeroIsRefused)
        {
            EXPECT_NE(inputErrorOf([] { setRandomSeed(0); }), "");
        }

        fs::path omplapp()
        {
            const char *folder = std::getenv("OMPL_MFA_OMPLAPP_DIR");
            return folder ? fs::path(folder) : fs::path(OMPL_MFA_SOURCE_DIR) / ".." / "shared" / "omplapp";
        }

        TEST(OmplApp, EveryConfigMakesAProblemWithAllItsPlanners)
        {
            if (!fs::exists(omplapp()))
            {
                GTEST_SKIP() << omplapp() << " is not there";
            }
            for (const char *name : {"2D/Barriers", "2D/RandomPolygons_planar", "3D/Easy", "3D/Twistycool",
                                     "3D/cubicles", "3D/cubicles_opt"})
            {
                const ProblemFactory factory(readBenchmarkConfig(omplapp() / (std::string(name) + ".cfg")));
                EXPECT_FALSE(factory.config().planners.empty()) << name;
                for (const auto &spec : factory.config().planners)
                {
                    const auto setup = factory.create(spec);
                    EXPECT_NO_THROW(setup->setup()) << name << ", " << spec.name;
                    EXPECT_EQ(setup->getPlanner()->getName(), spec.name) << name;
                }
            }
        }

        TEST(OmplApp, PathsShippedWithTheProblemsAreValidInOurs)
        {
            if (!fs::exists(omplapp()))
            {
                GTEST_SKIP() << omplapp() << " is not there";
            }
            for (const char *name :
                 {"2D/Barriers", "2D/RandomPolygons_planar", "3D/Easy", "3D/Twistycool", "3D/cubicles"})
            {
                const auto setup =
                    ProblemFactory(readBenchmarkConfig(omplapp() / (std::string(name) + ".cfg"))).create();
                std::ifstream in(omplapp() / (std::string(name) + ".path"));
                ob::ScopedState<> state(setup->getStateSpace());
                std::vector<double> values(setup->getStateSpace()->getDimension() == 6 ? 7 : 3);
                unsigned int states = 0;
                while (std::all_of(values.begin(), values.end(), [&in](double &value) { return bool(in >> value); }))
                {
                    setup->getStateSpace()->copyFromReals(state.get(), values);
                    setup->getStateSpace()->enforceBounds(state.get());
                    EXPECT_TRUE(setup->getSpaceInformation()->isValid(state.get())) << name << ", state " << states;
                    ++states;
                }
                EXPECT_GT(states, 2u) << name;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
