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

/* Meshes of planning scenes: their scale, their axes and where they are sought. */

#include <cstdlib>
#include <filesystem>
#include <string>

#include "collision/PlanningSceneFixture.h"
#include "collision/TestFiles.h"
#include "ompl_mfa/collision/PlanningScene.h"

namespace ompl_mfa::collision
{
    namespace
    {
        class SceneMeshesTest : public PlanningSceneTest
        {
        };

        TEST_F(SceneMeshesTest, AreScaledByTheirDimensions)
        {
            folder_.write("cube.obj", cubeObj());
            const Scene scene = loadObject("      meshes: [{resource: cube.obj, dimensions: [2, 3, 4]}]\n");
            EXPECT_TRUE(scene.bounds().max_.isApprox(fcl::Vector3d(1., 1.5, 2.)));
            expectObjectFault("      meshes: [{resource: cube.obj, dimensions: [2, 3, 4], scale: 2}]\n", ":4",
                              "dimensions", "scale");
            expectObjectFault("      meshes: [{resource: cube.obj, dimensions: [2, 0, 4]}]\n", ":4", "dimensions",
                              "greater than 0");
        }

        class MeshResourceTest : public PlanningSceneTest
        {
        protected:
            MeshResourceTest()
            {
                std::filesystem::create_directories(folder_.path() / "scenes");
                std::filesystem::create_directories(folder_.path() / "my_robot" / "meshes dir");
                folder_.write("my_robot/meshes dir/cube.obj", cubeObj());
                unsetenv("OMPL_MFA_RESOURCE_DIR");
            }

            ~MeshResourceTest() override
            {
                unsetenv("OMPL_MFA_RESOURCE_DIR");
            }

            std::filesystem::path sceneOf(const std::string &resource) const
            {
                return folder_.write(
                    "scenes/scene.yaml",
                    "world:\n  collision_objects:\n    - id: thing\n      meshes: [{resource: '" + resource + "'}]\n");
            }
        };

        TEST_F(MeshResourceTest, AreSoughtInPackageFolders)
        {
            const auto scene = sceneOf("package://my_robot/meshes dir/cube.obj");
            expectInputError([&] { loadPlanningScene(scene); }, "scene.yaml:4", "resource",
                             "package://my_robot/meshes dir/cube.obj", "sought", "OMPL_MFA_RESOURCE_DIR");
            setenv("OMPL_MFA_RESOURCE_DIR", ("/nowhere:" + folder_.path().string()).c_str(), 1);
            EXPECT_EQ(loadPlanningScene(scene).objects().size(), 1U);
            // The folder of the package itself may be given too.
            setenv("OMPL_MFA_RESOURCE_DIR", (folder_.path() / "my_robot").c_str(), 1);
            EXPECT_EQ(loadPlanningScene(scene).objects().size(), 1U);
        }

        TEST_F(MeshResourceTest, MayBeAddresses)
        {
            const std::string folder = folder_.path().string();
            EXPECT_EQ(
                loadPlanningScene(sceneOf("file://" + folder + "/my_robot/meshes%20dir/cube.obj")).objects().size(),
                1U);
            EXPECT_EQ(loadPlanningScene(sceneOf("../my_robot/meshes dir/cube.obj")).objects().size(), 1U);
            expectInputError([&] { loadPlanningScene(sceneOf("http://example.org/cube.obj")); }, "scene.yaml:4", "http",
                             "package://");
            expectInputError([&] { loadPlanningScene(sceneOf("package://my_robot")); }, "scene.yaml:4", "package://");
        }

        // A pillar of height 4 along z, in metres or in another unit, with the up axis that its tool declares.
        std::string pillarDae(const std::string &up, const std::string &metres)
        {
            return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="u" meter=")" +
                   metres + R"("/><up_axis>)" + up + R"(</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 4</float_array>
   <technique_common><accessor source="#a" count="4" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s">
  <node id="n"><translate>10 0 0</translate><instance_geometry url="#g"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)";
        }

        TEST_F(SceneMeshesTest, StayUprightAsInMoveIt)
        {
            for (const std::string up : {"X_UP", "Y_UP", "Z_UP"})
            {
                for (const std::string metres : {"1", "0.001"})
                {
                    folder_.write("pillar.dae", pillarDae(up, metres));
                    const Scene scene = loadObject("      meshes: [{resource: pillar.dae}]\n");
                    EXPECT_TRUE(scene.bounds().min_.isApprox(fcl::Vector3d(10., 0., 0.)))
                        << up << ' ' << metres << ": " << scene.bounds().min_.transpose();
                    EXPECT_TRUE(scene.bounds().max_.isApprox(fcl::Vector3d(11., 1., 4.)))
                        << up << ' ' << metres << ": " << scene.bounds().max_.transpose();
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::collision
