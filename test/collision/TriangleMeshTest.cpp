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

#include "ompl_mfa/collision/TriangleMesh.h"

#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "collision/TestFiles.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // A binary STL of one triangle.
        std::string stl(const std::array<float, 9> &corners)
        {
            std::string content(80, ' ');
            const std::uint32_t count = 1;
            content.append(reinterpret_cast<const char *>(&count), sizeof(count));
            const std::array<float, 3> normal{0.F, 0.F, 1.F};
            content.append(reinterpret_cast<const char *>(normal.data()), sizeof(normal));
            content.append(reinterpret_cast<const char *>(corners.data()), sizeof(corners));
            content.append(2, '\0');
            return content;
        }

        // COLLADA: a node that translates its mesh inside a node that scales it, with a line beside the triangle. The
        // file's z is up: assimp turns that to y up in the root's transform, so z becomes y and y becomes -z.
        std::string collada()
        {
            return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><up_axis>Z_UP</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="15">0 0 0 1 0 0 0 1 0 9 9 9 9 9 13</float_array>
   <technique_common><accessor source="#a" count="5" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
  <lines count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>3 4</p></lines>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s">
  <node id="outer"><scale>2 2 2</scale>
   <node id="inner"><translate>10 0 0</translate><instance_geometry url="#g"/></node></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)";
        }

        TEST(TriangleMesh, ReadsTheFormatsThatAssimpReads)
        {
            const TemporaryFolder folder;
            const std::string ply =
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
            EXPECT_EQ(loadMesh(folder.write("cube.obj", cubeObj())).triangles.size(), 12U);
            EXPECT_EQ(loadMesh(folder.write("one.stl", stl({0, 0, 0, 1, 0, 0, 0, 1, 0}))).triangles.size(), 1U);
            EXPECT_EQ(loadMesh(folder.write("one.ply", ply)).triangles.size(), 1U);
            EXPECT_EQ(loadMesh(folder.write("one.dae", collada())).triangles.size(), 1U);
        }

        TEST(TriangleMesh, AppliesEveryNodeTransform)
        {
            const TemporaryFolder folder;
            const TriangleMesh mesh = loadMesh(folder.write("one.dae", collada()));
            ASSERT_EQ(mesh.triangles.size(), 1U);
            fcl::Vector3d centre = fcl::Vector3d::Zero();
            for (int corner = 0; corner < 3; ++corner)
            {
                centre += mesh.vertices[mesh.triangles[0][corner]] / 3.;
            }
            EXPECT_TRUE(centre.isApprox(fcl::Vector3d(20. + 2. / 3., 0., -2. / 3.), 1e-6)) << centre.transpose();
        }

        // OMPL.app centres a robot on the mean of all vertices that assimp keeps, those of lines included.
        TEST(TriangleMesh, MeanCountsTheVerticesOfLines)
        {
            const TemporaryFolder folder;
            const TriangleMesh mesh = loadMesh(folder.write("one.dae", collada()));
            EXPECT_TRUE(mesh.vertexMean.isApprox(fcl::Vector3d(20. + 38. / 5., 44. / 5., -38. / 5.), 1e-6))
                << mesh.vertexMean.transpose();
        }

        TEST(TriangleMesh, TriangulatesPolygons)
        {
            const TemporaryFolder folder;
            const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
            EXPECT_EQ(loadMesh(folder.write("square.obj", square)).triangles.size(), 2U);
        }

        TEST(TriangleMesh, RefusesWhatIsNoMesh)
        {
            const TemporaryFolder folder;
            const auto load = [&folder](const std::string &name, const std::string &content)
            { return [&folder, name, content] { loadMesh(folder.write(name, content)); }; };
            expectInputError([&folder] { loadMesh(folder.path() / "none.dae"); }, "none.dae", "not found");
            expectInputError([&folder] { loadMesh(folder.path()); }, "not found");
            expectInputError(load("broken.dae", "this is no XML"), "broken.dae", "not a readable mesh");
            expectInputError(load("empty.stl", ""), "empty.stl", "not a readable mesh");
            expectInputError(load("mesh.unknown", "x"), "mesh.unknown", "not a readable mesh");
            expectInputError(load("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "lines.obj", "no triangles");
            const float nan = std::numeric_limits<float>::quiet_NaN();
            expectInputError(load("nan.stl", stl({0, 0, 0, 1, 0, 0, 0, nan, 0})), "nan.stl", "not a finite number");
            // In its first coordinates it would pass for the vertex before it.
            expectInputError(load("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"), "nan.obj",
                             "not a finite number");
            const float inf = std::numeric_limits<float>::infinity();
            expectInputError(load("inf.stl", stl({0, 0, inf, 1, 0, 0, 0, 1, 0})), "inf.stl", "not a finite number");
            expectInputError(load("far.stl", stl({0, 0, 1e35F, 1, 0, 0, 0, 1, 0})), "far.stl", "beyond 1e30");
            EXPECT_THROW(makeMeshGeometry(TriangleMesh()), std::invalid_argument);
        }

        std::string ply(const std::string &element, const std::string &lists)
        {
            return "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
                   element + "\nproperty list int int vertex_indices\nend_header\n" +
                   "0 0 -1\n0 1 -1\n1 0 -1\n1 1 -1\n2 0 -1\n2 1 -1\n" + lists;
        }

        // assimp makes one triangle of each strip and, with many strips, writes beyond its array.
        TEST(TriangleMesh, RefusesTriangleStripsOfPly)
        {
            const TemporaryFolder folder;
            std::string many;
            for (int i = 0; i < 1000; ++i)
            {
                many += "4 0 1 2 3\n";
            }
            const auto expectFault = [&folder](const std::string &content, const std::string &count)
            {
                expectInputError([&] { loadMesh(folder.write("strip.ply", content)); }, "strip.ply",
                                 count + " triangle strips", "faces");
            };
            expectFault(ply("element tristrips 1", "6 0 1 2 3 4 5\n"), "1");
            expectFault(ply("element tristrips 1000", many), "1000");
            expectFault(ply("element face 1\nproperty list int int vertex_index\nelement tristrips 1",
                            "3 0 1 2\n6 0 1 2 3 4 5\n"),
                        "1");
            std::string windows = ply("element tristrips 1", "6 0 1 2 3 4 5\n");
            for (std::size_t at = windows.find('\n'); at != std::string::npos; at = windows.find('\n', at + 2))
            {
                windows.insert(at, "\r");
            }
            expectFault(windows, "1");
            EXPECT_EQ(
                loadMesh(folder.write("quads.ply", ply("element face 2", "4 0 1 3 2\n4 2 3 5 4\n"))).triangles.size(),
                4U);
        }

        // assimp repeats the last face for those missing in a text file, and reads past the end of a binary file.
        TEST(TriangleMesh, RefusesPlyThatIsCut)
        {
            const TemporaryFolder folder;
            const auto expectFault = [&folder](const std::string &content, const std::string &element) {
                expectInputError([&] { loadMesh(folder.write("cut.ply", content)); }, "cut.ply", "'" + element + "'",
                                 "header");
            };
            const std::string text = ply("element face 3", "3 0 1 2\n3 1 2 3\n");
            expectFault(text, "face");
            expectFault(text.substr(0, text.find("1 1 -1")), "vertex");
            const auto number = [](auto value)
            { return std::string(reinterpret_cast<const char *>(&value), sizeof(value)); };
            std::string binary =
                "ply\r\nformat binary_little_endian 1.0\r\ncomment x\r\nelement vertex 4\r\nproperty float x\r\n"
                "property double y\r\nproperty float32 z\r\nelement face 2\r\n"
                "property list uchar int vertex_indices\r\nproperty uchar red\r\nend_header\r\n";
            for (int i = 0; i < 4; ++i)
            {
                binary += number(static_cast<float>(i % 2)) + number(static_cast<double>(i / 2)) + number(1.F);
            }
            const std::size_t faces = binary.size();
            for (const int first : {0, 1})
            {
                binary += std::string(1, '\3') + number(first) + number(first + 1) + number(first + 2) + "r";
            }
            EXPECT_EQ(loadMesh(folder.write("whole.ply", binary)).triangles.size(), 2U);
            expectFault(binary.substr(0, binary.size() - 1), "face");
            expectFault(binary.substr(0, binary.size() - 16), "face");
            expectFault(binary.substr(0, faces - 3), "vertex");
        }

        TEST(TriangleMesh, RefusesFacesThatArePartlyLost)
        {
            const TemporaryFolder folder;
            // assimp finds two of the four triangles of a hexagon that intersects itself.
            const std::string crossing =
                "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nv 1 1 0\nv 3 1 0\nv 0 0 1\nf 1 2 3 4 5 6\nf 1 2 7\n";
            expectInputError([&] { loadMesh(folder.write("crossing.obj", crossing)); }, "crossing.obj",
                             "2 of 5 triangles");
            // A face with an index beyond the vertices counts as lost.
            expectInputError([&] { loadMesh(folder.write("wild.ply", ply("element face 2", "3 0 1 2\n3 0 1 70\n"))); },
                             "wild.ply", "1 face", "vertex");
            // Polygons without area count as complete.
            const std::string flat = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nv 0 1 0\nf 1 2 3 4 5\nf 1 2 6\n";
            EXPECT_EQ(loadMesh(folder.write("flat.obj", flat)).triangles.size(), 4U);
        }

        TEST(TriangleMesh, RefusesFilesWithoutGeometry)
        {
            const TemporaryFolder folder;
            const std::string nodes = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <library_visual_scenes><visual_scene id="S"><node id="A"><node id="B"><translate>1 0 0</translate></node></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#S"/></scene>
</COLLADA>)";
            expectInputError([&] { loadMesh(folder.write("nodes.dae", nodes)); }, "nodes.dae", "no triangles");
            const std::string bones =
                "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 3 Xrotation Yrotation Zrotation\n"
                " JOINT Chest\n {\n  OFFSET 0 5 0\n  CHANNELS 3 Xrotation Yrotation Zrotation\n"
                "  End Site\n  {\n   OFFSET 0 5 0\n  }\n }\n}\n"
                "MOTION\nFrames: 1\nFrame Time: 0.03\n0 0 0 0 0 0\n";
            expectInputError([&] { loadMesh(folder.write("walk.bvh", bones)); }, "walk.bvh", "no triangles");
        }

        TEST(TriangleMesh, CountsThePointsAndLinesThatItLeavesOut)
        {
            const TemporaryFolder folder;
            EXPECT_EQ(loadMesh(folder.write("cube.obj", cubeObj())).skippedFaces, 0U);
            EXPECT_EQ(loadMesh(folder.write("one.dae", collada())).skippedFaces, 1U);
            // A polyline of three points is two lines.
            const std::string mixed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\np 1\np 2\nl 1 2 3\n";
            const TriangleMesh mesh = loadMesh(folder.write("mixed.obj", mixed));
            EXPECT_EQ(mesh.triangles.size(), 1U);
            EXPECT_EQ(mesh.skippedFaces, 4U);
        }

        TEST(TriangleMesh, LeavesTheTransformOfTheRootOutWhereItIsAskedTo)
        {
            const TemporaryFolder folder;
            // The nodes below the root still place the triangle: twice (10, 0, 0) and twice its corners.
            const TriangleMesh mesh = loadMesh(folder.write("one.dae", collada()), RootTransform::Reset);
            fcl::AABBd box;
            for (int corner = 0; corner < 3; ++corner)
            {
                box += mesh.vertices[mesh.triangles[0][corner]];
            }
            EXPECT_TRUE(box.min_.isApprox(fcl::Vector3d(20., 0., 0.), 1e-6)) << box.min_.transpose();
            EXPECT_TRUE(box.max_.isApprox(fcl::Vector3d(22., 2., 0.), 1e-6)) << box.max_.transpose();
        }
    }  // namespace
}  // namespace ompl_mfa::collision
