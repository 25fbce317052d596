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

#include "ompl_mfa/maps/MapFile.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"
#include "maps/MapFolder.h"

namespace ompl_mfa::maps
{
    namespace
    {
        using ompl_mfa::test::inputErrorOf;
        using test::MapFolder;
        using test::rowsOf;
        using Rows = std::vector<std::string>;

        const std::string KEYS =
            "resolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
            "free_thresh: 0.196\n";

        std::string replaced(std::string text, const std::string &from, const std::string &to)
        {
            return text.replace(text.find(from), from.size(), to);
        }

        /* The rows of a map of one row of the shades 0, 50, 100, 128, 204, 206, 255 with these further lines. */
        Rows shadesOf(const std::string &keys)
        {
            const MapFolder folder;
            folder.write("m.pgm", "P2\n# a comment\n7 1\n255\n0 50 100 128 204 206 255\n");
            return rowsOf(loadMap(folder.write("m.yaml", "image: m.pgm\n" + keys)));
        }

        std::string faultOfMap(const std::string &yaml, const std::string &image = "P2 2 2 255 0 0 255 255\n")
        {
            const MapFolder folder;
            folder.write("m.pgm", image);
            const auto file = folder.write("m.yaml", yaml);
            const std::string message = inputErrorOf([&] { loadMap(file); });
            EXPECT_TRUE(message.empty() || message.rfind(folder.path().string(), 0) == 0) << message;
            return message;
        }

        std::string faultOfMovingAi(const std::string &content)
        {
            const MapFolder folder;
            const auto file = folder.write("m.map", content);
            return inputErrorOf([&] { loadMap(file); });
        }

        bool holds(const std::string &text, const std::string &part)
        {
            return text.find(part) != std::string::npos;
        }
    }  // namespace

    TEST(MapFile, FirstRowOfTheImageIsTheTop)
    {
        const MapFolder folder;
        folder.write("m.pgm", "P2 3 2 255\n0 255 255\n255 255 0\n");
        const GridMap map = loadMap(folder.write("m.yaml", "image: m.pgm\n" + KEYS));
        EXPECT_EQ(rowsOf(map), (Rows{"#..", "..#"}));
        EXPECT_EQ(map.width(), 3U);
        EXPECT_EQ(map.height(), 2U);
        EXPECT_EQ(map.cell(2, 0), Cell::Occupied);
        // the lower right cell is from (1 + 1, 2) to (1 + 1.5, 2.5)
        EXPECT_TRUE(map.toWorld({2.0, 0.0}).isApprox(Eigen::Vector2d(2.0, 2.0)));
        EXPECT_TRUE(map.toGrid({2.25, 2.25}).isApprox(Eigen::Vector2d(2.5, 0.5)));
    }

    TEST(MapFile, OriginIsTurnedByItsYaw)
    {
        const MapFolder folder;
        folder.write("m.pgm", "P2 3 2 255\n0 255 255\n255 255 0\n");
        const GridMap map = loadMap(
            folder.write("m.yaml", "image: m.pgm\n" + replaced(KEYS, "[1, 2, 0]", "[1, 2, 1.5707963267948966]")));
        // a quarter turn: along the rows is along y, up the image is against x
        EXPECT_LT((map.toWorld({2.0, 1.0}) - Eigen::Vector2d(1.0 - 0.5, 2.0 + 1.0)).norm(), 1e-12);
        EXPECT_LT((map.toGrid({0.5, 3.0}) - Eigen::Vector2d(2.0, 1.0)).norm(), 1e-12);
        EXPECT_LT((map.bounds().min() - Eigen::Vector2d(0.0, 2.0)).norm(), 1e-12);
        EXPECT_LT((map.bounds().max() - Eigen::Vector2d(1.0, 3.5)).norm(), 1e-12);
    }

    TEST(MapFile, ThresholdsModesAndNegationAreThoseOfNav2)
    {
        // occupancies 1, 0.804, 0.608, 0.498, 0.2, 0.192, 0
        EXPECT_EQ(shadesOf(KEYS), Rows{"##???.."});
        EXPECT_EQ(shadesOf(KEYS + "mode: trinary\n"), Rows{"##???.."});
        EXPECT_EQ(shadesOf(replaced(KEYS, "0.65", "0.6")), Rows{"###??.."});
        EXPECT_EQ(shadesOf(replaced(KEYS, "0.196", "0.2")), Rows{"##??..."});
        EXPECT_EQ(shadesOf(replaced(KEYS, "negate: 0", "negate: 1")), Rows{".???###"});
        EXPECT_EQ(shadesOf(replaced(KEYS, "negate: 0", "negate: true")), Rows{".???###"});
        EXPECT_EQ(shadesOf(KEYS + "mode: scale\n"), Rows{"##....."});
        // within half a percent of the threshold the scaled occupancy is rounded to 100
        EXPECT_EQ(shadesOf(replaced(KEYS, "0.65", "0.609") + "mode: scale\n"), Rows{"###...."});
        EXPECT_EQ(shadesOf(KEYS + "mode: raw\n"), Rows{"..#????"});
    }

