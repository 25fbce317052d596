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

#ifndef OMPL_MFA_CLI_CANVAS_
#define OMPL_MFA_CLI_CANVAS_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ompl_mfa::cli
{
    enum class PictureFormat
    {
        SVG,
        PNG,
        PDF
    };

    /** \brief The format given by the extension of \e file: `.svg`, `.png` or `.pdf`, in upper or lower case. Throws
        InputError for any other. */
    PictureFormat pictureFormat(const std::string &file);

    /** \brief How a shape is drawn: colours as 0xRRGGBB, the width in pixels, the opacity from 0 to 1. */
    struct Style
    {
        unsigned int stroke{0x222222};
        double strokeWidth{1.0};
        std::optional<unsigned int> fill;
        double opacity{1.0};
    };

    /** \brief Squares of one colour each, 0xRRGGBB, in rows along x: square (i, j) is that from (i, j) to (i + 1, j +
       1) in its own coordinates. */
    struct Raster
    {
        std::size_t width{0};
        std::size_t height{0};
        std::vector<unsigned int> colors;
        /** \brief From its own coordinates to those of what it is drawn on. */
        Eigen::Affine2d toAxes{Eigen::Affine2d::Identity()};
    };

    /** \brief Which point of a text lies at its position. */
    enum class Anchor
    {
        Start,
        Middle,
        End
    };

    /** \brief Width in pixels of \e words in a font of \e size pixels, the same in every format. */
    double textWidth(const std::string &words, double size);

    /** \brief A white sheet to draw on, with x to the right and y downwards, in pixels. They are points in a PDF; an
        image has two of its own pixels for each. */
    class Canvas
    {
    public:
        using Points = std::vector<Eigen::Vector2d>;

        Canvas(PictureFormat format, const Eigen::Vector2d &size);
        ~Canvas();

        Canvas(const Canvas &) = delete;
        Canvas &operator=(const Canvas &) = delete;

        /** \brief Clips drawing to this rectangle until clearClip(). */
        void setClip(const Eigen::Vector2d &corner, const Eigen::Vector2d &size);
        void clearClip();

        /** \brief Draws open polylines as one shape, so that the opacity does not add up where they cross. */
        void drawLines(const std::vector<Points> &lines, const Style &style);
        void drawPolygon(const Points &corners, const Style &style);
        void drawCircle(const Eigen::Vector2d &center, double radius, const Style &style);

        /** \brief Draws \e raster where its toAxes, in pixels, says. */
        void drawRaster(const Raster &raster);

        /** \brief Draws one line of text with its baseline at \e at, rotated to run from bottom to top if \e upwards.
            Invalid UTF-8 is left out. */
        void drawText(const std::string &words, const Eigen::Vector2d &at, double size, Anchor anchor,
                      bool upwards = false);

        /** \brief The content of the file. Nothing can be drawn afterwards. Throws std::runtime_error if cairo
            failed. */
        std::string finish();

    private:
        struct Sheet;

        void paint(const Style &style);

        std::unique_ptr<Sheet> sheet_;
    };
}  // namespace ompl_mfa::cli

#endif
