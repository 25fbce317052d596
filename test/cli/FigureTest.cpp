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

#include "cli/Figure.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <cairo.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "cli/PdfText.h"
#include "cli/RunProgram.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::cli
{
    namespace
    {
        bool contains(const std::string &text, const std::string &part)
        {
            return text.find(part) != std::string::npos;
        }

        std::string svg(const Axes &axes)
        {
            Figure figure;
            figure.addAxes(axes);
            return figure.render(PictureFormat::SVG);
        }

        /** \brief A word and its position, in points from the upper left corner. */
        struct PdfWord
        {
            std::string text;
            Eigen::AlignedBox2d box;
        };

        /** \brief The words of a PDF; the first is the page itself and has no text. */
        std::vector<PdfWord> pdfWords(const std::string &file)
        {
            const std::string text = pdfToText("-bbox", file);
            std::smatch match;
            EXPECT_TRUE(std::regex_search(text, match, std::regex("<page width=\"([0-9.]+)\" height=\"([0-9.]+)\"")));
            std::vector<PdfWord> words{
                {"", {Eigen::Vector2d(0, 0), Eigen::Vector2d(std::stod(match[1]), std::stod(match[2]))}}};
            const std::string number = "=\"(-?[0-9.]+)\" ?";
            const std::regex word("<word xMin" + number + "yMin" + number + "xMax" + number + "yMax" + number +
                                  ">([^<]*)<");
            for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at)
            {
                words.push_back({(*at)[5],
                                 {Eigen::Vector2d(std::stod((*at)[1]), std::stod((*at)[2])),
                                  Eigen::Vector2d(std::stod((*at)[3]), std::stod((*at)[4]))}});
            }
            return words;
        }

        std::vector<PdfWord> words(const Figure &figure)
        {
            const std::string file = temporaryFile("figure.pdf");
            figure.write(file);
            auto found = pdfWords(file);
            std::remove(file.c_str());
            return found;
        }

        bool hasWord(const std::vector<PdfWord> &all, const std::string &text)
        {
            return std::any_of(all.begin(), all.end(), [&text](const PdfWord &word) { return word.text == text; });
        }

        /** \brief Expects that words are on the page and do not overlap. */
        void expectReadable(const std::vector<PdfWord> &all, const std::string &which)
        {
            for (std::size_t i = 1; i < all.size(); ++i)
            {
                EXPECT_TRUE(all.front().box.contains(all[i].box)) << which << ": " << all[i].text << " leaves the page";
                for (std::size_t k = i + 1; k < all.size(); ++k)
                {
                    // The boxes leave room for accents and descenders, which the words do not have.
                    const Eigen::AlignedBox2d common = all[i].box.intersection(all[k].box);
                    EXPECT_TRUE(common.isEmpty() || common.sizes().minCoeff() < 3.0)
                        << which << ": '" << all[i].text << "' and '" << all[k].text << "' overlap by "
                        << common.sizes().transpose();
                }
            }
        }
    }  // namespace

    TEST(Figure, PlacesPointsInTheAxes)
    {
        // Axes of 480 x 480 pixels with the upper left corner at (62, 36).
        Axes axes("title", "x (m)", "y (m)", {0.0, 0.0}, {10.0, 10.0});
        axes.addPolyline({{0.0, 0.0}, {10.0, 10.0}, {5.0, 2.5}}, {});
        axes.addPolygon({{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}}, {});
        axes.addSegments({{{0.0, 10.0}, {5.0, 10.0}}, {{5.0, 5.0}, {10.0, 5.0}}}, {});
        const std::string picture = svg(axes);
        EXPECT_TRUE(contains(picture, "d=\"M 62 516 L 542 36 L 302 396 \"")) << picture;
        EXPECT_TRUE(contains(picture, "d=\"M 62 516 L 302 516 L 302 276 Z ")) << picture;
        EXPECT_TRUE(contains(picture, "d=\"M 62 36 L 302 36 M 302 276 L 542 276 \"")) << picture;
    }

    TEST(Figure, CirclesAreRoundAndTrueAndMarkersAreInPixels)
    {
        // 480 pixels are 20 units of x and 20 units of y.
        Axes axes("title", "x (m)", "y (m)", {0.0, 0.0}, {20.0, 10.0});
        axes.addCircle({10.0, 5.0}, 2.0, {});
        axes.addMarkers({{10.0, 5.0}}, 3.0, {});
        const std::string picture = svg(axes);
        std::smatch circle;
        ASSERT_TRUE(std::regex_search(picture, circle, std::regex("d=\"(M 350 156 C[^\"]*)\"")));
        const std::string path = circle[1];
        const std::regex curve("C [0-9.]+ [0-9.]+ [0-9.]+ [0-9.]+ ([0-9.]+) ([0-9.]+)");
        int curves = 0;
        for (std::sregex_iterator at(path.begin(), path.end(), curve), end; at != end; ++at, ++curves)
        {
            EXPECT_NEAR(std::hypot(std::stod((*at)[1]) - 302, std::stod((*at)[2]) - 156), 48, 0.02) << at->str();
        }
        EXPECT_GE(curves, 4) << path;
        EXPECT_TRUE(contains(picture, "M 305 156 C")) << picture;
    }

    TEST(Figure, HasItsColoursInTheirPlaces)
    {
        Axes axes("title", "x (m)", "y (m)", {0.0, 0.0}, {10.0, 10.0});
        axes.addPolygon({{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}, {0.0, 5.0}}, Style{0xff0000, 1.0, 0x12632b, 1.0});
        axes.addPolygon({{5.0, 5.0}, {9.0, 5.0}, {9.0, 9.0}, {5.0, 9.0}}, Style{0xff0000, 1.0, 0x000000, 0.2});
        Figure figure;
        figure.addAxes(axes);
        const std::string file = temporaryFile("figure.png");
        figure.write(file);
        EXPECT_EQ(readFile(file).substr(0, 8), "\x89PNG\r\n\x1a\n");
        const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
            cairo_image_surface_create_from_png(file.c_str()), &cairo_surface_destroy);
        std::remove(file.c_str());
        ASSERT_EQ(cairo_surface_status(image.get()), CAIRO_STATUS_SUCCESS);
        EXPECT_EQ(cairo_image_surface_get_width(image.get()), 1120);
        const auto pixel = [&image](double x, double y)
        {
            const unsigned char *row = cairo_image_surface_get_data(image.get()) +
                                       static_cast<std::ptrdiff_t>(2 * y) * cairo_image_surface_get_stride(image.get());
            return reinterpret_cast<const std::uint32_t *>(row)[static_cast<std::ptrdiff_t>(2 * x)] & 0xFFFFFF;
        };
        EXPECT_EQ(pixel(182, 396), 0x12632bU);
        EXPECT_EQ(pixel(398, 180), 0xccccccU) << "a fifth of black on white";
        EXPECT_EQ(pixel(182, 180), 0xffffffU);
        EXPECT_EQ(pixel(10, 10), 0xffffffU);
    }

    TEST(Figure, DrawsTicksLabelsAndOneLegend)
    {
        Figure figure;
        for (const char *title : {"a < b", "second"})
        {
            Axes axes(title, "east (m)", "north (m)", {0.0, -0.3}, {2.0, 0.3});
            axes.addPolygon({{1.0, 0.0}, {2.0, 0.0}, {2.0, 0.1}}, {}, "obstacle");
            axes.addMarkers({{1.0, 0.0}}, 3.0, {}, "start");
            axes.addSegments({{{0.0, 0.0}, {1.0, 0.1}}, {{2.0, 0.0}, {3.0, 0.1}}}, {}, "slices");
            figure.addAxes(axes);
        }
        const auto all = words(figure);
        for (const std::string text : {"&lt;", "second", "east", "north", "(m)", "0", "0.5", "1.5", "-0.2", "0.2",
                                       "obstacle", "start", "slices"})
        {
            EXPECT_TRUE(hasWord(all, text)) << text;
        }
        EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto &word) { return word.text == "start"; }), 1);
        expectReadable(all, "two plots");
    }

    TEST(Figure, WordsDoNotOverlapWhateverTheRanges)
    {
        const double big = 1234567.0;
        const std::array<std::pair<Eigen::Vector2d, Eigen::Vector2d>, 8> ranges{{
            {{0, 0}, {20, 20}},
            {{0, 0}, {1, 20}},
            {{0, 0}, {0.3, 40}},
            {{0, 0}, {20, 1}},
            {{-300, 0.1}, {300, 0.6}},
            {{big, -big}, {big + 3, -big + 3}},
            {{-1e-7, -1e-7}, {1e-7, 3e-7}},
            {{-2e12, 1e12}, {3e12, 7e12}},
        }};
        for (const auto &range : ranges)
        {
            Figure figure;
            for (const char *side : {"above", "the side"})
            {
                Axes axes(
                    std::string("a problem with a long name that takes more than a line, MFA, cost 123.45, from ") +
                        side,
                    "x (world units)", "y (world units)", range.first, range.second);
                for (const char *legend :
                     {"obstacles", "slices", "the swarm's paths", "robot", "best path", "start", "goal"})
                {
                    axes.addPolygon({range.first}, {}, legend);
                }
                figure.addAxes(axes);
            }
            std::ostringstream which;
            which << range.first.transpose() << " to " << range.second.transpose();
            const auto all = words(figure);
            EXPECT_GE(all.size(), 60U) << which.str();
            expectReadable(all, which.str());
        }
    }

    TEST(Figure, TicksOfNeighboursAreToldApart)
    {
        Figure figure;
        figure.addAxes(Axes("title", "x", "y", {1234567.0, 0.0}, {1234570.0, 3.0}));
        const auto all = words(figure);
        for (const std::string text : {"1234567", "1234568", "1234569", "1234570"})
        {
            EXPECT_TRUE(hasWord(all, text)) << text;
        }
    }

    TEST(Figure, CutsWhatIsMuchLargerThanThePicture)
    {
        Axes axes("title", "x", "y", {0.0, 0.0}, {10.0, 10.0});
        axes.addPolygon({{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}}, Style{0, 1.0, 0x00ff00, 1.0});
        axes.addPolyline({{-1e9, 5.0}, {1e9, 5.0}, {1e9, 1e9}, {5.0, 1e9}, {5.0, -1e9}}, Style{0x0000ff, 1.0, {}, 1.0});
        axes.addPolyline({{1e9, 0.0}, {1e9, 1.0}}, Style{0xff0000, 1.0, {}, 1.0});
        const std::string picture = svg(axes);
        EXPECT_TRUE(contains(picture, "fill:rgb(0%,100%,0%)"));
        EXPECT_FALSE(contains(picture, "stroke:rgb(100%,0%,0%)")) << "it lies outside";
        std::smatch line;
        ASSERT_TRUE(std::regex_search(picture, line, std::regex("stroke:rgb\\(0%,0%,100%\\)[^>]* d=\"([^\"]*)\"")));
        EXPECT_EQ(line[1].str().find("M -560 276 L 1120 276 M 302 "), 0U) << line[1];
        const std::regex number("-?[0-9.]+");
        const std::string paths = std::regex_replace(picture, std::regex("[^>]* d=\"([^\"]*)\""), "$1");
        for (std::sregex_iterator at(paths.begin(), paths.end(), number), end; at != end; ++at)
        {
            EXPECT_LE(std::abs(std::strtod(at->str().c_str(), nullptr)), 2000.0);
        }
    }

    TEST(Figure, TextMayHoldAnyBytes)
    {
        Figure figure;
        figure.addAxes(Axes("gr\xC3\xBC\xC3\x9F \xFF\xFEone \xEF\xBF\xBFtwo \xED\xA0\x80three\nfour", "x", "y",
                            {0.0, 0.0}, {1.0, 1.0}));
        const auto all = words(figure);
        for (const std::string text : {"gr\xC3\xBC\xC3\x9F", "one", "two", "three", "four"})
        {
            EXPECT_TRUE(hasWord(all, text)) << text;
        }
    }

    TEST(Figure, TheExtensionIsTheFormat)
    {
        EXPECT_EQ(pictureFormat("a.b/c.svg"), PictureFormat::SVG);
        EXPECT_EQ(pictureFormat("C.PNG"), PictureFormat::PNG);
        EXPECT_EQ(pictureFormat("a.svg.pdf"), PictureFormat::PDF);
        for (const char *file : {"picture", "picture.", "picture.jpg", "a.svg/picture", ".svg", "svg", "a.svgz"})
        {
            try
            {
                pictureFormat(file);
                ADD_FAILURE() << file;
            }
            catch (const InputError &error)
            {
                for (const char *word : {file, ".svg, .png or .pdf"})
                {
                    EXPECT_TRUE(contains(error.what(), word)) << error.what();
                }
            }
        }
        Figure figure;
        figure.addAxes(Axes("title", "x", "y", {0.0, 0.0}, {1.0, 1.0}));
        EXPECT_EQ(figure.render(PictureFormat::PDF).rfind("%PDF-", 0), 0U);
        EXPECT_EQ(figure.render(PictureFormat::SVG).rfind("<?xml", 0), 0U);
        EXPECT_TRUE(contains(figure.render(PictureFormat::SVG), "</svg>"));
    }

    TEST(Figure, RefusesEmptyRangesAndUnwritableFiles)
    {
        EXPECT_THROW(Axes("", "", "", {0.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
        EXPECT_THROW(Axes("", "", "", {0.0, 0.0}, {std::numeric_limits<double>::infinity(), 1.0}),
                     std::invalid_argument);
        Figure figure;
        figure.addAxes(Axes("title", "x", "y", {0.0, 0.0}, {1.0, 1.0}));
        EXPECT_THROW(figure.write("/no/such/folder/picture.svg"), InputError);
        EXPECT_THROW(figure.write(temporaryFile("picture.txt")), InputError);
        EXPECT_FALSE(std::ifstream(temporaryFile("picture.txt")).is_open());
        const std::string full = temporaryFile("full.png");
        ASSERT_EQ(symlink("/dev/full", full.c_str()), 0);
        EXPECT_THROW(figure.write(full), InputError);
        std::remove(full.c_str());
    }
}  // namespace ompl_mfa::cli
