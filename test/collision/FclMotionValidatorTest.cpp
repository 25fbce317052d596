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

#include "ompl_mfa/collision/FclMotionValidator.h"

#include <algorithm>
#include <limits>

#include <fcl/geometry/shape/box.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "collision/OmplAppProblems.h"
#include "collision/RandomScenes.h"
#include "collision/TestFiles.h"

namespace ompl_mfa::collision
{
    namespace
    {
        ob::StateSpacePtr plane(double extent)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(2);
            space->setBounds(-extent, extent);
            return space;
        }

        template <typename Space>
        ob::StateSpacePtr rigid(unsigned int dimension, double extent)
        {
            auto space = std::make_shared<Space>();
            ob::RealVectorBounds bounds(dimension);
            bounds.setLow(-extent);
            bounds.setHigh(extent);
            space->setBounds(bounds);
            return space;
        }

        // A space with a scene and robots, and two motion validators for it.
        struct Setting
        {
            Setting(const ob::StateSpacePtr &space, Scene scene, std::vector<RigidBody> robots)
              : si(std::make_shared<ob::SpaceInformation>(space))
              , checker(std::make_shared<FclStateValidityChecker>(si, std::make_shared<Scene>(std::move(scene)),
                                                                  std::move(robots)))
            {
                si->setStateValidityChecker(checker);
                si->setup();
                continuous = std::make_shared<FclMotionValidator>(si, checker);
                discrete = std::make_shared<ob::DiscreteMotionValidator>(si);
            }

            ob::SpaceInformationPtr si;
            std::shared_ptr<FclStateValidityChecker> checker;
            std::shared_ptr<FclMotionValidator> continuous;
            std::shared_ptr<ob::DiscreteMotionValidator> discrete;
        };