    TEST(MapFile, ImageFormatsAndDepthsAgree)
    {
        const std::string yaml = "image: m.pgm\n" + KEYS;
        const auto rows = [&](const std::string &image)
        {
            const MapFolder folder;
            folder.write("m.pgm", image);
            return rowsOf(loadMap(folder.write("m.yaml", yaml)));
        };
        const Rows expected{".?#", "#.?"};
        // 205 is what map_saver writes for unknown cells
        EXPECT_EQ(rows("P2 3 2 255\n254 205 0\n0 254 128\n"), expected);
        EXPECT_EQ(rows("P2 3 2 100\n100 50 0\n0 100 50\n"), expected);
        EXPECT_EQ(rows(std::string("P5\n3 2\n255\n") + "\xfe\x80" + std::string(2, '\0') + "\xfe\x80"), expected);
        // 16 bits per pixel, the high byte first
        EXPECT_EQ(rows(std::string("P5\n3 2\n65535\n") + "\xff\xff\x80" + std::string(5, '\0') + "\xff\xff\x80" +
                       std::string(1, '\0')),
                  expected);
    }

    TEST(MapFile, ColourAndTransparencyOfPng)
    {
        const std::filesystem::path folder = std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "test/maps/images";
        // black, white, grey, red on top; white at half opacity, white, transparent black, black below
        EXPECT_EQ(rowsOf(loadMap(folder / "rgba.yaml")), (Rows{"#.??", "?.?#"}));
        EXPECT_EQ(rowsOf(loadMap(folder / "bmp.yaml")), (Rows{"#.?", "..#"}));
    }

    TEST(MapFile, MovingAiMapIsReadFromTheTop)
    {
        const MapFolder folder;
        const auto file = folder.write("m.map", "type octile\nheight 2\nwidth 4\nmap\n.G@T\r\nSOW.\n");
        const GridMap map = loadMap(file);
        EXPECT_EQ(map.width(), 4U);
        EXPECT_EQ(map.height(), 2U);
        EXPECT_TRUE(map.frame().yDown);
        EXPECT_EQ(rowsOf(map), (Rows{".##.", "..##"}));
        // the cell of column 2 and row 0 is about (2, 0)
        EXPECT_TRUE(map.toGrid({2.0, 0.0}).isApprox(Eigen::Vector2d(2.5, 0.5)));
        EXPECT_EQ(map.cell(2, 0), Cell::Occupied);
        EXPECT_EQ(map.cell(3, 1), Cell::Free);
    }

    TEST(MapFile, KindIsRecognised)
    {
        const MapFolder folder;
        EXPECT_TRUE(isMapFile(folder.write("a.yaml", "resolution: 1\nimage: x.png\n")));
        EXPECT_TRUE(isMapFile(folder.write("b.yml", "image : x.png\n")));
        EXPECT_TRUE(isMapFile("no/such/file.MAP"));
        EXPECT_FALSE(isMapFile(folder.write("c.yaml", "world:\n  image: x\nimages: 3\n")));
        EXPECT_FALSE(isMapFile("no/such/file.yaml"));
        EXPECT_FALSE(isMapFile(folder.write("d.obj", "image: x\n")));
    }

