#include "ompl_mfa/collision/PlanningScene.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        class PlanningSceneTest : public ::testing::Test
        {
        protected:
            Scene load(const std::string &text) const
            {
                return loadPlanningScene(folder_.write("scene.yaml", text));
            }

            // One obstacle whose shapes are given, from line 4 on.
            Scene loadObject(const std::string &lines) const
            {
                return load("world:\n  collision_objects:\n    - id: thing\n" + lines);
            }

            template <typename... Parts>
            void expectFault(const std::string &text, const Parts &...parts) const
            {
                expectInputError([&] { load(text); }, "scene.yaml", parts...);
            }

            template <typename... Parts>
            void expectObjectFault(const std::string &lines, const Parts &...parts) const
            {
                expectInputError([&] { loadObject(lines); }, "scene.yaml", parts...);
            }

            TemporaryFolder folder_;
        };

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
            expectObjectFault(sphere + "      primitive_poses: [{position: [0, 0, 0], orientation: [0, 0, 0, 0]}]\n",
                              ":5", "orientation", "length 0");
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
    }  // namespace
}  // namespace ompl_mfa::collision
