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

#include "ompl_mfa/collision/PlanningScene.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>
#include <octomap/ColorOcTree.h>
#include <octomap/octomap.h>

#include "collision/PlanningSceneFixture.h"
#include "collision/TestFiles.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST_F(PlanningSceneTest, ReadsPrimitivesInBothSpellingsOfMoveIt)
        {
            const Scene scene = load(
                "name: (noname)+\nis_diff: false\nrobot_state: {joint_state: {}}\n"
                "world:\n"
                "  collision_objects:\n"
                "    - id: table\n"
                "      operation: 0\n"
                "      primitives:\n"
                "        - {type: box, dimensions: [1, 2, 3]}\n"
                "        - {type: 2, dimensions: [0.25]}\n"
                "      primitive_poses:\n"
                "        - {position: [1, 2, 3], orientation: [0, 0, 2, 2]}\n"
                "        - position: {x: -1, y: 0, z: 0}\n"
                "          orientation: {x: 0, y: 0, z: 0, w: 1}\n"
                "    - id: post\n"
                "      primitives: [{type: Cylinder, dimensions: [4, 0.5]}]\n");
            ASSERT_EQ(scene.objects().size(), 3U);
            EXPECT_EQ(scene.objects()[0].id, "table");
            EXPECT_EQ(scene.objects()[2].id, "post");
            EXPECT_EQ(static_cast<const fcl::Boxd &>(*scene.objects()[0].geometry).side, fcl::Vector3d(1., 2., 3.));
            EXPECT_EQ(scene.objects()[0].pose.translation(), fcl::Vector3d(1., 2., 3.));
            // A quarter turn about z, not normalised in the file.
            EXPECT_TRUE((scene.objects()[0].pose.linear() * fcl::Vector3d::UnitX()).isApprox(fcl::Vector3d::UnitY()));
            EXPECT_EQ(static_cast<const fcl::Sphered &>(*scene.objects()[1].geometry).radius, 0.25);
            EXPECT_EQ(scene.objects()[1].pose.translation(), fcl::Vector3d(-1., 0., 0.));
            EXPECT_TRUE(scene.objects()[2].pose.matrix().isIdentity());
        }

        TEST_F(PlanningSceneTest, PlacesShapesInTheirObject)
        {
            const Scene scene = loadObject(
                "      pose: {position: [10, 0, 0], orientation: [0, 0, 1, 1]}\n"
                "      primitives: [{type: sphere, dimensions: [1]}]\n"
                "      primitive_poses: [{position: [2, 0, 0]}]\n");
            EXPECT_TRUE(scene.objects()[0].pose.translation().isApprox(fcl::Vector3d(10., 2., 0.)));
        }

        TEST_F(PlanningSceneTest, ReadsMeshesBesideTheSceneAndInIt)
        {
            folder_.write("cube.obj", cubeObj());
            const Scene scene = loadObject(
                "      meshes:\n"
                "        - {resource: cube.obj, scale: [2, 1, 1]}\n"
                "        - vertices: [[0, 0, 0], [1, 0, 0], {x: 0, y: 1, z: 0}]\n"
                "          triangles: [{vertex_indices: [0, 1, 2]}]\n"
                "      mesh_poses: [{position: [5, 0, 0]}, {position: [0, 0, 7]}]\n");
            ASSERT_EQ(scene.objects().size(), 2U);
            EXPECT_EQ(static_cast<const MeshGeometry &>(*scene.objects()[0].geometry).num_tris, 12);
            EXPECT_EQ(static_cast<const MeshGeometry &>(*scene.objects()[1].geometry).num_tris, 1);
            EXPECT_TRUE(scene.bounds().min_.isApprox(fcl::Vector3d(0., -0.5, -0.5)));
            EXPECT_TRUE(scene.bounds().max_.isApprox(fcl::Vector3d(6., 1., 7.)));
        }

        TEST_F(PlanningSceneTest, RefusesFilesThatHoldNoWorld)
        {
            expectInputError([this] { loadPlanningScene(folder_.path() / "none.yaml"); }, "none.yaml", "not found");
            expectFault("", "empty");
            expectFault("# nothing\n", "empty");
            expectFault("world: [1, 2\n", "malformed YAML");
            expectFault("- 1\n- 2\n", "must be a map");
            expectFault("name: x\n", "'world' is missing");
            expectFault("world:\n", "'world' is missing or empty");
            expectFault("world: {collision_objects: []}\n", "no obstacle");
            expectFault("world: {collision_objects: 3}\n", "collision_objects must be a list");
            expectFault("wolrd:\n  collision_objects: []\n", "scene.yaml:1", "unknown key 'wolrd'");
            expectFault("world:\n  collision_objects: [{id: a}]\n", "scene.yaml:2", "'a' has no primitives");
            expectFault("world:\n  collision_objects:\n    - primitives: []\n", "'id' is missing");
        }

        TEST_F(PlanningSceneTest, NamesTheLineOfABadPrimitive)
        {
            expectObjectFault("      primitives: [{type: torus, dimensions: [1]}]\n", ":4", "type", "'torus'",
                              "box, sphere, cylinder, cone");
            expectObjectFault("      primitives: [{type: sphere, dimensions: [-1]}]\n", ":4", "dimensions",
                              "radius = -1", "at least 0");
            expectObjectFault("      primitives:\n        - type: box\n          dimensions: [1, 0, 1]\n", ":6",
                              "y = 0");
            expectObjectFault("      primitives: [{type: box, dimensions: [1, 2]}]\n", ":4", "3 dimensions", "not 2");
            expectObjectFault("      primitives: [{type: box, dimensions: [1, two, 3]}]\n", ":4", "two",
                              "finite number");
            expectObjectFault("      primitives: [{type: box, dimensions: [1, .nan, 3]}]\n", ":4", ".nan",
                              "finite number");
            expectObjectFault("      primitives: [{type: box}]\n", ":4", "'dimensions' is missing");
            expectObjectFault("      primitive: [{type: box}]\n", ":4", "unknown key 'primitive'");
            expectObjectFault("      primitives: [{type: box, type: sphere, dimensions: [1]}]\n", ":4", "'type' twice");
            expectObjectFault("      planes: [{coef: [0, 0, 1, 0]}]\n", ":4", "planes are not supported");
            expectObjectFault("      operation: 1\n      primitives: [{type: sphere, dimensions: [1]}]\n", ":4",
                              "operation = 1");
        }

        TEST_F(PlanningSceneTest, NamesTheLineOfABadPose)
        {
            const std::string sphere = "      primitives: [{type: sphere, dimensions: [1]}]\n";
            expectObjectFault(sphere + "      primitive_poses: [{orientation: [0, 0, 0, 1e-9]}]\n", ":5", "orientation",
                              "length");
            expectObjectFault(sphere + "      primitive_poses: [{position: [0, 0]}]\n", ":5", "position",
                              "3 components");
            expectObjectFault(sphere + "      primitive_poses: [{position: {x: 0, y: 0}}]\n", ":5", "'z' is missing");
            expectObjectFault(sphere + "      primitive_poses: [{position: [0, 0, .inf]}]\n", ":5", "position.z");
            expectObjectFault(sphere + "      primitive_poses: [{position: [0, 1e200, 0]}]\n", ":5",
                              "position.y = 1e200", "must not exceed 1e30");
            expectObjectFault("      primitives: [{type: box, dimensions: [1, 1e300, 1]}]\n", ":4",
                              "dimensions = 1e300", "must not exceed 1e30");
            expectObjectFault(sphere + "      primitive_poses: [{}, {}]\n", ":5", "2 entries for 1");
            expectObjectFault(sphere + "      primitive_poses: [{translation: [0, 0, 0]}]\n", ":5",
                              "unknown key 'translation'");
        }

        TEST_F(PlanningSceneTest, NamesTheLineOfABadMesh)
        {
            expectObjectFault("      meshes: [{resource: none.obj}]\n", ":4", "resource", "none.obj", "not found");
            expectObjectFault("      meshes: [{vertices: [[0, 0, 0]], triangles: []}]\n", ":4", "no triangles");
            expectObjectFault("      meshes: [{vertices: [[0, 0, 0]], triangles: [[0, 0, 1]]}]\n", ":4",
                              "vertex index 1", "below 1");
            expectObjectFault("      meshes: [{vertices: [[0, 0, .nan]], triangles: [[0, 0, 0]]}]\n", ":4",
                              "vertices.z");
            folder_.write("cube.obj", cubeObj());
            expectObjectFault("      meshes: [{resource: cube.obj, scale: -1}]\n", ":4", "scale");
        }

        const std::string BOX_OF_ONE = "    primitives: [{type: box, dimensions: [1, 1, 1]}]\n";

        // A box of edge 1 named "thing" in a frame, after the preamble.
        std::string boxInFrame(const std::string &frame, const std::string &preamble = "")
        {
            return preamble + "world:\n  collision_objects:\n  - id: thing\n    header: {frame_id: '" + frame + "'}\n" +
                   BOX_OF_ONE;
        }

        const std::string BASE_TRANSFORM =
            "fixed_frame_transforms:\n"
            "  - child_frame_id: base\n"
            "    transform: {translation: [4.5, 0, 0.5], rotation: [0, 0, 1, 1]}\n";

        TEST_F(PlanningSceneTest, PlacesObjectsInTheirFrames)
        {
            const Scene scene = load(boxInFrame("base", BASE_TRANSFORM) +
                                     "    pose: {position: [1, 0, 0], orientation: [0, 0, 0, 1]}\n");
            EXPECT_TRUE(scene.objects()[0].pose.translation().isApprox(fcl::Vector3d(4.5, 1., 0.5)))
                << scene.objects()[0].pose.translation().transpose();
            EXPECT_TRUE(scene.objects()[0].pose.linear().col(0).isApprox(fcl::Vector3d::UnitY()));
        }

        TEST_F(PlanningSceneTest, FollowsChainsOfFrames)
        {
            // The camera is listed before the arm to which it is attached; names may begin with a slash.
            const Scene scene =
                load(boxInFrame("camera",
                                "fixed_frame_transforms:\n"
                                "  - header: {frame_id: /arm}\n    child_frame_id: camera\n"
                                "    transform: {translation: {x: 1, y: 0, z: 0}, rotation: {x: 0, y: 0, z: 0, w: 1}}\n"
                                "  - header: {frame_id: odom, stamp: {sec: 0, nanosec: 0}}\n    child_frame_id: arm\n"
                                "    transform: {translation: [0, 2, 0], rotation: [0, 0, 1, 1]}\n"
                                "  - header: {frame_id: odom}\n    child_frame_id: odom\n"
                                "    transform: {translation: [0, 0, 0], rotation: [0, 0, 0, 1]}\n") +
                     "  - id: other\n    header: {frame_id: /odom}\n" + BOX_OF_ONE + "  - id: unnamed\n" + BOX_OF_ONE);
            ASSERT_EQ(scene.objects().size(), 3U);
            EXPECT_TRUE(scene.objects()[0].pose.translation().isApprox(fcl::Vector3d(0., 3., 0.)));
            EXPECT_TRUE(scene.objects()[1].pose.matrix().isIdentity());
            EXPECT_TRUE(scene.objects()[2].pose.matrix().isIdentity());
        }

        TEST_F(PlanningSceneTest, KnowsTheWorldAndEarlierObjectsAsFrames)
        {
            const Scene scene =
                load(boxInFrame("world") +
                     "    pose: {position: [5, 0, 0]}\n    subframe_names: [top]\n"
                     "    subframe_poses: [{position: [0, 0, 0.5]}]\n"
                     "  - id: lid\n    header: {frame_id: thing/top}\n" +
                     BOX_OF_ONE + "    primitive_poses: [{position: [0, 1, 0]}]\n" +
                     // An object without a pose of its own gets the pose of its only shape, as in MoveIt.
                     "  - id: knob\n    header: {frame_id: lid}\n" + BOX_OF_ONE);
            EXPECT_TRUE(scene.objects()[1].pose.translation().isApprox(fcl::Vector3d(5., 1., 0.5)));
            EXPECT_TRUE(scene.objects()[2].pose.translation().isApprox(fcl::Vector3d(5., 1., 0.5)));
        }

        TEST_F(PlanningSceneTest, RefusesFramesThatNothingPlaces)
        {
            expectFault(boxInFrame("camera"), ":4", "'thing'", "frame 'camera'", "fixed_frame_transforms");
            expectFault(boxInFrame("camera", BASE_TRANSFORM), ":7", "'thing'", "frame 'camera'", "base");
            const auto transform = [](const std::string &parent, const std::string &child, const std::string &rest)
            {
                return "  - header: {frame_id: " + parent + "}\n    child_frame_id: " + child +
                       "\n    transform: {translation: [" + rest + "], rotation: [0, 0, 0, 1]}\n";
            };
            const std::string list = "fixed_frame_transforms:\n";
            expectFault(boxInFrame("a", list + transform("odom", "a", "0, 0, 0") + transform("map", "b", "0, 0, 0")),
                        ":5", "'odom'", "'map'");
            expectFault(boxInFrame("a", list + transform("b", "a", "0, 0, 0") + transform("a", "b", "0, 0, 0")), ":2",
                        "'a'", "circle");
            expectFault(boxInFrame("a", list + transform("a", "a", "1, 0, 0")), ":2", "'a'", "itself");
            expectFault(boxInFrame("a", list + transform("b", "a", "0, 0, 0") + transform("b", "a", "1, 0, 0")), ":5",
                        "'a'", "twice");
            // If the file names another planning frame, the pose of the world is unknown.
            expectFault(boxInFrame("world", list + transform("odom", "a", "0, 0, 0")), "frame 'world'", "odom");
            expectFault("fixed_frame_transforms: {}\n" + boxInFrame(""), "fixed_frame_transforms must be a list");
        }

        // The nodes of a map as octomap_msgs encodes them in a message.
        std::string octomapData(const octomap::OcTree &tree, bool binary)
        {
            std::ostringstream stream;
            if (binary)
            {
                tree.writeBinaryData(stream);
            }
            else
            {
                tree.writeData(stream);
            }
            std::string list;
            for (const char byte : stream.str())
            {
                list += (list.empty() ? "" : ", ") + std::to_string(static_cast<int>(static_cast<signed char>(byte)));
            }
            return "[" + list + "]";
        }

        std::string octomapWorld(const std::string &data, bool binary, const std::string &id = "OcTree",
                                 const std::string &place = "")
        {
            return "world:\n  octomap:\n" + place +
                   "    octomap:\n      header: {frame_id: ''}\n      binary: " + (binary ? "true" : "false") +
                   "\n      id: " + id + "\n      resolution: 0.5\n      data: " + data + "\n";
        }

        class OctomapInSceneTest : public PlanningSceneTest
        {
        protected:
            OctomapInSceneTest()
              : tree_(0.5)
            {
                for (double x = 0.25; x < 4.; x += 0.5)
                {
                    tree_.updateNode(x, 0.25, 0.25, true);
                    tree_.updateNode(x, 5.25, 0.25, false);
                }
            }

            octomap::OcTree tree_;
        };

        TEST_F(OctomapInSceneTest, IsReadInItsFrameAndOrigin)
        {
            for (const bool binary : {true, false})
            {
                const Scene plain = load(octomapWorld(octomapData(tree_, binary), binary));
                ASSERT_EQ(plain.objects().size(), 1U);
                EXPECT_EQ(plain.objects()[0].geometry->getNodeType(), fcl::GEOM_OCTREE);
                EXPECT_TRUE(plain.bounds().min_.isZero(1e-9)) << plain.bounds().min_.transpose();
                EXPECT_TRUE(plain.bounds().max_.isApprox(fcl::Vector3d(4., 0.5, 0.5)));
                const Scene placed = load(
                    BASE_TRANSFORM + octomapWorld(octomapData(tree_, binary), binary, "OcTree",
                                                  "    header: {frame_id: base}\n"
                                                  "    origin: {position: [0, 0, 1], orientation: [0, 0, 0, 1]}\n"));
                EXPECT_TRUE(placed.bounds().min_.isApprox(fcl::Vector3d(4., 0., 1.5)));
                EXPECT_TRUE(placed.bounds().max_.isApprox(fcl::Vector3d(4.5, 4., 2.)));
            }
        }

        TEST_F(OctomapInSceneTest, StandsBesideObjects)
        {
            const std::string map = octomapWorld(octomapData(tree_, true), true);
            const Scene scene = load(map + "  collision_objects:\n  - id: thing\n" + BOX_OF_ONE);
            EXPECT_EQ(scene.objects().size(), 2U);
            // Free and unknown space is no obstacle, nor is an empty map.
            octomap::OcTree free(0.5);
            free.updateNode(1., 1., 1., false);
            const std::string objects = "  collision_objects:\n  - id: thing\n" + BOX_OF_ONE;
            EXPECT_EQ(load(octomapWorld(octomapData(free, true), true) + objects).objects().size(), 1U);
            EXPECT_EQ(load(octomapWorld("[]", false, "''") + objects).objects().size(), 1U);
            expectFault(octomapWorld(octomapData(free, true), true), "no obstacle");
        }

        TEST_F(OctomapInSceneTest, IsRefusedWhereItCannotBeRead)
        {
            const std::string data = octomapData(tree_, true);
            expectFault(octomapWorld(data, true, "ColorOcTree"), ":6", "octomap", "ColorOcTree", "OcTree");
            expectFault(octomapWorld(data.substr(0, data.size() / 2) + "]", true), ":8", "octomap.data", "truncated");
            expectFault(octomapWorld(data.substr(0, data.size() - 1) + ", 0, 0, 7]", true), ":8", "octomap.data",
                        "3 bytes");
            expectFault(octomapWorld("[300]", true), ":8", "300");
            expectFault(octomapWorld("[1, 0, '...']", true), ":8", "...", "octomap.data");
            expectFault(octomapWorld("'<sequence type: int8, length: 14>'", true), ":8", "octomap.data",
                        "must be a list");
            expectFault(octomapWorld(data, true, "OcTree", "    header: {frame_id: camera}\n"), ":3", "octomap",
                        "'camera'");
            std::string negative = octomapWorld(data, true);
            negative.replace(negative.find("resolution: 0.5"), 15, "resolution: 0.0");
            expectFault(negative, ":7", "resolution");
        }

        TEST_F(PlanningSceneTest, RefusesWhatBelongsToARobot)
        {
            const std::string attached =
                "robot_state:\n  attached_collision_objects:\n  - link_name: hand\n    object:\n      id: cup\n"
                "      primitives: [{type: box, dimensions: [1, 1, 1]}]\n";
            expectFault(attached + boxInFrame(""), ":3", "attached_collision_objects", "'cup'", "'hand'");
            expectFault("link_padding: [{link_name: hand, padding: 0.02}]\n" + boxInFrame(""), ":1", "link_padding",
                        "'hand'", "0.02");
            expectFault(
                "link_scale:\n- {link_name: arm, scale: 1.0}\n- {link_name: hand, scale: 1.1}\n" + boxInFrame(""), ":3",
                "link_scale", "'hand'", "1.1");
            expectFault("robot_state: {attached_collision_object: []}\n" + boxInFrame(""), ":1", "unknown key");
            // Entries without effect are accepted.
            EXPECT_EQ(load("robot_state: {attached_collision_objects: [], is_diff: true}\n"
                           "link_padding: [{link_name: hand, padding: 0.0}]\n"
                           "link_scale: [{link_name: hand, scale: 1.0}]\n" +
                           boxInFrame(""))
                          .objects()
                          .size(),
                      1U);
        }

        TEST_F(PlanningSceneTest, FollowsTheOperationsOfItsObjects)
        {
            const std::string world = "world:\n  collision_objects:\n";
            const auto object = [](const std::string &id, const std::string &operation, double x)
            {
                return "  - id: " + id + "\n    operation: " + operation + "\n" + BOX_OF_ONE +
                       "    primitive_poses: [{position: [" + std::to_string(x) + ", 0, 0]}]\n";
            };
            const Scene appended = load(world + object("a", "\"\\0\"", 1.) + object("a", "append", 2.));
            ASSERT_EQ(appended.objects().size(), 2U);
            EXPECT_EQ(appended.objects()[1].pose.translation().x(), 2.);
            // As in MoveIt: an object with a name in use replaces the old one, with a warning.
            std::string warning = standardErrorOf(
                [&]
                {
                    const Scene replaced = load(world + object("a", "0", 1.) + object("a", "ADD", 2.));
                    ASSERT_EQ(replaced.objects().size(), 1U);
                    EXPECT_EQ(replaced.objects()[0].pose.translation().x(), 2.);
                });
            EXPECT_EQ(countOf("Warning:", warning), 1U) << warning;
            EXPECT_NE(warning.find("'a'"), std::string::npos) << warning;
            const std::string move = "  - {id: a, operation: 3, pose: {position: [0, 0, 7]}}\n";
            const Scene moved = load(world + object("a", "0", 1.) + move);
            EXPECT_TRUE(moved.objects()[0].pose.translation().isApprox(fcl::Vector3d(0., 0., 7.)));
            const std::string remove = "  - {id: a, operation: \"\\x01\"}\n";
            EXPECT_EQ(load(world + object("a", "0", 1.) + object("b", "0", 1.) + remove).objects()[0].id, "b");
            expectFault(world + object("a", "0", 1.) + remove, "no obstacle");
            expectFault(world + object("b", "0", 1.) + remove, ":7", "operation = 1", "'a'");
            expectFault(world + object("b", "0", 1.) + move, ":7", "operation = 3", "'a'");
            expectFault(world + object("a", "4", 1.), ":4", "operation = 4", "append");
            expectFault(world + object("<octomap>", "0", 1.), ":3", "<octomap>");
        }

        TEST_F(PlanningSceneTest, RefusesShapesThatItCannotRead)
        {
            const std::string sphere = "      primitives: [{type: sphere, dimensions: [1]}]\n";
            // A mesh that is not an entry of a list used to be ignored.
            expectObjectFault(sphere + "      meshes: cube.obj\n", ":5", "meshes must be a list");
            expectObjectFault("      meshes: []\n      primitives: '<sequence length: 1>'\n", ":5",
                              "primitives must be a list");
            expectObjectFault(sphere + "      planes: '<sequence length: 1>'\n", ":5", "planes must be a list");
            expectObjectFault(sphere + "      plane_poses: [{}]\n", ":5", "plane_poses");
            expectObjectFault(sphere + "      mesh_poses: [{}]\n", ":5", "1 entries for 0");
            expectObjectFault(sphere + "      subframe_names: [a]\n", ":5", "subframe");
            expectObjectFault("      primitives: [{type: 1, dimensions: [1, 1, 1], polygon: {points: [{x: 1}]}}]\n",
                              ":4", "polygon");
            expectObjectFault("      primitives: [{type: 5, dimensions: [1], polygon: {points: []}}]\n", ":4", "'5'");
        }

        // A scene as printed by `ros2 topic echo`: every field, unset ones too, and a line that ends the message.
        std::string printedScene()
        {
            return R"(name: (noname)
robot_state:
  joint_state: {header: {stamp: {sec: 0, nanosec: 0}, frame_id: ''}, name: [], position: []}
  multi_dof_joint_state: {joint_names: [], transforms: []}
  attached_collision_objects: []
  is_diff: true
robot_model_name: arm
fixed_frame_transforms: []
allowed_collision_matrix: {entry_names: [], entry_values: [], default_entry_names: [], default_entry_values: []}
link_padding: []
link_scale: []
object_colors: []
world:
  collision_objects:
  - header:
      stamp: {sec: 0, nanosec: 0}
      frame_id: world
    pose:
      position: {x: 4.5, y: 0.0, z: 0.5}
      orientation: {x: 0.0, y: 0.0, z: 0.0, w: 0.0}
    id: box
    type: {key: '', db: ''}
    primitives:
    - type: 1
      dimensions: [1.0, 1.0, 1.0]
      polygon: {points: []}
    - type: 1
      dimensions: [1.0, 1.0, 1.0]
      polygon: {points: []}
    primitive_poses: []
    meshes: []
    mesh_poses: []
    planes: []
    plane_poses: []
    subframe_names: []
    subframe_poses: []
    operation: "\0"
  octomap:
    header: {stamp: {sec: 0, nanosec: 0}, frame_id: ''}
    origin: {position: {x: 0.0, y: 0.0, z: 0.0}, orientation: {x: 0.0, y: 0.0, z: 0.0, w: 0.0}}
    octomap: {header: {stamp: {sec: 0, nanosec: 0}, frame_id: ''}, binary: false, id: '', resolution: 0.0, data: []}
is_diff: false
---
)";
        }

        TEST_F(PlanningSceneTest, ReadsMessagesAsTheyArePrinted)
        {
            const std::string warning = standardErrorOf(
                [this]
                {
                    const Scene scene = load(printedScene());
                    ASSERT_EQ(scene.objects().size(), 2U);
                    for (const CollisionObject &object : scene.objects())
                    {
                        EXPECT_EQ(object.pose.translation(), fcl::Vector3d(4.5, 0., 0.5));
                        EXPECT_TRUE(object.pose.linear().isIdentity());
                    }
                });
            // One warning for the object, whatever is unset in it; none for the empty octomap.
            EXPECT_EQ(countOf("Warning:", warning), 1U) << warning;
            for (const std::string part : {"scene.yaml:15", "'box'", "orientation", "primitive_poses", "identity"})
            {
                EXPECT_NE(warning.find(part), std::string::npos) << "'" << part << "' is not in: " << warning;
            }
        }

        TEST_F(PlanningSceneTest, WarnsOfEachObjectOnce)
        {
            const std::string unset = "[{orientation: [0, 0, 0, 0]}, {orientation: [0, 0, 0, 0]}]\n";
            const auto object = [&unset](const std::string &id)
            {
                return "  - id: " + id +
                       "\n    primitives: [{type: sphere, dimensions: [1]}, {type: sphere, dimensions: [2]}]\n"
                       "    primitive_poses: " +
                       unset;
            };
            const std::string warning = standardErrorOf(
                [&]
                {
                    load(
                        "fixed_frame_transforms:\n  - child_frame_id: base\n"
                        "    transform: {translation: [1, 0, 0], rotation: [0, 0, 0, 0]}\n"
                        "world:\n  collision_objects:\n" +
                        object("a") + object("b") + "  - id: c\n" + BOX_OF_ONE);
                });
            EXPECT_EQ(countOf("Warning:", warning), 3U) << warning;
            EXPECT_EQ(countOf("'a'", warning), 1U) << warning;
            EXPECT_EQ(countOf("'b'", warning), 1U) << warning;
            EXPECT_EQ(countOf("'base'", warning), 1U) << warning;
            // A complete scene causes no warning.
            EXPECT_EQ(standardErrorOf([&] { load(boxInFrame("base", BASE_TRANSFORM)); }), "");
        }

        TEST_F(PlanningSceneTest, RefusesASecondMessage)
        {
            const std::string world = "world:\n  collision_objects:\n  - id: thing\n" + BOX_OF_ONE;
            EXPECT_EQ(load("---\n" + world + "---\n").objects().size(), 1U);
            expectFault(world + "---\n" + world + "---\n", ":6", "2 messages");
        }

        TEST_F(PlanningSceneTest, SaysThatADifferenceIsReadAlone)
        {
            const std::string warning = standardErrorOf([this] { load("is_diff: true\n" + boxInFrame("")); });
            EXPECT_EQ(countOf("Warning:", warning), 1U) << warning;
            EXPECT_NE(warning.find("is_diff"), std::string::npos) << warning;
        }
    }  // namespace
}  // namespace ompl_mfa::collision