        Scene single(std::shared_ptr<fcl::CollisionGeometryd> geometry,
                     const fcl::Vector3d &position = fcl::Vector3d::Zero())
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = position;
            Scene scene;
            scene.add({"obstacle", std::move(geometry), pose});
            return scene;
        }

        ob::ScopedState<> at(const Setting &setting, const std::vector<double> &coordinates)
        {
            ob::ScopedState<> state(setting.si->getStateSpace());
            state = coordinates;
            return state;
        }

        constexpr double THIN = 1e-6;

        // The square of side 40 across x = 0, as two triangles.
        std::shared_ptr<fcl::CollisionGeometryd> sheet()
        {
            TriangleMesh mesh;
            mesh.vertices = {{0., -20., -20.}, {0., 20., -20.}, {0., 20., 20.}, {0., -20., 20.}};
            mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
            return makeMeshGeometry(mesh);
        }

        struct ThinWall
        {
            const char *name;
            std::shared_ptr<fcl::CollisionGeometryd> wall;
            RigidBody robot;
            int motions;
        };

        // Motions between the two sides of a wall that fills the space: each of them crosses it.
        TEST(FclMotionValidator, NeverCrossesAThinWall)
        {
            const std::vector<ThinWall> walls{
                {"box, box", std::make_shared<fcl::Boxd>(THIN, 40., 40.), RigidBody::box(0.3, 0.2, 0.1), 100000},
                {"box, mesh", std::make_shared<fcl::Boxd>(THIN, 40., 40.),
                 RigidBody({{makeMeshGeometry(boxMesh({0.3, 0.2, 0.1}))}}), 10000},
                {"mesh, box", sheet(), RigidBody::box(0.3, 0.2, 0.1), 10000},
                {"mesh, mesh", sheet(), RigidBody({{makeMeshGeometry(boxMesh({0.3, 0.2, 0.1}))}}), 10000},
            };
            for (const ThinWall &wall : walls)
            {
                const Setting setting(rigid<ob::SE3StateSpace>(3, 10.), single(wall.wall), {wall.robot});
                const ob::StateSamplerPtr sampler = setting.si->allocStateSampler();
                ob::ScopedState<ob::SE3StateSpace> from(setting.si->getStateSpace());
                ob::ScopedState<ob::SE3StateSpace> to(setting.si->getStateSpace());
                int missed = 0;
                for (int crossings = 0; crossings < wall.motions;)
                {
                    sampler->sampleUniform(from.get());
                    sampler->sampleUniform(to.get());
                    from->setX(std::abs(from->getX()));
                    to->setX(-std::abs(to->getX()));
                    if (!setting.si->isValid(from.get()) || !setting.si->isValid(to.get()))
                    {
                        continue;
                    }
                    ++crossings;
                    ASSERT_FALSE(setting.continuous->checkMotion(from.get(), to.get())) << wall.name;
                    // The discrete validator is only called until it has missed some.
                    missed += missed < 10 && setting.discrete->checkMotion(from.get(), to.get()) ? 1 : 0;
                }
                EXPECT_GT(missed, 0) << wall.name;
            }
        }

        // A disc moves freely along a wall: motions that keep clear of it are valid.
        TEST(FclMotionValidator, RefusesNoFreeMotion)
        {
            const double radius = 0.4;
            const Setting setting(plane(10.), single(std::make_shared<fcl::Boxd>(THIN, 100., 2.)),
                                  {RigidBody::sphere(radius)});
            Random random(2);
            for (int i = 0; i < 20000; ++i)
            {
                const double near = radius + std::pow(10., random.uniform(-4., 0.));
                const auto from = at(setting, {near, random.uniform(-10., 10.)});
                const auto to = at(setting, {radius + random.uniform(1e-4, 5.), random.uniform(-10., 10.)});
                EXPECT_TRUE(setting.continuous->checkMotion(from.get(), to.get())) << near;
            }
        }

        // A disc among discs: the motion is a segment, whose distance to a centre is known.
        TEST(FclMotionValidator, DiscsAgreeWithTheDistanceOfTheSegment)
        {
            Random random(3);
            Scene scene;
            std::vector<std::pair<Eigen::Vector2d, double>> discs;
            for (int i = 0; i < 20; ++i)
            {
                discs.emplace_back(random.point(10.).head<2>(), random.uniform(0.1, 1.5));
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation().head<2>() = discs.back().first;
                scene.add({"", makePrimitive(*findPrimitiveKind("cylinder"), {2., discs.back().second}), pose});
            }
            const double radius = 0.3;
            const Setting setting(plane(10.), scene, {RigidBody::sphere(radius)});
            int valid = 0;
            for (int i = 0; i < 20000; ++i)
            {
                const Eigen::Vector2d a = random.point(10.).head<2>();
                const Eigen::Vector2d b = random.point(10.).head<2>();
                double gap = std::numeric_limits<double>::infinity();
                for (const auto &[centre, size] : discs)
                {
                    const double share = std::clamp((centre - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
                    gap = std::min(gap, (a + share * (b - a) - centre).norm() - size - radius);
                }
                const auto from = at(setting, {a.x(), a.y()});
                const auto to = at(setting, {b.x(), b.y()});
                if (std::abs(gap) > 1e-4 && setting.si->isValid(from.get()))
                {
                    EXPECT_EQ(setting.continuous->checkMotion(from.get(), to.get()), gap > 0.) << gap;
                    valid += gap > 0. ? 1 : 0;
                }
            }
            EXPECT_GT(valid, 1000);
        }

        // A rod that makes half a turn about its end sweeps a post that is far from it at both ends of the motion.
        TEST(FclMotionValidator, SeesWhatARotationSweeps)
        {
            fcl::Transform3d outward = fcl::Transform3d::Identity();
            outward.translation().x() = 2.5;
            for (const bool asMesh : {false, true})
            {
                const fcl::Vector3d rodSide(5., 0.01, 0.01);
                std::shared_ptr<fcl::CollisionGeometryd> rod = std::make_shared<fcl::Boxd>(rodSide);
                if (asMesh)
                {
                    rod = makeMeshGeometry(boxMesh(rodSide));
                }
                const RigidBody robot({{rod, outward}});
                const auto post = std::make_shared<fcl::Boxd>(THIN, THIN, 1.);
                const Setting setting(rigid<ob::SE2StateSpace>(2, 10.), single(post, {0., 4., 0.}), {robot});
                const auto from = at(setting, {0., 0., 0.});
                const auto to = at(setting, {0., 0., 3.});
                EXPECT_FALSE(setting.continuous->checkMotion(from.get(), to.get()));
                EXPECT_TRUE(setting.discrete->checkMotion(from.get(), to.get()));
                const Setting beyond(rigid<ob::SE2StateSpace>(2, 10.), single(post, {0., 5.01, 0.}), {robot});
                EXPECT_TRUE(beyond.continuous->checkMotion(from.get(), to.get()));
                // The shorter rotation goes the other way round.
                EXPECT_TRUE(setting.continuous->checkMotion(from.get(), at(setting, {0., 0., -3.}).get()));
            }
        }

        TEST(FclMotionValidator, FillsLastValid)
        {
            const std::vector<std::shared_ptr<fcl::CollisionGeometryd>> walls{
                std::make_shared<fcl::Boxd>(THIN, 40., 40.), sheet()};
            for (const auto &wall : walls)
            {
                const Setting setting(plane(10.), single(wall), {RigidBody::sphere(0.5)});
                const auto from = at(setting, {-8., 1.});
                const auto to = at(setting, {8., 1.});
                ob::ScopedState<> last(setting.si->getStateSpace());
                std::pair<ob::State *, double> lastValid(last.get(), -1.);
                EXPECT_FALSE(setting.continuous->checkMotion(from.get(), to.get(), lastValid));
                EXPECT_LT(lastValid.second, 7.5 / 16.);
                EXPECT_GT(lastValid.second, 7.5 / 16. - 1e-3);
                EXPECT_NEAR(last[0], -8. + 16. * lastValid.second, 1e-12);
                EXPECT_TRUE(setting.si->isValid(last.get()));
                EXPECT_TRUE(setting.continuous->checkMotion(from.get(), last.get()));
                // Callers may leave out the state.
                lastValid = {nullptr, -1.};
                EXPECT_FALSE(setting.continuous->checkMotion(from.get(), to.get(), lastValid));
                EXPECT_GT(lastValid.second, 0.4);
                // A valid motion does not change it.
                lastValid = {nullptr, -1.};
                EXPECT_TRUE(setting.continuous->checkMotion(from.get(), at(setting, {-8., 5.}).get(), lastValid));
                EXPECT_EQ(lastValid.second, -1.);
            }
        }

        TEST(FclMotionValidator, StopsAtTheBounds)
        {
            const Setting setting(plane(10.), Scene(), {RigidBody::sphere(0.5)});
            const auto from = at(setting, {0., 0.});
            const auto to = at(setting, {40., 0.});
            ob::ScopedState<> last(setting.si->getStateSpace());
            std::pair<ob::State *, double> lastValid(last.get(), -1.);
            EXPECT_FALSE(setting.continuous->checkMotion(from.get(), to.get()));
            EXPECT_FALSE(setting.continuous->checkMotion(from.get(), to.get(), lastValid));
            EXPECT_NEAR(lastValid.second, 0.25, 1e-6);
            EXPECT_TRUE(setting.si->isValid(last.get()));
        }

        // Two discs that swap places: their least distance is that of their relative motion to the origin.
        TEST(FclMotionValidator, ChecksBodiesAgainstEachOther)
        {
            auto space = std::make_shared<ob::CompoundStateSpace>();
            space->addSubspace(plane(10.), 1.);
            space->addSubspace(plane(10.), 1.);
            const double first = 0.5;
            const double second = 1.;
            const Setting setting(space, Scene(), {RigidBody::sphere(first), RigidBody::sphere(second)});
            Random random(4);
            int valid = 0;
            int invalid = 0;
            for (int i = 0; i < 5000; ++i)
            {
                const Eigen::Vector2d a0 = random.point(5.).head<2>();
                const Eigen::Vector2d a1 = random.point(5.).head<2>();
                const Eigen::Vector2d b0 = random.point(5.).head<2>();
                const Eigen::Vector2d b1 = random.point(5.).head<2>();
                const Eigen::Vector2d start = a0 - b0;
                const Eigen::Vector2d change = (a1 - b1) - start;
                const double share = std::clamp(-start.dot(change) / change.squaredNorm(), 0., 1.);
                const double gap = (start + share * change).norm() - first - second;
                const auto from = at(setting, {a0.x(), a0.y(), b0.x(), b0.y()});
                const auto to = at(setting, {a1.x(), a1.y(), b1.x(), b1.y()});
                if (std::abs(gap) > 1e-4 && setting.si->isValid(from.get()))
                {
                    EXPECT_EQ(setting.continuous->checkMotion(from.get(), to.get()), gap > 0.) << gap;
                    ++(gap > 0. ? valid : invalid);
                }
            }
            EXPECT_GT(valid, 500);
            EXPECT_GT(invalid, 500);
        }

        TEST(FclMotionValidator, IsSelected)
        {
            const Setting setting(plane(10.), Scene(), {RigidBody::sphere(0.5)});
            setCollisionChecking(setting.si, setting.checker, MotionValidation::Continuous);
            EXPECT_NE(dynamic_cast<FclMotionValidator *>(setting.si->getMotionValidator().get()), nullptr);
            setCollisionChecking(setting.si, setting.checker, MotionValidation::Discrete);
            EXPECT_NE(dynamic_cast<ob::DiscreteMotionValidator *>(setting.si->getMotionValidator().get()), nullptr);
        }

        TEST(FclMotionValidator, RefusesSpacesThatCurve)
        {
            const auto si = std::make_shared<ob::SpaceInformation>(rigid<ob::DubinsStateSpace>(2, 10.));
            const auto checker =
                std::make_shared<FclStateValidityChecker>(si, std::make_shared<Scene>(), RigidBody::sphere(0.5));
            expectInputError([&] { FclMotionValidator(si, checker); }, "curved", "expected discrete");
        }

        // Whether one of many states between two collides; if none does, the motion may still collide.
        bool someStateCollides(const OmplAppWorld &world, const ob::ScopedState<> &from, const ob::ScopedState<> &to)
        {
            ob::ScopedState<> between(from);
            constexpr int STATES = 1000;
            for (int i = 1; i < STATES; ++i)
            {
                world.si()->getStateSpace()->interpolate(from.get(), to.get(), double(i) / STATES, between.get());
                world.si()->enforceBounds(between.get());
                if (!world.checker()->isValid(between.get()))
                {
                    return true;
                }
            }
            return false;
        }

        std::vector<std::size_t> refusedMotions(const ob::MotionValidator &validator,
                                                const std::vector<ob::ScopedState<>> &path)
        {
            std::vector<std::size_t> refused;
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                if (!validator.checkMotion(path[i - 1].get(), path[i].get()))
                {
                    refused.push_back(i);
                }
            }
            return refused;
        }

        // OMPL.app found these paths with discrete checks at 0.01 of the space. In motion 82 of Barriers.path that is
        // two segments of 1.9 between valid states; a corner of the robot is inside a barrier over 39% of the motion,
        // which checks at 0.005 (three segments) detect, and a continuous check must.
        TEST_P(OmplAppTest, ShippedPathIsValidStateByStateAndMotionByMotion)
        {
            const OmplAppProblem &problem = GetParam();
            const OmplAppWorld world(problem);
            std::vector<ob::ScopedState<>> path;
            for (const std::vector<double> &row :
                 readRows(omplAppFolder() / problem.folder / (std::string(problem.name) + ".path")))
            {
                path.push_back(world.state(row));
                EXPECT_TRUE(world.si()->isValid(path.back().get())) << "state " << path.size() - 1;
            }
            ASSERT_GT(path.size(), 2U);
            EXPECT_DOUBLE_EQ(world.si()->getStateValidityCheckingResolution(), 0.01);
            EXPECT_EQ(refusedMotions(*world.si()->getMotionValidator(), path), std::vector<std::size_t>{});

            const std::vector<std::size_t> refused =
                refusedMotions(FclMotionValidator(world.si(), world.checker()), path);
            EXPECT_EQ(refused, std::string(problem.name) == "Barriers" ? std::vector<std::size_t>{82}
                                                                       : std::vector<std::size_t>{});
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                const bool isRefused = std::find(refused.begin(), refused.end(), i) != refused.end();
                EXPECT_EQ(isRefused, someStateCollides(world, path[i - 1], path[i])) << "motion " << i;
            }
            world.si()->setStateValidityCheckingResolution(0.005);
            world.si()->setup();
            EXPECT_EQ(refusedMotions(*world.si()->getMotionValidator(), path), refused);
        }

        INSTANTIATE_TEST_SUITE_P(OmplApp, OmplAppTest, ::testing::ValuesIn(omplAppProblems()), problemName);
    }  // namespace
}  // namespace ompl_mfa::collision
