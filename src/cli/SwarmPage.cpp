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

#include "cli/SwarmPage.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "report/EmbeddedTexts.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        using nlohmann::json;

        /* Significant digits of coordinates. */
        constexpr int DIGITS = 5;

        double rounded(double value)
        {
            double result = value;
            text::readNumber(text::numberText(value, DIGITS), result);
            return result;
        }

        /* x1, y1, x2, y2, ... */
        json toJson(const collision::Polygon &points)
        {
            json numbers = json::array();
            for (const Eigen::Vector2d &point : points)
            {
                numbers.push_back(rounded(point.x()));
                numbers.push_back(rounded(point.y()));
            }
            return numbers;
        }

        json toJson(const std::vector<collision::Polygon> &polygons)
        {
            json list = json::array();
            for (const collision::Polygon &polygon : polygons)
            {
                list.push_back(toJson(polygon));
            }
            return list;
        }

        json toJson(const SwarmFrame &frame)
        {
            json paths = json::array();
            json valid = json::array();
            for (const SwarmPath &path : frame.paths)
            {
                paths.push_back(toJson(path.points));
                valid.push_back(path.valid ? 1 : 0);
            }
            json document{{"generation", frame.generation}, {"paths", paths}, {"valid", valid}};
            if (!frame.best.points.empty())
            {
                document["best"] = toJson(frame.best.points);
                document["cost"] = rounded(frame.best.cost);
            }
            return document;
        }

        json toJson(const SwarmRecording &recording)
        {
            json slices = json::array();
            for (const auto &slice : recording.slices)
            {
                slices.push_back(toJson(collision::Polygon{slice.first, slice.second}));
            }
            json frames = json::array();
            for (const SwarmFrame &frame : recording.frames)
            {
                frames.push_back(toJson(frame));
            }
            return {{"planner", recording.planner}, {"slices", slices}, {"frames", frames}};
        }
    }  // namespace

    std::string swarmPage(const PlanarProblem &problem, const std::vector<SwarmRecording> &recordings,
                          const std::string &command)
    {
        json swarms = json::array();
        std::size_t frames = 0;
        std::string figures;
        for (const SwarmRecording &recording : recordings)
        {
            swarms.push_back(toJson(recording));
            frames = std::max(frames, recording.frames.size());
            figures += "<figure><figcaption>" + report::escaped(recording.planner) +
                       "</figcaption><canvas></canvas><p class=\"state\"></p></figure>\n";
        }
        report::WebPage page;
        page.title = "Fireflies on " + problem.name;
        page.body =
            "<header><h1>" + report::escaped(page.title) +
            "</h1></header>\n<main>\n<div class=\"controls\"><button type=\"button\" id=\"play\">Pause</button>"
            "<label>Generation <output id=\"generation\">0</output></label>"
            "<input type=\"range\" id=\"slider\" aria-label=\"generation\" min=\"0\" step=\"any\" value=\"0\" "
            "max=\"" +
            std::to_string(frames - 1) +
            "\"><label>Speed <select id=\"speed\"><option value=\"2\">2 generations per second</option>"
            "<option value=\"5\" selected>5</option><option value=\"10\">10</option>"
            "<option value=\"25\">25</option></select></label></div>\n"
            "<noscript><p>The animation needs scripts.</p></noscript>\n"
            "<div class=\"swarms\">\n" +
            figures +
            "</div>\n<p>Each line is a firefly, that is, a path with a point on each slice (thin lines). Between "
            "generations the lines are interpolated. "
            "<span class=\"key colliding\">Colliding</span> "
            "<span class=\"key valid\">Collision-free</span> "
            "<span class=\"key best\">Best so far</span></p>\n<p>Made by</p><pre>" +
            report::escaped(command) + "</pre>\n</main>";
        page.data = {{"lower", toJson(collision::Polygon{problem.lower})},
                     {"upper", toJson(collision::Polygon{problem.upper})},
                     {"obstacles", toJson(problem.obstacles)},
                     {"start", toJson(problem.start)},
                     {"goal", toJson(problem.goal)},
                     {"swarms", swarms}};
        page.styles = {report::PAGE_STYLE};
        page.scripts = {report::SWARM_SCRIPT};
        return report::htmlOf(page);
    }
}  // namespace ompl_mfa::cli
