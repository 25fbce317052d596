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

#include "CollisionWorlds.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <octomap/octomap.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "ompl_mfa/collision/OccupancyMap.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/SceneLoader.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        template <typename Space>
        ob::StateSpacePtr makeSpace(const std::vector<double> &low, const std::vector<double> &high)
        {
            auto space = std::make_shared<Space>();
            ob::RealVectorBounds bounds(static_cast<unsigned int>(low.size()));
            bounds.low = low;
            bounds.high = high;
            space->setBounds(bounds);
            return space;
        }

        struct Plane : ob::RealVectorStateSpace
        {
            Plane()
              : ob::RealVectorStateSpace(2)
            {
            }
        };

        World makeWorld(const std::string &name, const ob::StateSpacePtr &space, Scene scene, RigidBody robot)
        {
            World world{name, std::make_shared<ob::SpaceInformation>(space), std::make_shared<Scene>(std::move(scene)),
                        nullptr};
            world.checker = std::make_shared<FclStateValidityChecker>(world.si, world.scene, std::move(robot));
            world.si->setStateValidityChecker(world.checker);
            world.si->setStateValidityCheckingResolution(0.01);
            world.si->setup();
            return world;
        }

        fcl::Transform3d randomPose(std::mt19937_64 &random)
        {
            std::uniform_real_distribution<double> coordinate(0., 20.);
            std::normal_distribution<double> normal;
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() << coordinate(random), coordinate(random), coordinate(random);
            pose.linear() = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                                .normalized()
                                .toRotationMatrix();
            return pose;
        }

        Scene primitives(const char *kind, const std::vector<double> &dimensions)
        {
            std::mt19937_64 random(1);
            Scene scene;
            for (int i = 0; i < 60; ++i)
            {
                scene.add({"", makePrimitive(*findPrimitiveKind(kind), dimensions), randomPose(random)});
            }
            return scene;
        }

        // A bumpy ball: a closed surface of 2 * rings * sectors triangles.
        TriangleMesh bumpyBall(double radius, std::size_t rings, std::size_t sectors)
        {
            TriangleMesh mesh;
            for (std::size_t i = 0; i <= rings; ++i)
            {
                const double polar = M_PI * static_cast<double>(i) / static_cast<double>(rings);
                for (std::size_t j = 0; j < sectors; ++j)
                {
                    const double angle = 2. * M_PI * static_cast<double>(j) / static_cast<double>(sectors);
                    const double bump = radius * (1. + 0.2 * std::sin(5. * angle) * std::sin(4. * polar));
                    mesh.vertices.emplace_back(bump * std::sin(polar) * std::cos(angle),
                                               bump * std::sin(polar) * std::sin(angle), bump * std::cos(polar));
                }
            }
            for (std::size_t i = 0; i < rings; ++i)
            {
                for (std::size_t j = 0; j < sectors; ++j)
                {
                    const std::size_t a = i * sectors + j;
                    const std::size_t b = i * sectors + (j + 1) % sectors;
                    mesh.triangles.emplace_back(a, b, a + sectors);
                    mesh.triangles.emplace_back(b, b + sectors, a + sectors);
                }
            }
            return mesh;
        }

        Scene meshes()
        {
            std::mt19937_64 random(2);
            const auto ball = makeMeshGeometry(bumpyBall(1.5, 20, 40));
            Scene scene;
            for (int i = 0; i < 30; ++i)
            {
                scene.add({"", ball, randomPose(random)});
            }
            return scene;
        }

        Scene occupancyMap()
        {
            std::mt19937_64 random(3);
            auto tree = std::make_shared<octomap::OcTree>(0.25);
            for (int i = 0; i < 30; ++i)
            {
                const fcl::Vector3d centre = randomPose(random).translation();
                const int cells = 6;
                for (int cell = 0; cell < cells * cells * cells; ++cell)
                {
                    const fcl::Vector3d point =
                        centre + 0.25 * fcl::Vector3d(cell % cells, (cell / cells) % cells, cell / cells / cells);
                    tree->updateNode(point.x(), point.y(), point.z(), true);
                }
            }
            tree->updateInnerOccupancy();
            tree->prune();
            auto map = std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
            map->computeLocalAABB();
            Scene scene;
            scene.add({"map", map});
            return scene;
        }

        World omplApp(const std::string &folder, const std::string &name, bool planar, const std::vector<double> &low,
                      const std::vector<double> &high)
        {
            const std::filesystem::path meshFolder = std::filesystem::path(folder) / (planar ? "2D" : "3D");
            return makeWorld("OMPL.app " + name,
                             planar ? makeSpace<ob::SE2StateSpace>(low, high) : makeSpace<ob::SE3StateSpace>(low, high),
                             loadScene(meshFolder / (name + "_env.dae")),
                             loadRobot(meshFolder / (name + "_robot.dae"),
                                       planar ? RobotCentring::PlanarVertexMean : RobotCentring::VertexMean));
        }
    }  // namespace

    std::vector<World> makeWorlds(const std::string &omplAppFolder)
    {
        const std::vector<double> low{0., 0., 0.};
        const std::vector<double> high{20., 20., 20.};
        const auto freeFlying = [&low, &high] { return makeSpace<ob::SE3StateSpace>(low, high); };
        const std::string sources = OMPL_MFA_SOURCE_DIR;
        std::vector<World> worlds;
        worlds.push_back(makeWorld("paper scene, point", makeSpace<Plane>({0., 0.}, {20., 20.}),
                                   loadScene(sources + "/benchmarks/worlds/paper_scene.yaml"), RigidBody::sphere(0.)));
        worlds.push_back(makeWorld("paper scene, disc", makeSpace<Plane>({0., 0.}, {20., 20.}),
                                   loadScene(sources + "/benchmarks/worlds/paper_scene.yaml"), RigidBody::sphere(0.3)));
        worlds.push_back(
            makeWorld("60 boxes, box", freeFlying(), primitives("box", {1., 2., 3.}), RigidBody::box(0.5, 1., 1.5)));
        worlds.push_back(makeWorld("60 cylinders, box", freeFlying(), primitives("cylinder", {3., 1.}),
                                   RigidBody::box(0.5, 1., 1.5)));
        worlds.push_back(
            makeWorld("30 meshes of 1600 triangles, box", freeFlying(), meshes(), RigidBody::box(0.5, 1., 1.5)));
        worlds.push_back(makeWorld("30 meshes of 1600 triangles, mesh of 128", freeFlying(), meshes(),
                                   RigidBody({{makeMeshGeometry(bumpyBall(1., 8, 8))}})));
        worlds.push_back(makeWorld("occupancy map, box", freeFlying(), occupancyMap(), RigidBody::box(0.5, 1., 1.5)));
        worlds.push_back(makeWorld("occupancy map, mesh of 128", freeFlying(), occupancyMap(),
                                   RigidBody({{makeMeshGeometry(bumpyBall(1., 8, 8))}})));
        if (std::filesystem::is_directory(omplAppFolder))
        {
            worlds.push_back(
                omplApp(omplAppFolder, "Barriers_easy", true, {0., -440.22998046875}, {661.0222778320312, 0.48742}));
            worlds.push_back(
                omplApp(omplAppFolder, "cubicles", false, {-508.88, -230.13, -123.75}, {319.62, 531.87, 101.}));
            worlds.push_back(
                omplApp(omplAppFolder, "Twistycool", false, {53.46, -21.25, -476.86}, {402.96, 269.25, -91.}));
        }
        return worlds;
    }
}  // namespace ompl_mfa::collision
