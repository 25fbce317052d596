#include "cli/SvgFigure.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace
{
    constexpr double MARGIN_LEFT = 62;
    constexpr double MARGIN_RIGHT = 18;
    constexpr double MARGIN_TOP = 36;
    constexpr double MARGIN_BOTTOM = 52;
    constexpr double LEGEND_ROW = 20;
    constexpr double FONT_SIZE = 13;

    std::string number(double value)
    {
        return ompl_mfa::fixedText(value, 1);
    }

    std::string escape(const std::string &text)
    {
        std::string escaped;
        for (const char c : text)
        {
            if (c == '&')
                escaped += "&amp;";
            else if (c == '<')
                escaped += "&lt;";
            else if (c == '"')
                escaped += "&quot;";
            else
                escaped += c;
        }
        return escaped;
    }

    std::string attributes(const ompl_mfa::cli::SvgStyle &style)
    {
        return " fill=\"" + style.fill + "\" stroke=\"" + style.stroke + "\" stroke-width=\"" +
               ompl_mfa::numberText(style.strokeWidth, 6) + "\" opacity=\"" + ompl_mfa::numberText(style.opacity, 6) +
               "\"";
    }

    std::string text(const Eigen::Vector2d &at, const std::string &words, const std::string &anchor,
                     double size = FONT_SIZE, const std::string &extra = "")
    {
        return "<text x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) + "\" font-size=\"" +
               ompl_mfa::numberText(size, 6) + "\" text-anchor=\"" + anchor + "\"" + extra + ">" + escape(words) +
               "</text>\n";
    }

    std::string line(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const std::string &color)
    {
        return "<line x1=\"" + number(a.x()) + "\" y1=\"" + number(a.y()) + "\" x2=\"" + number(b.x()) + "\" y2=\"" +
               number(b.y()) + "\" stroke=\"" + color + "\"/>\n";
    }

    /** \brief Multiples of 1, 2 or 5 times a power of ten, about six of them. */
    std::vector<double> ticks(double lower, double upper)
    {
        const double raw = (upper - lower) / 6;
        const double power = std::pow(10.0, std::floor(std::log10(raw)));
        const double fraction = raw / power;
        const double factor = fraction <= 1.0 ? 1.0 : fraction <= 2.0 ? 2.0 : fraction <= 5.0 ? 5.0 : 10.0;
        const double step = factor * power;
        std::vector<double> values;
        const auto last = static_cast<long>(std::floor(upper / step + 1e-9));
        for (auto k = static_cast<long>(std::ceil(lower / step - 1e-9)); k <= last; ++k)
            values.push_back(static_cast<double>(k) * step);
        return values;
    }

    std::string tickLabel(double value)
    {
        return ompl_mfa::numberText(value, 6);
    }
}  // namespace

ompl_mfa::cli::SvgAxes::SvgAxes(std::string title, std::string xLabel, std::string yLabel, const Eigen::Vector2d &lower,
                                const Eigen::Vector2d &upper)
  : title_(std::move(title))
  , xLabel_(std::move(xLabel))
  , yLabel_(std::move(yLabel))
  , lower_(lower)
  , upper_(upper)
{
    if (!((upper_ - lower_).minCoeff() > 0.0) || !(upper_ - lower_).allFinite())
        throw std::invalid_argument("SvgAxes: the upper bounds must be greater than the lower ones, all finite");
}

void ompl_mfa::cli::SvgAxes::setEqualAspect()
{
    equalAspect_ = true;
}

void ompl_mfa::cli::SvgAxes::addPolyline(const Points &points, const SvgStyle &style, const std::string &legend)
{
    add(Kind::Polyline, points, 0.0, style, legend);
}

void ompl_mfa::cli::SvgAxes::addPolygon(const Points &points, const SvgStyle &style, const std::string &legend)
{
    add(Kind::Polygon, points, 0.0, style, legend);
}

void ompl_mfa::cli::SvgAxes::addSegments(const Segments &segments, const SvgStyle &style, const std::string &legend)
{
    Points ends;
    ends.reserve(2 * segments.size());
    for (const auto &segment : segments)
    {
        ends.push_back(segment.first);
        ends.push_back(segment.second);
    }
    add(Kind::Segments, std::move(ends), 0.0, style, legend);
}

