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

#include "cli/DrivePage.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <nlohmann/json.hpp>

#include "report/EmbeddedTexts.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        using maps::Cell;
        using maps::CellChange;
        using nlohmann::json;

        /* In cells, to a hundredth. */
        double rounded(double value)
        {
            constexpr double PARTS = 100.0;
            return std::round(value * PARTS) / PARTS;
        }

        /* x1, y1, x2, y2, ... in cells. */
        json toJson(const maps::GridMap &map, const drive::DriveFrame::Line &line)
        {
            json numbers = json::array();
            for (const Eigen::Vector2d &point : line)
            {
                const Eigen::Vector2d place = map.toGrid(point);
                numbers.push_back(rounded(place.x()));
                numbers.push_back(rounded(place.y()));
            }
            return numbers;
        }

        /* Runs of equal cells along rows: the index of the first cell, their number, and what they are. */
        json toJson(const maps::GridMap &map, std::vector<CellChange> changes)
        {
            // of two changes of a cell the later one counts, which follows the other
            std::stable_sort(changes.begin(), changes.end(),
                             [](const CellChange &one, const CellChange &other)
                             { return std::tie(one.y, one.x) < std::tie(other.y, other.x); });
            json runs = json::array();
            std::size_t end = 0;
            for (const CellChange &change : changes)
            {
                const std::size_t index = change.y * map.width() + change.x;
                const int kind = static_cast<int>(change.cell);
                if (!runs.empty() && index == end && runs.back() == kind && change.x > 0)
                {
                    runs[runs.size() - 2] = runs[runs.size() - 2].get<std::size_t>() + 1;
                }
                else
                {
                    runs.push_back(index);
                    runs.push_back(1);
                    runs.push_back(kind);
                }
                end = index + 1;
            }
            return runs;
        }

        std::vector<CellChange> cellsOf(const maps::GridMap &map, bool (*isShown)(Cell))
        {
            std::vector<CellChange> cells;
            for (std::size_t y = 0; y < map.height(); ++y)
            {
                for (std::size_t x = 0; x < map.width(); ++x)
                {
                    if (isShown(map.cell(x, y)))
                    {
                        cells.push_back({x, y, map.cell(x, y)});
                    }
                }
            }
            return cells;
        }

        json toJson(const maps::GridMap &map, const drive::DriveFrame &frame)
        {
            json swarm = json::array();
            for (const auto &line : frame.swarm)
            {
                swarm.push_back(toJson(map, line));
            }
            return {{"news", toJson(map, frame.news)}, {"path", toJson(map, frame.path)}, {"swarm", swarm}};
        }

        /* Indices of poses of the trail that are enough for a picture: about a quarter of a cell apart, with those of
           the frames. */
        std::vector<std::size_t> shownPlaces(const maps::GridMap &map, const drive::DriveResult &result)
        {
            const double spacing = 0.25 * map.frame().resolution;
            std::vector<std::size_t> shown;
            std::size_t frame = 0;
            for (std::size_t i = 0; i < result.trail.size(); ++i)
            {
                bool isFrame = false;
                while (frame < result.frames.size() && result.frames[frame].place <= i)
                {
                    isFrame = true;
                    ++frame;
                }
                if (isFrame || (result.trail[i].position - result.trail[shown.back()].position).norm() >= spacing)
                {
                    shown.push_back(i);
                }
            }
            return shown;
        }

        json framesOf(const maps::GridMap &map, const drive::DriveResult &result,
                      const std::vector<std::size_t> &places)
        {
            json frames = json::array();
            for (std::size_t i = 0; i < result.frames.size(); ++i)
            {
                json frame = toJson(map, result.frames[i]);
                const bool isLast = i >= result.periods.size();
                const drive::Pose &pose = isLast ? result.trail.back() : result.periods[i].pose;
                frame["time"] = rounded(isLast ? result.duration : result.periods[i].time);
                frame["driven"] = rounded(isLast ? result.driven : result.periods[i].driven);
                frame["blocked"] = !isLast && result.periods[i].isBlocked;
                frame["point"] =
                    std::lower_bound(places.begin(), places.end(), result.frames[i].place) - places.begin();
                frame["pose"] = toJson(map, drive::DriveFrame::Line{pose.position});
                frame["pose"].push_back(pose.yaw - map.frame().yaw);
                frames.push_back(frame);
            }
            return frames;
        }

        json outlineOf(const maps::Footprint &footprint, double resolution)
        {
            json outline = json::array();
            for (const Eigen::Vector2d &corner : footprint.outline())
            {
                outline.push_back(rounded(corner.x() / resolution));
                outline.push_back(rounded(corner.y() / resolution));
            }
            return outline;
        }

        std::string bodyOf(const std::string &title, std::size_t frames, const std::string &command)
        {
            return "<header><h1>" + report::escaped(title) +
                   "</h1></header>\n<main>\n<div class=\"controls\"><button type=\"button\" id=\"play\">Pause</button>"
                   "<label>Time <output id=\"time\">0</output> s</label>"
                   "<input type=\"range\" id=\"slider\" aria-label=\"period\" min=\"0\" step=\"1\" value=\"0\" max=\"" +
                   std::to_string(frames - 1) +
                   "\"><label>Speed <select id=\"speed\"><option value=\"1\">real time</option>"
                   "<option value=\"4\" selected>4 times</option><option value=\"16\">16 times</option>"
                   "</select></label><label><input type=\"checkbox\" id=\"swarm\" checked> fireflies</label></div>\n"
                   "<noscript><p>The animation needs scripts.</p></noscript>\n"
                   "<div class=\"drive\"><canvas></canvas><p class=\"state\"></p></div>\n"
                   "<p><span class=\"key unseen\">Not known</span> <span class=\"key free\">Known as free</span> "
                   "<span class=\"key obstacle\">Known as an obstacle</span> "
                   "<span class=\"key hidden\">An obstacle that is not known</span> "
                   "<span class=\"key best\">Path</span> <span class=\"key trail\">Driven</span> "
                   "<span class=\"key valid\">Fireflies</span></p>\n<p>Made by</p><pre>" +
                   report::escaped(command) + "</pre>\n</main>";
        }
    }  // namespace

    std::string drivePage(const benchmark::ProblemFactory &factory, const std::optional<maps::GridMap> &known,
                          const drive::DriveResult &result, const std::string &planner, const std::string &command)
    {
        const maps::GridMap &map = factory.map()->map();
        const benchmark::ProblemConfig &problem = factory.config().problem;
        report::WebPage page;
        page.title = planner + " drives on " + problem.name;
        page.body = bodyOf(page.title, result.frames.size(), command);
        drive::DriveFrame::Line trail;
        const std::vector<std::size_t> places = shownPlaces(map, result);
        for (const std::size_t place : places)
        {
            trail.push_back(result.trail[place].position);
        }
        const auto goal = map.toGrid({problem.goal.x, problem.goal.y});
        page.data = {{"width", map.width()},
                     {"height", map.height()},
                     {"yDown", map.frame().yDown},
                     {"obstacles", toJson(map, cellsOf(map, [](Cell cell) { return cell == Cell::Occupied; }))},
                     {"known", known ? toJson(map, cellsOf(*known, [](Cell cell) { return cell != Cell::Unknown; }))
                                     : json::array()},
                     {"robot", outlineOf(factory.footprint(), map.frame().resolution)},
                     {"goal", {rounded(goal.x()), rounded(goal.y()), problem.goal.theta - map.frame().yaw}},
                     {"status", drive::statusText(result.status)},
                     {"frames", framesOf(map, result, places)}};
        page.data["trail"] = toJson(map, trail);
        page.styles = {report::PAGE_STYLE};
        page.scripts = {report::DRIVE_SCRIPT};
        return report::htmlOf(page);
    }
}  // namespace ompl_mfa::cli