    TEST(MapFile, FaultsOfServerMaps)
    {
        const std::string yaml = "image: m.pgm\n" + KEYS;
        EXPECT_EQ(faultOfMap(yaml).size(), 0U);
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "m.pgm", "n.pgm")), "m.yaml:1: image = n.pgm: no such image"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "0.5", "0")), "m.yaml:2: resolution = 0: expected a number above"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "0.5", "-0.05")), "resolution = -0.05: expected"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "0.5", "5cm")), "resolution = 5cm: expected"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "resolution: 0.5\n", "")), "'resolution' is missing"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "[1, 2, 0]", "[1, 2]")), "m.yaml:3: origin: expected [x, y, yaw]"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "[1, 2, 0]", "[1, 2, inf]")), "origin: expected"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "negate: 0", "negate: 2")), "negate = 2: expected one of"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "0.65", "65")), "occupied_thresh = 65: expected a number from 0"));
        EXPECT_TRUE(holds(faultOfMap(replaced(yaml, "0.65", "0.1")), "free_thresh = 0.196: expected less than"));
        EXPECT_TRUE(holds(faultOfMap(yaml + "mode: binary\n"), "m.yaml:7: mode = binary: expected one of"));
        EXPECT_TRUE(holds(faultOfMap(yaml + "mod: scale\n"), "m.yaml:7: unknown key 'mod'"));
        EXPECT_TRUE(holds(faultOfMap(yaml + "negate: 1\n"), "'negate' is set twice"));
        EXPECT_TRUE(holds(faultOfMap("image: m.pgm\n  x: [\n"), "malformed YAML"));
        EXPECT_TRUE(holds(faultOfMap("[1, 2]\n"), "expected the keys of a map"));
    }

    TEST(MapFile, FaultsOfImages)
    {
        const std::string yaml = "image: m.pgm\n" + KEYS;
        EXPECT_TRUE(holds(faultOfMap(yaml, "GIF89a"), "is not an image of a map; accepted are PGM, PNG and BMP"));
        EXPECT_TRUE(holds(faultOfMap(yaml, ""), "is not an image of a map"));
        EXPECT_TRUE(holds(faultOfMap(yaml, "P5\n100 100\n255\nabc"), "is damaged"));
        EXPECT_TRUE(holds(faultOfMap(yaml, "P5\n0 0\n255\n"), "is damaged"));
        EXPECT_TRUE(holds(faultOfMap(yaml, "\x89PNG\r\n\x1a\n"), "is damaged"));
        const std::string large = faultOfMap(yaml, "P5\n900000 900000\n255\n");
        EXPECT_TRUE(holds(large, "900000 x 900000") || holds(large, "is damaged")) << large;
    }

    TEST(MapFile, FaultsOfMovingAiMaps)
    {
        const std::string head = "type octile\nheight 2\nwidth 3\nmap\n";
        EXPECT_EQ(faultOfMovingAi(head + "...\n...\n"), "");
        EXPECT_TRUE(holds(faultOfMovingAi("type tile\n"), "m.map:1: expected 'type octile'"));
        EXPECT_TRUE(holds(faultOfMovingAi("type octile\nheight 2\nmap\n...\n"), "m.map:3: 'map' is preceded by"));
        EXPECT_TRUE(holds(faultOfMovingAi("type octile\nheight 0\n"), "m.map:2: height 0: expected a whole number"));
        EXPECT_TRUE(holds(faultOfMovingAi("type octile\nheight -3\n"), "height -3: expected"));
        EXPECT_TRUE(holds(faultOfMovingAi("type octile\nheight 2\nwidth 3\n"), "the file ends before 'map'"));
        EXPECT_TRUE(holds(faultOfMovingAi(head + "...\n"), "m.map:6: the file ends after 1 rows; 'height 2'"));
        EXPECT_TRUE(holds(faultOfMovingAi(head + "...\n..\n"), "m.map:6: the row has 2 cells; 'width 3'"));
        EXPECT_TRUE(holds(faultOfMovingAi(head + "...\n...\n...\n"), "m.map:7: a row beyond the 2"));
        EXPECT_TRUE(holds(faultOfMovingAi(head + "...\n.x.\n"), "m.map:6: unknown cell 'x'"));
        EXPECT_TRUE(holds(faultOfMovingAi("type octile\nheight 1000000\nwidth 1000000\nmap\n"), "needs"));
        EXPECT_TRUE(holds(inputErrorOf([] { loadMap("no/such.map"); }), "no/such.map: map not found"));
    }

    TEST(MapFile, MapsOfOthersAreRead)
    {
        const std::filesystem::path folder = test::sharedMaps();
        if (folder.empty())
        {
            GTEST_SKIP() << "no shared maps";
        }
        const GridMap warehouse = loadMap(folder / "ros/warehouse.yaml");
        EXPECT_EQ(warehouse.frame().origin, Eigen::Vector2d(-15.1, -25.0));
        const GridMap turtlebot = loadMap(folder / "ros/turtlebot3.yaml");
        EXPECT_EQ(turtlebot.width(), 384U);
        const auto count = [](const GridMap &map, Cell cell)
        { return std::count(map.cells().begin(), map.cells().end(), cell); };
        EXPECT_GT(count(turtlebot, Cell::Unknown), 100000);
        EXPECT_GT(count(turtlebot, Cell::Free), 5000);
        EXPECT_GT(count(turtlebot, Cell::Occupied), 300);
        EXPECT_EQ(count(loadMap(folder / "movingai/Berlin_0_256.map"), Cell::Unknown), 0);
    }
}  // namespace ompl_mfa::maps