void ompl_mfa::cli::SvgAxes::addCircle(const Eigen::Vector2d &center, double radius, const SvgStyle &style,
                                       const std::string &legend)
{
    add(Kind::Circle, {center}, radius, style, legend);
}

void ompl_mfa::cli::SvgAxes::addMarkers(const Points &points, double radius, const SvgStyle &style,
                                        const std::string &legend)
{
    add(Kind::Markers, points, radius, style, legend);
}

void ompl_mfa::cli::SvgAxes::add(Kind kind, Points points, double radius, const SvgStyle &style,
                                 const std::string &legend)
{
    shapes_.push_back({kind, std::move(points), radius, style});
    if (!legend.empty())
        legend_.push_back({legend, kind, style});
}

double ompl_mfa::cli::SvgAxes::legendHeight() const
{
    const std::size_t rows = (legend_.size() + 1) / 2;
    return LEGEND_ROW * static_cast<double>(rows);
}

ompl_mfa::cli::SvgAxes::Frame ompl_mfa::cli::SvgAxes::layOut(const Eigen::Vector2d &corner,
                                                             const Eigen::Vector2d &size) const
{
    Frame frame{corner + Eigen::Vector2d(MARGIN_LEFT, MARGIN_TOP),
                size - Eigen::Vector2d(MARGIN_LEFT + MARGIN_RIGHT, MARGIN_TOP + MARGIN_BOTTOM)};
    if (equalAspect_)
    {
        const Eigen::Vector2d range = upper_ - lower_;
        const Eigen::Vector2d used = range * (frame.size.array() / range.array()).minCoeff();
        frame.corner.x() += (frame.size.x() - used.x()) / 2;
        frame.size = used;
    }
    return frame;
}

Eigen::Vector2d ompl_mfa::cli::SvgAxes::toPixels(const Eigen::Vector2d &point, const Frame &frame) const
{
    const Eigen::Vector2d part = (point - lower_).cwiseQuotient(upper_ - lower_);
    return frame.corner + Eigen::Vector2d(part.x() * frame.size.x(), (1.0 - part.y()) * frame.size.y());
}

std::string ompl_mfa::cli::SvgAxes::drawShape(const Shape &shape, const Frame &frame) const
{
    std::ostringstream out;
    if (shape.kind == Kind::Circle || shape.kind == Kind::Markers)
    {
        const double scale = shape.kind == Kind::Circle ? frame.size.x() / (upper_.x() - lower_.x()) : 1.0;
        for (const auto &point : shape.points)
        {
            const Eigen::Vector2d center = toPixels(point, frame);
            out << "<circle cx=\"" << number(center.x()) << "\" cy=\"" << number(center.y()) << "\" r=\""
                << number(shape.radius * scale) << "\"" << attributes(shape.style) << "/>\n";
        }
        return out.str();
    }
    out << "<path d=\"";
    for (std::size_t i = 0; i < shape.points.size(); ++i)
    {
        const bool starts = i == 0 || (shape.kind == Kind::Segments && i % 2 == 0);
        const Eigen::Vector2d point = toPixels(shape.points[i], frame);
        out << (starts ? "M" : "L") << number(point.x()) << " " << number(point.y());
    }
    out << (shape.kind == Kind::Polygon ? "Z" : "") << "\"" << attributes(shape.style)
        << " stroke-linejoin=\"round\"/>\n";
    return out.str();
}

std::string ompl_mfa::cli::SvgAxes::drawTicks(const Frame &frame) const
{
    std::string out;
    const double bottom = frame.corner.y() + frame.size.y();
    for (const double x : ticks(lower_.x(), upper_.x()))
    {
        const double pixel = toPixels({x, lower_.y()}, frame).x();
        out += line({pixel, bottom}, {pixel, bottom + 5}, "#222222");
        out += text({pixel, bottom + 19}, tickLabel(x), "middle");
    }
    for (const double y : ticks(lower_.y(), upper_.y()))
    {
        const double pixel = toPixels({lower_.x(), y}, frame).y();
        out += line({frame.corner.x() - 5, pixel}, {frame.corner.x(), pixel}, "#222222");
        out += text({frame.corner.x() - 8, pixel + 4}, tickLabel(y), "end");
    }
    return out;
}

