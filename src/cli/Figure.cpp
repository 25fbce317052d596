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

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {

        constexpr double PANEL_WIDTH = 560;
        constexpr double LONGEST_AXIS = 480;
        constexpr double FONT_SIZE = 13;
        constexpr double TITLE_SIZE = 15;
        constexpr double TITLE_LINE = 20;
        constexpr double PADDING = 12;
        constexpr double TICK_LENGTH = 5;
        constexpr double TICK_GAP = 8;
        // height of digits above the baseline
        constexpr double DIGIT_HEIGHT = 10;
        constexpr double BELOW_AXIS = 52;
        constexpr double LEGEND_ROW = 20;
        constexpr double LEGEND_KEY = 32;
        constexpr double LEGEND_GAP = 24;

        /** \brief Width of the longest label, in pixels. */
        template <typename Ticks>
        double widest(const Ticks &ticks)
        {
            double width = 0.0;
            for (const auto &tick : ticks)
            {
                width = std::max(width, textWidth(tick.label, FONT_SIZE));
            }
            return width;
        }

        /** \brief Breaks a text into lines of at most \e width pixels, unless a word is longer. */
        std::vector<std::string> wrap(const std::string &text, double width)
        {
            std::vector<std::string> lines;
            std::istringstream words(text);
            for (std::string word; words >> word;)
            {
                if (!lines.empty() && textWidth(lines.back() + " " + word, TITLE_SIZE) <= width)
                {
                    lines.back() += " " + word;
                }
                else
                {
                    lines.push_back(word);
                }
            }
            return lines;
        }

        /** \brief The entries in columns of equal width, centred below the plots. */
        class Legend
        {
        public:
            Legend(std::vector<LegendEntry> entries, double width)
              : entries_(std::move(entries))
            {
                for (const auto &entry : entries_)
                {
                    column_ = std::max(column_, LEGEND_KEY + textWidth(entry.words, FONT_SIZE) + LEGEND_GAP);
                }
                const double room = width - 2 * PADDING + LEGEND_GAP;
                const std::size_t most = entries_.empty() ? 1 : std::max(1, static_cast<int>(room / column_));
                rows_ = (entries_.size() + most - 1) / most;
                // No more columns than these rows need.
                columns_ = rows_ == 0 ? 1 : (entries_.size() + rows_ - 1) / rows_;
                left_ = (width - static_cast<double>(columns_) * column_ + LEGEND_GAP) / 2;
            }

            double height() const
            {
                return LEGEND_ROW * static_cast<double>(rows_);
            }

            void draw(Canvas &canvas, double top) const
            {
                for (std::size_t i = 0; i < entries_.size(); ++i)
                {
                    const std::size_t row = i / columns_;
                    const double x = left_ + column_ * static_cast<double>(i % columns_);
                    const double y = top + LEGEND_ROW * (static_cast<double>(row) + 0.5);
                    drawKey(canvas, entries_[i], x, y);
                    canvas.drawText(entries_[i].words, {x + LEGEND_KEY, y + 4}, FONT_SIZE, Anchor::Start);
                }
            }

        private:
            static void drawKey(Canvas &canvas, const LegendEntry &entry, double x, double y)
            {
                if (entry.key == LegendEntry::Key::Line)
                {
                    // A single one of many faint lines would not be visible.
                    Style style = entry.style;
                    style.strokeWidth = std::max(style.strokeWidth, 1.2);
                    style.opacity = 1.0;
                    canvas.drawLines({{{x, y}, {x + 24, y}}}, style);
                }
                else if (entry.key == LegendEntry::Key::Patch)
                {
                    canvas.drawPolygon({{x + 5, y - 6}, {x + 19, y - 6}, {x + 19, y + 6}, {x + 5, y + 6}}, entry.style);
                }
                else
                {
                    canvas.drawCircle({x + 12, y}, 5, entry.style);
                }
            }

            std::vector<LegendEntry> entries_;
            double column_{0.0};
            std::size_t rows_{0};
            std::size_t columns_{1};
            double left_{0.0};
        };
    }  // namespace

    Axes::Axes(std::string title, std::string xLabel, std::string yLabel, const Eigen::Vector2d &lower,
               const Eigen::Vector2d &upper)
      : title_(std::move(title))
      , xLabel_(std::move(xLabel))
      , yLabel_(std::move(yLabel))
      , lower_(lower)
      , upper_(upper)
    {
        if (!((upper_ - lower_).minCoeff() > 0.0) || !(upper_ - lower_).allFinite())
        {
            throw std::invalid_argument("Axes: the upper bounds must be greater than the lower ones, all finite");
        }
    }

    void Axes::addPolyline(const Points &points, const Style &style, const std::string &legend)
    {
        shapes_.push_back({Kind::Lines, {points}, 0.0, style});
        if (!legend.empty())
        {
            legend_.push_back({legend, LegendEntry::Key::Line, style});
        }
    }

    void Axes::addPolygon(const Points &points, const Style &style, const std::string &legend)
    {
        shapes_.push_back({Kind::Polygon, {points}, 0.0, style});
        if (!legend.empty())
        {
            legend_.push_back({legend, LegendEntry::Key::Patch, style});
        }
    }

    void Axes::addSegments(const Segments &segments, const Style &style, const std::string &legend)
    {
        std::vector<Points> lines;
        lines.reserve(segments.size());
        for (const auto &segment : segments)
        {
            lines.push_back({segment.first, segment.second});
        }
        shapes_.push_back({Kind::Lines, std::move(lines), 0.0, style});
        if (!legend.empty())
        {
            legend_.push_back({legend, LegendEntry::Key::Line, style});
        }
    }

    void Axes::addCircle(const Eigen::Vector2d &center, double radius, const Style &style, const std::string &legend)
    {
        shapes_.push_back({Kind::Circle, {{center}}, radius, style});
        if (!legend.empty())
        {
            legend_.push_back({legend, LegendEntry::Key::Dot, style});
        }
    }

    void Axes::addMarkers(const Points &points, double radius, const Style &style, const std::string &legend)
    {
        shapes_.push_back({Kind::Markers, {points}, radius, style});
        if (!legend.empty())
        {
            legend_.push_back({legend, LegendEntry::Key::Dot, style});
        }
    }

    void Axes::addRaster(const Raster &raster)
    {
        shapes_.push_back({Kind::Raster, {}, 0.0, {}, std::make_shared<Raster>(raster)});
    }

    void Axes::addLegendEntry(const LegendEntry &entry)
    {
        legend_.push_back(entry);
    }

    const std::vector<LegendEntry> &Axes::legend() const
    {
        return legend_;
    }

    /* Multiples of 1, 2 or 5 times a power of ten: about six of them, or fewer if their labels need more space. */
    std::vector<Axes::Tick> Axes::placeTicks(double lower, double upper, double pixels, bool horizontal)
    {
        std::vector<Tick> ticks;
        for (int count = 6; count >= 1; --count)
        {
            const double raw = (upper - lower) / count;
            const double power = std::floor(std::log10(raw));
            const double fraction = raw / std::pow(10.0, power);
            const double factor = fraction <= 1.0 ? 1.0 : fraction <= 2.0 ? 2.0 : fraction <= 5.0 ? 5.0 : 10.0;
            const double step = factor * std::pow(10.0, power);
            // As many digits as distinguish neighbouring ticks.
            const double greatest = std::max({std::abs(lower), std::abs(upper), step});
            const int digits = std::clamp(static_cast<int>(std::floor(std::log10(greatest)) - power) + 1, 6, 17);

            std::vector<Tick> candidates;
            const double last = std::floor(upper / step + 1e-9);
            for (double k = std::ceil(lower / step - 1e-9); k <= last; k += 1.0)
            {
                candidates.push_back({k * step, text::numberText(k * step + 0.0, digits)});
            }
            if (candidates.empty())
            {
                break;
            }
            ticks = std::move(candidates);
            const double space = horizontal ? widest(ticks) + 10 : 18;
            if (step / (upper - lower) * pixels >= space)
            {
                return ticks;
            }
        }
        ticks.resize(std::min<std::size_t>(ticks.size(), 1));
        return ticks;
    }

    Axes::Layout Axes::layOut(double width) const
    {
        const Eigen::Vector2d range = upper_ - lower_;
        Layout layout;
        double left = 62;
        double right = 18;
        // The margins depend on the labels, and these on the space between the margins. Two iterations suffice: the
        // second has less space, and its labels are not longer.
        for (int look = 0; look < 2; ++look)
        {
            const double room = width - left - right;
            layout.size = range * std::min(room / range.x(), LONGEST_AXIS / range.y());
            layout.center = left + room / 2;
            layout.xTicks = placeTicks(lower_.x(), upper_.x(), layout.size.x(), true);
            layout.yTicks = placeTicks(lower_.y(), upper_.y(), layout.size.y(), false);
            left = std::max(left, widest(layout.yTicks) + TICK_GAP + FONT_SIZE + 2 * PADDING);
            right = std::max(right, widest(layout.xTicks) / 2 + TICK_GAP);
        }
        layout.bodyHeight = std::max(layout.size.y(), textWidth(yLabel_, FONT_SIZE));
        layout.corner = {layout.center - layout.size.x() / 2, (layout.bodyHeight - layout.size.y()) / 2};
        layout.yLabelX = layout.corner.x() - TICK_GAP - widest(layout.yTicks) - PADDING;
        layout.titleLines = wrap(title_, 2 * (width - layout.center - PADDING));
        return layout;
    }

    Eigen::Vector2d Axes::toPixels(const Eigen::Vector2d &point, const Layout &layout) const
    {
        const Eigen::Vector2d part = (point - lower_).cwiseQuotient(upper_ - lower_);
        const double down = yDown_ ? part.y() : 1.0 - part.y();
        return layout.corner + Eigen::Vector2d(part.x() * layout.size.x(), down * layout.size.y());
    }

    void Axes::drawShape(Canvas &canvas, const Shape &shape, const Layout &layout) const
    {
        std::vector<Points> lines;
        for (const auto &points : shape.points)
        {
            lines.emplace_back();
            for (const auto &point : points)
            {
                lines.back().push_back(toPixels(point, layout));
            }
        }
        if (shape.kind == Kind::Raster)
        {
            Raster placed = *shape.raster;
            Eigen::Affine2d toPixel = Eigen::Affine2d::Identity();
            const Eigen::Vector2d origin = toPixels({0.0, 0.0}, layout);
            toPixel.matrix().col(0).head<2>() = toPixels({1.0, 0.0}, layout) - origin;
            toPixel.matrix().col(1).head<2>() = toPixels({0.0, 1.0}, layout) - origin;
            toPixel.matrix().col(2).head<2>() = origin;
            placed.toAxes = toPixel * placed.toAxes;
            canvas.drawRaster(placed);
        }
        else if (shape.kind == Kind::Lines)
        {
            canvas.drawLines(lines, shape.style);
        }
        else if (shape.kind == Kind::Polygon)
        {
            canvas.drawPolygon(lines.front(), shape.style);
        }
        else
        {
            const double scale = shape.kind == Kind::Circle ? layout.size.x() / (upper_.x() - lower_.x()) : 1.0;
            for (const auto &point : lines.front())
            {
                canvas.drawCircle(point, shape.radius * scale, shape.style);
            }
        }
    }

    void Axes::drawTicks(Canvas &canvas, const Layout &layout) const
    {
        const double bottom = layout.corner.y() + layout.size.y();
        for (const auto &tick : layout.xTicks)
        {
            const double x = toPixels({tick.value, lower_.y()}, layout).x();
            canvas.drawLines({{{x, bottom}, {x, bottom + TICK_LENGTH}}}, {});
            canvas.drawText(tick.label, {x, bottom + TICK_GAP + DIGIT_HEIGHT + 1}, FONT_SIZE, Anchor::Middle);
        }
        for (const auto &tick : layout.yTicks)
        {
            const double y = toPixels({lower_.x(), tick.value}, layout).y();
            canvas.drawLines({{{layout.corner.x() - TICK_LENGTH, y}, {layout.corner.x(), y}}}, {});
            canvas.drawText(tick.label, {layout.corner.x() - TICK_GAP, y + DIGIT_HEIGHT / 2}, FONT_SIZE, Anchor::End);
        }
    }

    void Axes::draw(Canvas &canvas, const Layout &layout) const
    {
        canvas.setClip(layout.corner, layout.size);
        for (const auto &shape : shapes_)
        {
            drawShape(canvas, shape, layout);
        }
        canvas.clearClip();
        const Eigen::Vector2d &corner = layout.corner;
        const Eigen::Vector2d end = corner + layout.size;
        canvas.drawPolygon({corner, {end.x(), corner.y()}, end, {corner.x(), end.y()}}, {});
        drawTicks(canvas, layout);
        canvas.drawText(xLabel_, {layout.center, end.y() + BELOW_AXIS - 12}, FONT_SIZE, Anchor::Middle);
        canvas.drawText(yLabel_, {layout.yLabelX, (corner.y() + end.y()) / 2}, FONT_SIZE, Anchor::Middle, true);
    }

    void Figure::addAxes(const Axes &axes)
    {
        axes_.push_back(axes);
    }

    std::string Figure::render(PictureFormat format) const
    {
        std::vector<LegendEntry> entries;
        std::vector<Axes::Layout> layouts;
        std::size_t titleLines = 0;
        double bodyHeight = 0.0;
        for (const auto &axes : axes_)
        {
            for (const auto &entry : axes.legend())
            {
                if (std::none_of(entries.begin(), entries.end(), [&](const auto &e) { return e.words == entry.words; }))
                {
                    entries.push_back(entry);
                }
            }
            layouts.push_back(axes.layOut(PANEL_WIDTH));
            titleLines = std::max(titleLines, layouts.back().titleLines.size());
            bodyHeight = std::max(bodyHeight, layouts.back().bodyHeight);
        }

        const double width = PANEL_WIDTH * static_cast<double>(axes_.size());
        const double titleHeight = TITLE_LINE * static_cast<double>(titleLines) + 2 * PADDING - 8;
        const Legend legend(entries, width);
        const double plotHeight = std::ceil(titleHeight + bodyHeight + BELOW_AXIS);
        Canvas canvas(format, {width, plotHeight + legend.height() + PADDING});
        for (std::size_t i = 0; i < axes_.size(); ++i)
        {
            Axes::Layout &layout = layouts[i];
            const Eigen::Vector2d corner(PANEL_WIDTH * static_cast<double>(i), titleHeight);
            layout.corner += corner;
            layout.center += corner.x();
            layout.yLabelX += corner.x();
            double baseline = titleHeight - PADDING - TITLE_LINE * (static_cast<double>(layout.titleLines.size()) - 1);
            for (const auto &line : layout.titleLines)
            {
                canvas.drawText(line, {layout.center, baseline}, TITLE_SIZE, Anchor::Middle);
                baseline += TITLE_LINE;
            }
            axes_[i].draw(canvas, layout);
        }
        legend.draw(canvas, plotHeight);
        return canvas.finish();
    }

    void Figure::write(const std::string &file) const
    {
        const std::string content = render(pictureFormat(file));
        std::ofstream out(file, std::ios::binary);
        out << content;
        out.close();
        if (!out)
        {
            throw InputError("cannot write the picture '" + file +
                             "'; a file in an existing, writable folder is accepted");
        }
    }
}  // namespace ompl_mfa::cli
