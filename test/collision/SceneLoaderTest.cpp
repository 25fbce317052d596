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

#include "ompl_mfa/collision/SceneLoader.h"

#include <octomap/octomap.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        const std::string SPHERE_SCENE =
            "world:\n  collision_objects:\n    - id: ball\n      primitives:\n"
            "        - {type: sphere, dimensions: [1]}\n"
            "        - {type: box, dimensions: [1, 1, 1]}\n"
            "      primitive_poses: [{position: [3, 0, 0]}, {position: [0, 2, 0]}]\n";

        TEST(SceneLoader, SelectsTheReaderByTheExtension)
        {
            const TemporaryFolder folder;
            octomap::OcTree tree(0.5);
            tree.updateNode(1., 1., 1., true);
            tree.writeBinary((folder.path() / "map.bt").string());
            EXPECT_EQ(loadScene(folder.write("scene.YML", SPHERE_SCENE)).objects().size(), 2U);
            EXPECT_EQ(loadScene(folder.path() / "map.bt").objects()[0].geometry->getNodeType(), fcl::GEOM_OCTREE);
            const Scene mesh = loadScene(folder.write("cube.obj", cubeObj()));
            EXPECT_EQ(mesh.objects()[0].geometry->getNodeType(), fcl::BV_OBBRSS);
            EXPECT_EQ(mesh.objects()[0].id, "cube");
            expectInputError([&folder] { loadScene(folder.path() / "none.yaml"); }, "none.yaml", "not found");
        }

        fcl::Vector3d centreOf(const RigidBody &body)
        {
            const auto &mesh = static_cast<const MeshGeometry &>(*body.shapes().front().geometry);
            fcl::AABBd box;
            for (int i = 0; i < mesh.num_vertices; ++i)
            {
                box += mesh.vertices[i];
            }
            return box.center();
        }

        TEST(SceneLoader, CentresRobotMeshesAsOmplApp)
        {
            const TemporaryFolder folder;
            const auto file = folder.write("shifted.obj", "v 1 1 1\nv 3 1 1\nv 1 3 1\nv 1 1 3\nf 1 2 3\nf 1 2 4\n");
            const fcl::Vector3d box(2., 2., 2.);
            const fcl::Vector3d mean = loadMesh(file).vertexMean;
            EXPECT_TRUE(centreOf(loadRobot(file, RobotCentring::None)).isApprox(box));
            EXPECT_TRUE(centreOf(loadRobot(file, RobotCentring::VertexMean)).isApprox(box - mean));
            EXPECT_TRUE(centreOf(loadRobot(file, RobotCentring::PlanarVertexMean))
                            .isApprox(box - fcl::Vector3d(mean.x(), mean.y(), 0.)));
        }

        TEST(SceneLoader, TakesAPlanningSceneAsARobotOfSeveralShapes)
        {
            const TemporaryFolder folder;
            const RigidBody robot = loadRobot(folder.write("robot.yaml", SPHERE_SCENE), RobotCentring::VertexMean);
            ASSERT_EQ(robot.shapes().size(), 2U);
            EXPECT_DOUBLE_EQ(robot.radius(), 4.);
            expectInputError([&folder] { loadRobot(folder.path() / "none.dae", RobotCentring::None); }, "none.dae",
                             "robot file not found");
            expectInputError([&folder] { loadRobot(folder.write("map.bt", ""), RobotCentring::None); }, "map.bt",
                             "cannot be a robot");
        }

        TEST(SceneLoader, ListsTheKindsThatItReads)
        {
            const TemporaryFolder folder;
            for (const std::string name : {"robot.urdf", "map.pgm", "world.json", "world", "cloud.pcd", "scene.YAM"})
            {
                const auto file = folder.write(name, "<robot name='r'/>");
                expectInputError([&file] { loadScene(file); }, name, "unknown kind", ".yaml", ".yml", ".scene", ".bt",
                                 ".ot", ".dae", ".obj", ".stl", ".ply");
                expectInputError([&file] { loadRobot(file, RobotCentring::None); }, name, "unknown kind", ".yaml",
                                 ".scene", ".dae");
            }
            // Files with an extension that assimp reads are meshes, in upper and lower case.
            expectInputError([&folder] { loadScene(folder.write("broken.DAE", "x")); }, "not a readable mesh");
        }

        TEST(SceneLoader, PassesTheNumberOfSkippedFacesOn)
        {
            const TemporaryFolder folder;
            const auto mesh = folder.write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\np 1\nl 1 2 3\n");
            EXPECT_EQ(loadScene(mesh).skippedFaces(), 3U);
            EXPECT_EQ(loadRobot(mesh, RobotCentring::None).skippedFaces(), 3U);
            const auto scene = folder.write("scene.yaml",
                                            "world:\n  collision_objects:\n  - id: a\n"
                                            "    meshes: [{resource: mixed.obj}, {resource: mixed.obj}]\n");
            EXPECT_EQ(loadScene(scene).skippedFaces(), 6U);
            EXPECT_EQ(loadScene(scene).objects()[1].skippedFaces, 3U);
            EXPECT_EQ(loadRobot(scene, RobotCentring::None).skippedFaces(), 6U);
        }

        TEST(SceneLoader, SeeksMeshesInTheFoldersThatItIsGiven)
        {
            const TemporaryFolder folder;
            const TemporaryFolder elsewhere;
            std::filesystem::create_directories(elsewhere.path() / "kitchen" / "meshes");
            elsewhere.write("kitchen/meshes/cube.obj", cubeObj());
            const auto scene = folder.write("scene.yaml",
                                            "world:\n  collision_objects:\n  - id: a\n"
                                            "    meshes: [{resource: 'package://kitchen/meshes/cube.obj'}]\n");
            EXPECT_EQ(loadScene(scene, {elsewhere.path()}).objects().size(), 1U);
            EXPECT_EQ(loadRobot(scene, RobotCentring::None, {elsewhere.path() / "kitchen/"}).shapes().size(), 1U);
            expectInputError([&] { loadScene(scene, {folder.path()}); }, "scene.yaml:4", "package://kitchen", "sought");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
