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

#include "report/Diagrams.h"

#include <algorithm>

#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double LEFT = 165.0;
        constexpr double WIDTH = 300.0;
        constexpr double LINE = 20.0;
        constexpr double AXIS = 54.0;

        std::string number(double value)
        {
            return text::fixedText(value, 1);
        }

        std::string line(double x1, double y1, double x2, double y2, double width)
        {
            return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
                   number(y2) + "\" stroke=\"#1a1a1a\" stroke-width=\"" + number(width) + "\"/>\n";
        }

        std::string label(double x, double y, const std::string &anchor, const std::string &words)
        {
            return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
                   escaped(words) + "</text>\n";
        }

        double placeOf(double rank, std::size_t planners)
        {
            return LEFT + WIDTH * (rank - 1.0) / (static_cast<double>(planners) - 1.0);
        }

        std::string axis(const Ranking &ranking, std::size_t planners)
        {
            std::string svg = line(LEFT, AXIS, LEFT + WIDTH, AXIS, 1.2);
            for (std::size_t rank = 1; rank <= planners; ++rank)
            {
                const double x = placeOf(static_cast<double>(rank), planners);
                svg += line(x, AXIS - 5, x, AXIS, 1.2) + label(x, AXIS - 9, "middle", std::to_string(rank));
            }
            const double end = std::min(1.0 + ranking.criticalDifference, static_cast<double>(planners));
            svg += line(LEFT, 22, placeOf(end, planners), 22, 2.0) + line(LEFT, 18, LEFT, 26, 1.2) +
                   label(LEFT, 13, "start", "critical difference " + significant(ranking.criticalDifference, 3));
            // a difference longer than the axis has no end
            return svg + (1.0 + ranking.criticalDifference <= static_cast<double>(planners)
                              ? line(placeOf(end, planners), 18, placeOf(end, planners), 26, 1.2)
                              : "");
        }
    }  // namespace

    std::vector<std::pair<std::size_t, std::size_t>> indifferentGroups(const std::vector<double> &ranks,
                                                                       double difference)
    {
        std::vector<std::pair<std::size_t, std::size_t>> groups;
        for (std::size_t first = 0; first < ranks.size(); ++first)
        {
            std::size_t last = first;
            while (last + 1 < ranks.size() && ranks[last + 1] - ranks[first] <= difference)
            {
                ++last;
            }
            if (last > first && (groups.empty() || last > groups.back().second))
            {
                groups.emplace_back(first, last);
            }
        }
        return groups;
    }

    std::string rankDiagram(const Comparison &comparison, const Ranking &ranking)
    {
        const std::size_t count = ranking.order.size();
        std::vector<double> ranks;
        for (const std::size_t planner : ranking.order)
        {
            ranks.push_back(ranking.test.meanRanks[planner]);
        }
        const auto groups = indifferentGroups(ranks, ranking.criticalDifference);
        const double below = AXIS + 10 + 7 * static_cast<double>(groups.size());
        std::string svg = axis(ranking, count);
        const std::size_t left = (count + 1) / 2;
        for (std::size_t i = 0; i < count; ++i)
        {
            // the better half is labelled on the left, the other one on the right
            const bool isLeft = i < left;
            const double y = below + LINE * static_cast<double>(isLeft ? i + 1 : count - i);
            const double x = placeOf(ranks[i], count);
            const double side = isLeft ? LEFT - 10 : LEFT + WIDTH + 10;
            const std::string words = comparison.planners[ranking.order[i]] + " (" + significant(ranks[i], 3) + ")";
            svg += line(x, AXIS, x, y, 1.0) + line(x, y, side, y, 1.0) +
                   label(side + (isLeft ? -4 : 4), y + 4, isLeft ? "end" : "start", words);
        }
        for (std::size_t i = 0; i < groups.size(); ++i)
        {
            const double y = AXIS + 9 + 7 * static_cast<double>(i);
            svg += line(placeOf(ranks[groups[i].first], count) - 3, y, placeOf(ranks[groups[i].second], count) + 3, y,
                        4.0);
        }
        const double height = below + LINE * static_cast<double>(left) + 14;
        return "<svg class=\"ranks\" viewBox=\"0 0 " + number(2 * LEFT + WIDTH) + " " + number(height) +
               "\" role=\"img\" aria-label=\"Mean ranks by " + escaped(ranking.measure) + "\">\n" + svg + "</svg>\n";
    }
}  // namespace ompl_mfa::report
