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

#include "report/WebPage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        bool endsWith(const std::string &text, const std::string &end)
        {
            return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
        }

        /* JSON within a script element: nothing in it can end the element. */
        std::string scriptData(const nlohmann::json &data)
        {
            std::string text;
            for (const char letter : data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
            {
                text += letter == '<' ? "\\u003c" : std::string(1, letter);
            }
            return text;
        }
    }  // namespace

    std::string escaped(const std::string &text)
    {
        std::string safe;
        for (const char letter : text)
        {
            switch (letter)
            {
                case '&':
                    safe += "&amp;";
                    break;
                case '<':
                    safe += "&lt;";
                    break;
                case '>':
                    safe += "&gt;";
                    break;
                case '"':
                    safe += "&quot;";
                    break;
                case '\'':
                    safe += "&#39;";
                    break;
                default:
                    safe += letter;
            }
        }
        return safe;
    }

    std::string significant(double value, int digits)
    {
        if (std::isnan(value))
        {
            return "-";
        }
        if (std::isinf(value))
        {
            return value > 0.0 ? "∞" : "-∞";
        }
        if (value == 0.0)
        {
            return "0";
        }
        const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
        return text::fixedText(value, std::clamp(digits - 1 - magnitude, 0, 17));
    }

    std::string base64(std::string_view bytes)
    {
        const char *const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3)
        {
            const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
            unsigned int group = 0;
            for (std::size_t j = 0; j < 3; ++j)
            {
                group = group << 8U | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
            }
            for (std::size_t j = 0; j < 4; ++j)
            {
                text += j <= count ? letters[group >> (18 - 6 * j) & 63U] : '=';
            }
        }
        return text;
    }

    std::string pictureAddress(const std::string &file, const std::string &origin)
    {
        const bool isSvg = endsWith(file, ".svg");
        if (!isSvg && !endsWith(file, ".png"))
        {
            throw InputError(origin + ": the file name of a picture has to end with .svg or .png");
        }
        std::ifstream in(file, std::ios::binary);
        const std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
        if (!in.is_open() || content.empty())
        {
            throw InputError(origin + ": cannot be read, or is empty");
        }
        if (isSvg ? content.find("<svg") == std::string::npos : content.compare(1, 3, "PNG") != 0)
        {
            throw InputError(origin + ": is not the picture that its name says");
        }
        return std::string("data:image/") + (isSvg ? "svg+xml" : "png") + ";base64," + base64(content);
    }

    LineLook lineLook(std::size_t index)
    {
        const std::array<const char *, 7> colours{"#0072b2", "#d55e00", "#009e73", "#b5478a",
                                                  "#000000", "#56b4e9", "#c98600"};
        const std::array<std::vector<int>, 4> patterns{{{}, {7, 4}, {2, 3}, {9, 3, 2, 3}}};
        return {colours[index % colours.size()], patterns[index / colours.size() % patterns.size()]};
    }

    std::string htmlOf(const WebPage &page)
    {
        std::string html =
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
            "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
            escaped(page.title) + "</title>\n";
        for (const std::string_view style : page.styles)
        {
            html += "<style>\n" + std::string(style) + "\n</style>\n";
        }
        html +=
            "</head>\n<body>\n" + page.body + "\n<script>const pageData = " + scriptData(page.data) + ";</script>\n";
        for (const std::string_view script : page.scripts)
        {
            html += "<script>\n" + std::string(script) + "\n</script>\n";
        }
        return html + "</body>\n</html>\n";
    }

    void writeText(const std::string &file, const std::string &content, const std::string &origin)
    {
        std::ofstream out(file, std::ios::binary);
        out << content;
        out.close();
        if (!out)
        {
            throw InputError(origin + ": cannot be written");
        }
    }
}  // namespace ompl_mfa::report
