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

#ifndef OMPL_MFA_CLI_FIGURE_
#define OMPL_MFA_CLI_FIGURE_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cli/Canvas.h"

namespace ompl_mfa::cli
{
    /** \brief An entry of a legend: its text, and the shape and style explained. */
    struct LegendEntry
    {
        enum class Key
        {
            Line,
            Patch,
            Dot
        };

        std::string words;
        Key key;
        Style style;
    };

    /** \brief One plot with axes, ticks and title. Shapes are given in axis units and clipped to the axes; those added
        later are drawn on top. The scales of x and y are equal. */
    class Axes
    {
    public:
        using Points = Canvas::Points;
        using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

        /** \brief Labels include the unit, as in `x (m)`. Throws std::invalid_argument for an empty range. */
        Axes(std::string title, std::string xLabel, std::string yLabel, const Eigen::Vector2d &lower,
             const Eigen::Vector2d &upper);

        /** \brief These functions add a legend entry unless \e legend is empty. */
        void addPolyline(const Points &points, const Style &style, const std::string &legend = "");
        void addPolygon(const Points &points, const Style &style, const std::string &legend = "");
        void addSegments(const Segments &segments, const Style &style, const std::string &legend = "");

        /** \brief A disc of \e radius in units of the axes. */
        void addCircle(const Eigen::Vector2d &center, double radius, const Style &style,
                       const std::string &legend = "");

        /** \brief Dots of \e radius pixels. */
        void addMarkers(const Points &points, double radius, const Style &style, const std::string &legend = "");

        /** \brief The raster's toAxes is in units of the axes. */
        void addRaster(const Raster &raster);

        void addLegendEntry(const LegendEntry &entry);

        /** \brief Makes y point down. */
        void turnYDown()
        {
            yDown_ = true;
        }

        const std::vector<LegendEntry> &legend() const;

    private:
        friend class Figure;

        enum class Kind
        {
            Lines,
            Polygon,
            Circle,
            Markers,
            Raster
        };

        struct Shape
        {
            Kind kind;
            std::vector<Points> points;
            double radius;
            Style style;
            std::shared_ptr<const cli::Raster> raster{};
        };

        struct Tick
        {
            double value;
            std::string label;
        };

        /** \brief Positions in a panel, in pixels from its upper left corner. */
        struct Layout
        {
            Eigen::Vector2d corner;
            Eigen::Vector2d size;
            std::vector<Tick> xTicks;
            std::vector<Tick> yTicks;
            double yLabelX;
            double center;
            std::vector<std::string> titleLines;
            double bodyHeight;
        };

        Layout layOut(double width) const;
        void draw(Canvas &canvas, const Layout &layout) const;
        void drawShape(Canvas &canvas, const Shape &shape, const Layout &layout) const;
        void drawTicks(Canvas &canvas, const Layout &layout) const;
        Eigen::Vector2d toPixels(const Eigen::Vector2d &point, const Layout &layout) const;
        static std::vector<Tick> placeTicks(double lower, double upper, double pixels, bool horizontal);

        std::string title_;
        std::string xLabel_;
        std::string yLabel_;
        Eigen::Vector2d lower_;
        Eigen::Vector2d upper_;
        std::vector<Shape> shapes_;
        std::vector<LegendEntry> legend_;
        bool yDown_{false};
    };

    /** \brief A picture with one or more plots side by side and one legend below them, in which equal entries appear
        once. */
    class Figure
    {
    public:
        void addAxes(const Axes &axes);

        /** \brief The content of a file of this format; the same for the same figure, in any locale. */
        std::string render(PictureFormat format) const;

        /** \brief Throws InputError if \e file cannot be written, or as pictureFormat(). */
        void write(const std::string &file) const;

    private:
        std::vector<Axes> axes_;
    };
}  // namespace ompl_mfa::cli

#endif
