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

#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/SwarmPage.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /* Lengths in pixels, times in seconds. */
        constexpr double PANEL = 400.0;
        constexpr double GAP = 20.0;
        constexpr double HEAD = 52.0;
        constexpr std::size_t KEY_FRAMES = 24;
        constexpr double PLAYING = 9.0;
        constexpr double RESTING = 3.0;

        const char *const COLLIDING = "#d55e00";
        const char *const VALID = "#0072b2";

        std::string pixels(double value)
        {
            const std::string text = text::fixedText(value, 1);
            return text.compare(text.size() - 2, 2, ".0") == 0 ? text.substr(0, text.size() - 2) : text;
        }

        /* One recording, at its place in the picture. */
        class Panel
        {
        public:
            Panel(const PlanarProblem &problem, const SwarmRecording &recording, double left)
              : problem_(problem)
              , recording_(recording)
              , left_(left)
              , scale_(PANEL / (problem.upper.x() - problem.lower.x()))
              , height_(scale_ * (problem.upper.y() - problem.lower.y()))
            {
                chooseKeyFrames();
            }

            double bottom() const
            {
                return HEAD + height_;
            }

            std::string svg(std::size_t fireflies) const
            {
                return "<text class=\"title\" x=\"" + pixels(left_) + "\" y=\"20\">" +
                       report::escaped(recording_.planner) + "</text>\n" + captions() + "<svg x=\"" + pixels(left_) +
                       "\" y=\"" + pixels(HEAD) + "\" width=\"" + pixels(PANEL) + "\" height=\"" + pixels(height_) +
                       "\">\n" + world() + swarm(fireflies) + best() + "</svg>\n<rect class=\"frame\" x=\"" +
                       pixels(left_) + "\" y=\"" + pixels(HEAD) + "\" width=\"" + pixels(PANEL) + "\" height=\"" +
                       pixels(height_) + "\"/>\n";
            }

        private:
            /* The swarm moves most in its first generations: their frames are closer. */
            void chooseKeyFrames()
            {
                const std::size_t last = recording_.frames.size() - 1;
                for (std::size_t i = 0; i <= KEY_FRAMES; ++i)
                {
                    const double part = static_cast<double>(i) / KEY_FRAMES;
                    const auto frame = static_cast<std::size_t>(std::lround(std::pow(part, 1.7) * double(last)));
                    if (frames_.empty() || frames_.back() != frame)
                    {
                        frames_.push_back(frame);
                    }
                }
            }

            const SwarmFrame &frame(std::size_t key) const
            {
                return recording_.frames[frames_[key]];
            }

            std::string points(const collision::Polygon &polygon) const
            {
                std::string text;
                for (const Eigen::Vector2d &point : polygon)
                {
                    text += (text.empty() ? "" : " ") + pixels(scale_ * (point.x() - problem_.lower.x())) + "," +
                            pixels(height_ - scale_ * (point.y() - problem_.lower.y()));
                }
                return text;
            }

            std::string polygons(const std::vector<collision::Polygon> &outlines, const std::string &style) const
            {
                std::string svg = "<g class=\"" + style + "\">";
                for (const collision::Polygon &outline : outlines)
                {
                    svg += "<polygon points=\"" + points(outline) + "\"/>";
                }
                return svg + "</g>\n";
            }

            std::string world() const
            {
                std::string svg = polygons(problem_.obstacles, "obstacles") + "<g class=\"slices\">";
                for (const auto &slice : recording_.slices)
                {
                    svg += "<polyline points=\"" + points({slice.first, slice.second}) + "\"/>";
                }
                return svg + "</g>\n" + polygons(problem_.start, "start") + polygons(problem_.goal, "goal");
            }

            /* An animation of \e attribute with a value per key frame; the last one stays until it starts again. */
            std::string animation(const std::string &attribute, bool discrete,
                                  const std::function<std::string(const SwarmFrame &)> &value) const
            {
                std::string values;
                std::string times;
                for (std::size_t key = 0; key < frames_.size(); ++key)
                {
                    const double part =
                        static_cast<double>(key) / std::max<double>(1.0, static_cast<double>(frames_.size()) - 1.0);
                    values += value(frame(key)) + ";";
                    times += text::numberText(part * PLAYING / (PLAYING + RESTING), 4) + ";";
                }
                // discrete values are complete; interpolated ones need one at the end
                if (!discrete)
                {
                    values += value(frame(frames_.size() - 1)) + ";";
                    times += "1;";
                }
                values.pop_back();
                times.pop_back();
                return "<animate attributeName=\"" + attribute + "\" dur=\"" + pixels(PLAYING + RESTING) +
                       "s\" repeatCount=\"indefinite\" calcMode=\"" + (discrete ? "discrete" : "linear") +
                       "\" keyTimes=\"" + times + "\" values=\"" + values + "\"/>";
            }

            std::string captions() const
            {
                std::string svg;
                for (std::size_t key = 0; key < frames_.size(); ++key)
                {
                    const SwarmFrame &shown = frame(key);
                    const auto valid = std::count_if(shown.paths.begin(), shown.paths.end(),
                                                     [](const SwarmPath &path) { return path.valid; });
                    const std::string words =
                        "generation " + std::to_string(shown.generation) + ": " + std::to_string(valid) + " of " +
                        std::to_string(shown.paths.size()) + " free, best " +
                        (shown.best.points.empty() ? "-" : report::significant(shown.best.cost, 4));
                    svg += "<text x=\"" + pixels(left_) + "\" y=\"42\" visibility=\"" +
                           (key + 1 == frames_.size() ? "visible" : "hidden") + "\">" + words +
                           animation("visibility", true,
                                     [&shown](const SwarmFrame &other)
                                     { return other.generation == shown.generation ? "visible" : "hidden"; }) +
                           "</text>\n";
                }
                return svg;
            }

            /* Whether a path at place \e place can be followed through all key frames. */
            bool isFollowed(std::size_t place) const
            {
                for (std::size_t key = 0; key < frames_.size(); ++key)
                {
                    if (frame(key).paths.size() <= place ||
                        frame(key).paths[place].points.size() != frame(0).paths[place].points.size())
                    {
                        return false;
                    }
                }
                return true;
            }

            std::string swarm(std::size_t fireflies) const
            {
                const std::size_t count = frame(0).paths.size();
                const std::size_t shown = std::min(count, fireflies);
                std::string svg = "<g class=\"swarm\">\n";
                for (std::size_t i = 0; i < shown; ++i)
                {
                    const std::size_t place = i * count / shown;
                    if (!isFollowed(place))
                    {
                        continue;
                    }
                    const auto colour = [place](const SwarmFrame &moved)
                    { return moved.paths[place].valid ? VALID : COLLIDING; };
                    const auto line = [this, place](const SwarmFrame &moved)
                    { return points(moved.paths[place].points); };
                    const SwarmFrame &last = frame(frames_.size() - 1);
                    svg += "<polyline points=\"" + line(last) + "\" stroke=\"" + colour(last) + "\">" +
                           animation("points", false, line) + animation("stroke", true, colour) + "</polyline>\n";
                }
                return svg + "</g>\n";
            }

            std::string best() const
            {
                const SwarmFrame &last = frame(frames_.size() - 1);
                if (last.best.points.empty())
                {
                    return "";
                }
                const auto line = [&](const SwarmFrame &shown)
                { return points(shown.best.points.empty() ? last.best.points : shown.best.points); };
                const auto opacity = [](const SwarmFrame &shown) { return shown.best.points.empty() ? "0" : "1"; };
                return "<polyline class=\"best\" points=\"" + line(last) + "\">" + animation("points", true, line) +
                       animation("opacity", true, opacity) + "</polyline>\n";
            }

            const PlanarProblem &problem_;
            const SwarmRecording &recording_;
            double left_;
            double scale_;
            double height_;
            std::vector<std::size_t> frames_;
        };

        std::string legend(double bottom)
        {
            const std::string y = pixels(bottom + 22);
            std::string svg;
            double x = 0.0;
            for (const auto &[colour, words] : {std::pair<const char *, const char *>{COLLIDING, "colliding path"},
                                                {VALID, "collision-free path"},
                                                {"#000000", "best so far"}})
            {
                svg += "<rect x=\"" + pixels(x) + "\" y=\"" + pixels(bottom + 16) +
                       "\" width=\"24\" height=\"4\" fill=\"" + colour + "\"/><text x=\"" + pixels(x + 30) + "\" y=\"" +
                       y + "\">" + words + "</text>\n";
                x += 190.0;
            }
            return svg;
        }
    }  // namespace

    std::string swarmPicture(const PlanarProblem &problem, const std::vector<SwarmRecording> &recordings)
    {
        std::vector<Panel> panels;
        std::size_t fireflies = 1;
        for (const SwarmRecording &recording : recordings)
        {
            panels.emplace_back(problem, recording, static_cast<double>(panels.size()) * (PANEL + GAP));
            fireflies = std::max(fireflies, recording.frames.front().paths.size());
        }
        const double width = static_cast<double>(panels.size()) * (PANEL + GAP) - GAP;
        const double bottom = panels.front().bottom();
        for (;; fireflies /= 2)
        {
            std::string svg =
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-8 0 " + pixels(width + 16) + " " +
                pixels(bottom + 34) +
                "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"14\" "
                "fill=\"#1a1a1a\">\n<style>polyline { fill: none; } .title { font-size: 16px; "
                "font-weight: bold; } .obstacles { fill: #aeb8c0; stroke: #5b6670; stroke-width: 0.6; } "
                ".slices { stroke: #9db8d2; stroke-width: 0.7; } .swarm { stroke-width: 1; opacity: 0.6; } "
                ".best { stroke: #000000; stroke-width: 2.6; } .start { fill: #49b266; stroke: #12632b; } "
                ".goal { fill: #e0605a; stroke: #8c1d18; } .frame { fill: none; stroke: #5b6670; }</style>\n"
                "<rect x=\"-8\" width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
            for (const Panel &panel : panels)
            {
                svg += panel.svg(fireflies);
            }
            svg += legend(bottom) + "</svg>\n";
            if (svg.size() <= LARGEST_PICTURE || fireflies <= 1)
            {
                return svg;
            }
        }
    }
}  // namespace ompl_mfa::cli
