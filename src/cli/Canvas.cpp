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

#include "cli/Canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <boost/locale/encoding_utf.hpp>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::cli
{
    namespace
    {

        constexpr double IMAGE_SCALE = 2.0;
        constexpr double PI = 3.14159265358979323846;

        using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
        using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

        cairo_status_t append(void *bytes, const unsigned char *data, unsigned int length)
        {
            static_cast<std::string *>(bytes)->append(reinterpret_cast<const char *>(data), length);
            return CAIRO_STATUS_SUCCESS;
        }

        void require(cairo_status_t status)
        {
            if (status != CAIRO_STATUS_SUCCESS)
            {
                throw std::runtime_error(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
            }
        }

        /** \brief A surface that writes its file into \e bytes; an image is written at the end. */
        Surface makeSurface(PictureFormat format, const Eigen::Vector2d &size, std::string &bytes)
        {
            Surface surface(nullptr, &cairo_surface_destroy);
            if (format == PictureFormat::SVG)
            {
                surface.reset(cairo_svg_surface_create_for_stream(&append, &bytes, size.x(), size.y()));
                cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
            }
            else if (format == PictureFormat::PDF)
            {
                surface.reset(cairo_pdf_surface_create_for_stream(&append, &bytes, size.x(), size.y()));
                // Files of the same picture must be identical.
                cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
            }
            else
            {
                const Eigen::Vector2d pixels = (IMAGE_SCALE * size).array().ceil();
                surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(pixels.x()),
                                                         static_cast<int>(pixels.y())));
                cairo_surface_set_device_scale(surface.get(), IMAGE_SCALE, IMAGE_SCALE);
            }
            require(cairo_surface_status(surface.get()));
            return surface;
        }

        /** \brief A context whose text has the same size on every surface. */
        Context makeContext(cairo_surface_t *surface)
        {
            Context context(cairo_create(surface), &cairo_destroy);
            cairo_font_options_t *options = cairo_font_options_create();
            cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
            cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
            cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
            cairo_set_font_options(context.get(), options);
            cairo_font_options_destroy(options);
            cairo_select_font_face(context.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
            return context;
        }

        /** \brief Text that cairo accepts: one invalid character would make the whole picture fail. */
        std::string drawable(const std::string &words)
        {
            auto characters = boost::locale::conv::utf_to_utf<char32_t>(oneLine(words));
            const auto isNoCharacter = [](char32_t c)
            { return (c >= 0xFDD0 && c <= 0xFDEF) || (c & 0xFFFE) == 0xFFFE; };
            characters.erase(std::remove_if(characters.begin(), characters.end(), isNoCharacter), characters.end());
            return boost::locale::conv::utf_to_utf<char>(characters);
        }

        double advance(cairo_t *context, const std::string &words, double size)
        {
            cairo_text_extents_t extents;
            cairo_set_font_size(context, size);
            cairo_text_extents(context, words.c_str(), &extents);
            return extents.x_advance;
        }

        void setColor(cairo_t *context, unsigned int color, double opacity)
        {
            const auto part = [color](unsigned int shift) { return ((color >> shift) & 0xFF) / 255.0; };
            cairo_set_source_rgba(context, part(16), part(8), part(0), opacity);
        }

        /** \brief The points with normal * point >= offset. */
        struct HalfPlane
        {
            double depth(const Eigen::Vector2d &point) const
            {
                return normal.dot(point) - offset;
            }

            Eigen::Vector2d normal;
            double offset;
        };

        /** \brief The sheet with a margin of its own size. Cairo stores coordinates in 32 bits, so an obstacle much
            larger than the picture has to be clipped. */
        std::array<HalfPlane, 4> surroundings(const Eigen::Vector2d &size)
        {
            return {{{{1.0, 0.0}, -size.x()},
                     {{-1.0, 0.0}, -2.0 * size.x()},
                     {{0.0, 1.0}, -size.y()},
                     {{0.0, -1.0}, -2.0 * size.y()}}};
        }

        /** \brief Clips a segment; false if nothing of it is left. */
        bool cut(Eigen::Vector2d &a, Eigen::Vector2d &b, const std::array<HalfPlane, 4> &area)
        {
            for (const auto &half : area)
            {
                const double from = half.depth(a);
                const double to = half.depth(b);
                if (from < 0.0 && to < 0.0)
                {
                    return false;
                }
                if (from < 0.0)
                {
                    a += from / (from - to) * (b - a);
                }
                else if (to < 0.0)
                {
                    b = a + from / (from - to) * (b - a);
                }
            }
            return true;
        }

        /** \brief Clips a polygon (Sutherland and Hodgman). */
        Canvas::Points cut(Canvas::Points corners, const std::array<HalfPlane, 4> &area)
        {
            for (const auto &half : area)
            {
                Canvas::Points kept;
                for (std::size_t i = 0; i < corners.size(); ++i)
                {
                    const Eigen::Vector2d &a = corners[i];
                    const Eigen::Vector2d &b = corners[(i + 1) % corners.size()];
                    const double from = half.depth(a);
                    const double to = half.depth(b);
                    if (from >= 0.0)
                    {
                        kept.push_back(a);
                    }
                    if ((from < 0.0) != (to < 0.0))
                    {
                        kept.emplace_back(a + from / (from - to) * (b - a));
                    }
                }
                corners = std::move(kept);
            }
            return corners;
        }
    }  // namespace

    PictureFormat pictureFormat(const std::string &file)
    {
        const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
        if (extension == ".svg")
        {
            return PictureFormat::SVG;
        }
        if (extension == ".png")
        {
            return PictureFormat::PNG;
        }
        if (extension == ".pdf")
        {
            return PictureFormat::PDF;
        }
        throw InputError("the picture '" + file +
                         "' has no known format; a file that ends in .svg, .png or .pdf is "
                         "accepted");
    }

    double textWidth(const std::string &words, double size)
    {
        const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), &cairo_surface_destroy);
        const Context context = makeContext(surface.get());
        const double width = advance(context.get(), drawable(words), size);
        require(cairo_status(context.get()));
        return width;
    }

    struct Canvas::Sheet
    {
        Sheet(PictureFormat sheetFormat, const Eigen::Vector2d &size)
          : format(sheetFormat)
          , area(surroundings(size))
          , surface(makeSurface(format, size, bytes))
          , context(makeContext(surface.get()))
        {
        }

        PictureFormat format;
        std::array<HalfPlane, 4> area;
        // Outlives the surface, which writes into it until its end.
        std::string bytes;
        Surface surface;
        Context context;
    };

    Canvas::Canvas(PictureFormat format, const Eigen::Vector2d &size)
      : sheet_(std::make_unique<Sheet>(format, size))
    {
        cairo_t *context = sheet_->context.get();
        cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
        cairo_paint(context);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
        // Circles of any size are accurate to a hundredth of a pixel.
        cairo_set_tolerance(context, 0.01);
    }

    Canvas::~Canvas() = default;

    void Canvas::setClip(const Eigen::Vector2d &corner, const Eigen::Vector2d &size)
    {
        cairo_rectangle(sheet_->context.get(), corner.x(), corner.y(), size.x(), size.y());
        cairo_clip(sheet_->context.get());
    }

    void Canvas::clearClip()
    {
        cairo_reset_clip(sheet_->context.get());
    }

    void Canvas::drawLines(const std::vector<Points> &lines, const Style &style)
    {
        cairo_t *context = sheet_->context.get();
        for (const auto &line : lines)
        {
            bool continues = false;
            for (std::size_t i = 1; i < line.size(); ++i)
            {
                Eigen::Vector2d from = line[i - 1];
                Eigen::Vector2d to = line[i];
                if (!cut(from, to, sheet_->area))
                {
                    continues = false;
                    continue;
                }
                if (!continues)
                {
                    cairo_move_to(context, from.x(), from.y());
                }
                cairo_line_to(context, to.x(), to.y());
                continues = to == line[i];
            }
        }
        paint(style);
    }

    void Canvas::drawPolygon(const Points &corners, const Style &style)
    {
        cairo_t *context = sheet_->context.get();
        const Points kept = cut(corners, sheet_->area);
        if (kept.empty())
        {
            return;
        }
        for (const auto &corner : kept)
        {
            cairo_line_to(context, corner.x(), corner.y());
        }
        cairo_close_path(context);
        paint(style);
    }

    void Canvas::drawCircle(const Eigen::Vector2d &center, double radius, const Style &style)
    {
        cairo_t *context = sheet_->context.get();
        cairo_new_sub_path(context);
        cairo_arc(context, center.x(), center.y(), radius, 0.0, 2.0 * PI);
        cairo_close_path(context);
        paint(style);
    }

    void Canvas::drawRaster(const Raster &raster)
    {
        cairo_t *context = sheet_->context.get();
        const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(raster.width),
                                                       static_cast<int>(raster.height)),
                            &cairo_surface_destroy);
        require(cairo_surface_status(image.get()));
        unsigned char *data = cairo_image_surface_get_data(image.get());
        const int stride = cairo_image_surface_get_stride(image.get());
        for (std::size_t row = 0; row < raster.height; ++row)
        {
            std::memcpy(data + row * static_cast<std::size_t>(stride), &raster.colors[row * raster.width],
                        raster.width * sizeof(unsigned int));
        }
        cairo_surface_mark_dirty(image.get());
        const auto &placed = raster.toAxes.matrix();
        const cairo_matrix_t matrix{placed(0, 0), placed(1, 0), placed(0, 1), placed(1, 1), placed(0, 2), placed(1, 2)};
        cairo_save(context);
        cairo_transform(context, &matrix);
        cairo_set_source_surface(context, image.get(), 0.0, 0.0);
        cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
        cairo_paint(context);
        cairo_restore(context);
    }

    void Canvas::drawText(const std::string &words, const Eigen::Vector2d &at, double size, Anchor anchor, bool upwards)
    {
        cairo_t *context = sheet_->context.get();
        const std::string text = drawable(words);
        const double width = advance(context, text, size);
        const double offset = anchor == Anchor::Start ? 0.0 : anchor == Anchor::Middle ? width / 2.0 : width;
        cairo_save(context);
        setColor(context, Style().stroke, 1.0);
        cairo_translate(context, at.x(), at.y());
        if (upwards)
        {
            cairo_rotate(context, -PI / 2.0);
        }
        cairo_move_to(context, -offset, 0.0);
        cairo_show_text(context, text.c_str());
        cairo_restore(context);
        cairo_new_path(context);
    }

    void Canvas::paint(const Style &style)
    {
        cairo_t *context = sheet_->context.get();
        if (style.fill)
        {
            setColor(context, *style.fill, style.opacity);
            cairo_fill_preserve(context);
        }
        setColor(context, style.stroke, style.opacity);
        cairo_set_line_width(context, style.strokeWidth);
        cairo_stroke(context);
    }

    std::string Canvas::finish()
    {
        require(cairo_status(sheet_->context.get()));
        if (sheet_->format == PictureFormat::PNG)
        {
            require(cairo_surface_write_to_png_stream(sheet_->surface.get(), &append, &sheet_->bytes));
        }
        cairo_surface_finish(sheet_->surface.get());
        require(cairo_surface_status(sheet_->surface.get()));
        return std::move(sheet_->bytes);
    }
}  // namespace ompl_mfa::cli
