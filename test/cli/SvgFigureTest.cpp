#include "cli/SvgFigure.h"

#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

using ompl_mfa::cli::SvgAxes;
using ompl_mfa::cli::SvgFigure;

namespace
{
    bool contains(const std::string &text, const std::string &part)
    {
        return text.find(part) != std::string::npos;
    }
}  // namespace

TEST(SvgFigure, placesPointsInTheAxes)
{
    // 200 x 188 pixels leave a plotting area of 120 x 100 whose upper left corner is (62, 36).
    SvgAxes axes("title", "x [m]", "y [m]", {0.0, 0.0}, {10.0, 10.0});
    axes.addPolyline({{0.0, 0.0}, {10.0, 10.0}, {5.0, 2.5}}, {});
    const std::string svg = axes.svg({0.0, 0.0}, {200.0, 188.0}, "id");
    EXPECT_TRUE(contains(svg, "M62.0 136.0L182.0 36.0L122.0 111.0\"")) << svg;
}

TEST(SvgFigure, equalAspectMakesCirclesRoundAndTrue)
{
    SvgAxes axes("title", "x [m]", "y [m]", {0.0, 0.0}, {10.0, 10.0});
    axes.setEqualAspect();
    axes.addCircle({5.0, 5.0}, 2.0, {});
    const std::string svg = axes.svg({0.0, 0.0}, {200.0, 188.0}, "id");
    EXPECT_TRUE(contains(svg, "cx=\"122.0\" cy=\"86.0\" r=\"20.0\"")) << svg;
}

TEST(SvgFigure, drawsTicksLabelsAndLegend)
{
    SvgAxes axes("a < b & c", "x [m]", "y [m]", {0.0, -0.3}, {20.0, 0.3});
    axes.addPolygon({{1.0, 0.0}, {2.0, 0.0}, {2.0, 0.1}}, {}, "obstacle");
    axes.addMarkers({{1.0, 0.0}}, 3.0, {}, "start");
    axes.addSegments({{{0.0, 0.0}, {1.0, 0.1}}, {{2.0, 0.0}, {3.0, 0.1}}}, {}, "slices");
    SvgFigure figure(300, 200);
    figure.addAxes(axes);
    const std::string svg = figure.svg();
    for (const std::string text : {">a &lt; b &amp; c<", ">x [m]<", ">y [m]<", ">0<", ">5<", ">20<", ">-0.3<", ">0.2<",
                                   ">obstacle<", ">slices<"})
        EXPECT_TRUE(contains(svg, text)) << text;
    EXPECT_EQ(axes.legendHeight(), 40.0) << "three entries, two a row";
}

TEST(SvgFigure, refusesEmptyRangesAndUnwritableFiles)
{
    EXPECT_THROW(SvgAxes("", "", "", {0.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(SvgAxes("", "", "", {0.0, 0.0}, {std::numeric_limits<double>::infinity(), 1.0}),
                 std::invalid_argument);
    EXPECT_THROW(SvgFigure().write("/no/such/folder/picture.svg"), ompl_mfa::InputError);
}
