#ifndef OMPL_MFA_CLI_SVG_FIGURE_
#define OMPL_MFA_CLI_SVG_FIGURE_

#include <string>
#include <vector>

#include <Eigen/Core>

namespace ompl_mfa::cli
{
    /** \brief How a shape is drawn: colours as SVG names them, widths in pixels. */
    struct SvgStyle
    {
        std::string stroke{"#222222"};
        double strokeWidth{1.0};
        std::string fill{"none"};
        double opacity{1.0};
    };

    /** \brief One plot with its axes, ticks, title and legend; everything is given in the axes' own units and clipped
        to them. Shapes drawn later lie above. */
    class SvgAxes
    {
    public:
        using Points = std::vector<Eigen::Vector2d>;
        using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

        /** \brief Labels carry the unit, as in `x [m]`. The ranges must not be empty: throws std::invalid_argument. */
        SvgAxes(std::string title, std::string xLabel, std::string yLabel, const Eigen::Vector2d &lower,
                const Eigen::Vector2d &upper);

        /** \brief One unit of x is as long as one of y. */
        void setEqualAspect();

        /** \brief Each adds a legend entry unless \e legend is empty. */
        void addPolyline(const Points &points, const SvgStyle &style, const std::string &legend = "");
        void addPolygon(const Points &points, const SvgStyle &style, const std::string &legend = "");
        void addSegments(const Segments &segments, const SvgStyle &style, const std::string &legend = "");

        /** \brief A disc of \e radius in units of the axes, which should have equal aspect. */
        void addCircle(const Eigen::Vector2d &center, double radius, const SvgStyle &style,
                       const std::string &legend = "");

        /** \brief Dots of \e radius pixels. */
        void addMarkers(const Points &points, double radius, const SvgStyle &style, const std::string &legend = "");

        /** \brief The SVG of the plot in a box of \e size pixels whose upper left corner is at \e corner; \e id must be
            unique in the figure. */
        std::string svg(const Eigen::Vector2d &corner, const Eigen::Vector2d &size, const std::string &id) const;

        /** \brief Pixels that the legend takes below the plot. */
        double legendHeight() const;

    private:
        enum class Kind
        {
            Polyline,
            Polygon,
            Segments,
            Circle,
            Markers
        };

        struct Shape
        {
            Kind kind;
            Points points;
            double radius;
            SvgStyle style;
        };

        struct LegendEntry
        {
            std::string label;
            Kind kind;
            SvgStyle style;
        };

        /** \brief Where the plotting area lies, in pixels. */
        struct Frame
        {
            Eigen::Vector2d corner;
            Eigen::Vector2d size;
        };

        void add(Kind kind, Points points, double radius, const SvgStyle &style, const std::string &legend);
        Frame layOut(const Eigen::Vector2d &corner, const Eigen::Vector2d &size) const;
        Eigen::Vector2d toPixels(const Eigen::Vector2d &point, const Frame &frame) const;
        std::string drawShape(const Shape &shape, const Frame &frame) const;
        std::string drawTicks(const Frame &frame) const;
        std::string drawLegend(const Frame &frame) const;

        std::string title_;
        std::string xLabel_;
        std::string yLabel_;
        Eigen::Vector2d lower_;
        Eigen::Vector2d upper_;
        bool equalAspect_{false};
        std::vector<Shape> shapes_;
        std::vector<LegendEntry> legend_;
    };

    /** \brief An SVG file with one or more plots side by side. */
    class SvgFigure
    {
    public:
        /** \brief \e width and \e height of one plot without its legend, in pixels. */
        explicit SvgFigure(double width = 560, double height = 560);

        void addAxes(const SvgAxes &axes);
        std::string svg() const;

        /** \brief Throws InputError if \e file cannot be written. */
        void write(const std::string &file) const;

    private:
        double width_;
        double height_;
        std::vector<SvgAxes> axes_;
    };
}  // namespace ompl_mfa::cli

#endif
