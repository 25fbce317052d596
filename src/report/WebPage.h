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

#ifndef OMPL_MFA_REPORT_WEB_PAGE_
#define OMPL_MFA_REPORT_WEB_PAGE_

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace ompl_mfa::report
{
    /** \brief \e text with the characters escaped that have a meaning in HTML and SVG; invalid UTF-8 is kept. */
    std::string escaped(const std::string &text);

    /** \brief \e value with \e digits significant digits, without an exponent; "∞" for infinity, "-" for NaN. */
    std::string significant(double value, int digits);

    /** \brief \e bytes in base64. */
    std::string base64(std::string_view bytes);

    /** \brief The picture in \e file, .svg or .png, as a `data:` address for an `img` element. Throws InputError,
        beginning with \e origin, for another extension, for content of another kind, and if it cannot be read. */
    std::string pictureAddress(const std::string &file, const std::string &origin);

    /** \brief Colour-blind-safe colours that are legible on white (Okabe and Ito, without yellow), and line patterns.
        Colours repeat after seven entries, with another pattern. */
    struct LineLook
    {
        std::string colour;        ///< "#rrggbb"
        std::vector<int> pattern;  ///< lengths of dashes and gaps in pixels; empty for a solid line
    };

    LineLook lineLook(std::size_t index);

    /** \brief A page that needs no other file and no network. */
    struct WebPage
    {
        std::string title;
        std::string body;  ///< HTML
        /** \brief For the scripts, in `pageData`. */
        nlohmann::json data;
        std::vector<std::string_view> styles;
        std::vector<std::string_view> scripts;
    };

    /** \brief The HTML of \e page. Its content policy forbids it to load anything. */
    std::string htmlOf(const WebPage &page);

    /** \brief Writes \e content to \e file, which is replaced. Throws InputError, beginning with \e origin, if that is
        impossible. */
    void writeText(const std::string &file, const std::string &content, const std::string &origin);
}  // namespace ompl_mfa::report

#endif
