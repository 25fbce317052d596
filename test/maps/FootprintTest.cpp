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

#include "ompl_mfa/maps/Footprint.h"

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"
#include "maps/PlaneGeometry.h"
#include "maps/PlanePolygon.h"

namespace ompl_mfa::maps
{
    namespace
    {
        using ompl_mfa::test::inputErrorOf;
        using test::Point;
        using test::Polygon;

        const Polygon SHAPE_L = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
        const Polygon STAR = {{2, 0}, {0.5, 0.5}, {0, 2}, {-0.5, 0.5}, {-2, 0}, {-0.5, -0.5}, {0, -2}, {0.5, -0.5}};
        const Polygon COMB = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                              {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

        std::string footprintFault(const Polygon &corners, double padding = 0.0)
        {
            return inputErrorOf([&] { Footprint::polygon(corners, padding); });
        }
    }  // namespace

    TEST(Footprint, FaultsOfPolygons)
    {
        EXPECT_EQ(footprintFault({{0, 0}, {1, 0}, {0, 1}}), "");
        EXPECT_EQ(footprintFault({{0, 0}, {0, 1}, {1, 0}}), "");
        // corners on a straight side are not a fault
        EXPECT_EQ(footprintFault({{0, 0}, {1, 0}, {2, 0}, {0, 1}}), "");
        EXPECT_EQ(
            footprintFault({{0, 0}, {1, 0}}).rfind("footprint: a polygon has at least three corners; there are 2", 0),
            0U);
        EXPECT_EQ(footprintFault({{0, 0}, {1, 1}, {1, 0}, {0, 1}})
                      .rfind("footprint: the polygon crosses or touches itself: side 1-2 meets side 3-4", 0),
                  0U);
        EXPECT_EQ(footprintFault({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})
                      .rfind("footprint: the polygon crosses or touches", 0),
                  0U);
        EXPECT_EQ(
            footprintFault({{0, 0}, {1, 0}, {1, 0}, {0, 1}}).rfind("footprint: the corners 2 and 3 are the same", 0),
            0U);
        EXPECT_EQ(footprintFault({{0, 0}, {1, 0}, {2, 0}}).rfind("footprint: the polygon folds back", 0), 0U);
        EXPECT_EQ(footprintFault({{0, 0}, {1, 0}, {NAN, 1}}).rfind("footprint: corner 3 is not finite", 0), 0U);
        EXPECT_EQ(footprintFault({{0, 0}, {1, 0}, {0, 1}}, -0.1).rfind("the padding of a footprint is -0.1", 0), 0U);
        EXPECT_EQ(inputErrorOf([] { Footprint::disc(0.0); }).rfind("the radius of a disc is 0", 0), 0U);
    }

    TEST(Footprint, ConvexPartsAreThePolygon)
    {
        std::mt19937 random(2);
        for (Polygon polygon : {SHAPE_L, STAR, COMB})
        {
            for (const bool isReversed : {false, true})
            {
                if (isReversed)
                {
                    std::reverse(polygon.begin(), polygon.end());
                }
                const Footprint footprint = Footprint::polygon(polygon);
                double area = 0.0;
                for (const Polygon &part : footprint.convexParts())
                {
                    EXPECT_GT(doubleArea(part), 0.0);
                    area += doubleArea(part);
                }
                EXPECT_NEAR(area, std::abs(doubleArea(polygon)), 1e-9);
                for (int i = 0; i < 2000; ++i)
                {
                    const Point point(test::uniform(random, -3.0, 6.0), test::uniform(random, -3.0, 4.0));
                    const bool isCovered =
                        std::any_of(footprint.convexParts().begin(), footprint.convexParts().end(),
                                    [&](const Polygon &part) { return test::isInside(part, point); });
                    ASSERT_EQ(isCovered, test::isInside(polygon, point)) << point.transpose();
                }
            }
        }
        EXPECT_EQ(Footprint::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).convexParts().size(), 1U);
        EXPECT_EQ(Footprint::polygon(SHAPE_L).convexParts().size(), 2U);
        EXPECT_LE(Footprint::polygon(STAR).convexParts().size(), 5U);
        EXPECT_LE(Footprint::polygon(COMB).convexParts().size(), 5U);
    }

    TEST(Footprint, CirclesAreInsideAndAround)
    {
        for (const Polygon &polygon : {SHAPE_L, STAR, COMB})
        {
            const Footprint footprint = Footprint::polygon(polygon, 0.25);
            for (const Point &corner : polygon)
            {
                EXPECT_LE((corner - footprint.outer().centre).norm() + 0.25, footprint.outer().radius + 1e-12);
                EXPECT_LE(corner.norm(), footprint.reach() + 1e-12);
            }
            EXPECT_TRUE(test::isInside(polygon, footprint.inner().centre));
            EXPECT_NEAR(distanceToSides(polygon, footprint.inner().centre) + 0.25, footprint.inner().radius, 1e-12);
        }
        // the square inside of the L touches three sides
        EXPECT_NEAR(Footprint::polygon(SHAPE_L).inner().radius, 0.585786, 0.01);
        EXPECT_NEAR(Footprint::polygon({{-1, -0.5}, {2, -0.5}, {2, 0.5}, {-1, 0.5}}, 0.1).inscribedRadius(), 0.6,
                    1e-12);
        EXPECT_EQ(Footprint::polygon({{1, 0}, {2, 0}, {2, 1}}).inscribedRadius(), 0.0);
        EXPECT_EQ(Footprint::disc(0.3).inscribedRadius(), 0.3);
        EXPECT_EQ(Footprint::point().outer().radius, 0.0);
    }

    TEST(Footprint, OutlineIsAtThePadding)
    {
        const Polygon corners = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
        for (const Point &point : Footprint::polygon(corners, 0.5).outline())
        {
            EXPECT_FALSE(test::isInside(corners, point));
            EXPECT_NEAR(distanceToSides(corners, point), 0.5, 1e-9);
        }
        for (const Point &point : Footprint::disc(0.5).outline())
        {
            EXPECT_NEAR(point.norm(), 0.5, 1e-9);
        }
        EXPECT_EQ(Footprint::polygon(corners).outline(), corners);
    }
}  // namespace ompl_mfa::maps