std::string ompl_mfa::cli::SvgAxes::drawLegend(const Frame &frame) const
{
    std::string out;
    for (std::size_t i = 0; i < legend_.size(); ++i)
    {
        const auto &entry = legend_[i];
        const double x = frame.corner.x() + (i % 2 == 0 ? 0.0 : frame.size.x() / 2);
        const std::size_t row = i / 2;
        const double y =
            frame.corner.y() + frame.size.y() + MARGIN_BOTTOM + LEGEND_ROW * (static_cast<double>(row) + 0.5);
        std::ostringstream key;
        if (entry.kind == Kind::Polyline || entry.kind == Kind::Segments)
        {
            key << "<path d=\"M" << number(x) << " " << number(y) << "h24\"" << attributes(entry.style) << "/>\n";
        }
        else if (entry.kind == Kind::Polygon)
        {
            key << "<rect x=\"" << number(x + 5) << "\" y=\"" << number(y - 6) << "\" width=\"14\" height=\"12\""
                << attributes(entry.style) << "/>\n";
        }
        else
        {
            key << "<circle cx=\"" << number(x + 12) << "\" cy=\"" << number(y) << "\" r=\"5\""
                << attributes(entry.style) << "/>\n";
        }
        out += key.str() + text({x + 32, y + 4}, entry.label, "start");
    }
    return out;
}

std::string ompl_mfa::cli::SvgAxes::svg(const Eigen::Vector2d &corner, const Eigen::Vector2d &size,
                                        const std::string &id) const
{
    const Frame frame = layOut(corner, size);
    const std::string box = "x=\"" + number(frame.corner.x()) + "\" y=\"" + number(frame.corner.y()) + "\" width=\"" +
                            number(frame.size.x()) + "\" height=\"" + number(frame.size.y()) + "\"";
    std::string out = "<clipPath id=\"" + id + "\"><rect " + box + "/></clipPath>\n";
    out += "<g clip-path=\"url(#" + id + ")\">\n";
    for (const auto &shape : shapes_)
        out += drawShape(shape, frame);
    out += "</g>\n<rect " + box + " fill=\"none\" stroke=\"#222222\"/>\n";
    out += drawTicks(frame);

    const double centerX = frame.corner.x() + frame.size.x() / 2;
    const double centerY = frame.corner.y() + frame.size.y() / 2;
    out += text({centerX, frame.corner.y() - 14}, title_, "middle", FONT_SIZE + 2);
    out += text({centerX, frame.corner.y() + frame.size.y() + 40}, xLabel_, "middle");
    const double labelX = frame.corner.x() - 44;
    out += text({labelX, centerY}, yLabel_, "middle", FONT_SIZE,
                " transform=\"rotate(-90 " + number(labelX) + " " + number(centerY) + ")\"");
    return out + drawLegend(frame);
}

ompl_mfa::cli::SvgFigure::SvgFigure(double width, double height)
  : width_(width)
  , height_(height)
{
}

void ompl_mfa::cli::SvgFigure::addAxes(const SvgAxes &axes)
{
    axes_.push_back(axes);
}

std::string ompl_mfa::cli::SvgFigure::svg() const
{
    double legend = 0.0;
    for (const auto &axes : axes_)
        legend = std::max(legend, axes.legendHeight());
    const std::string width = number(width_ * static_cast<double>(axes_.size()));
    const std::string height = number(height_ + legend + 8);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                      "\" viewBox=\"0 0 " + width + " " + height + "\" font-family=\"sans-serif\" fill=\"#222222\">\n";
    out += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < axes_.size(); ++i)
        out += axes_[i].svg({width_ * static_cast<double>(i), 0.0}, {width_, height_}, "plot" + std::to_string(i));
    return out + "</svg>\n";
}

void ompl_mfa::cli::SvgFigure::write(const std::string &file) const
{
    std::ofstream out(file);
    out << svg();
    out.close();
    if (!out)
        throw InputError("cannot write the picture '" + file + "'; a file in an existing, writable folder is accepted");
}
