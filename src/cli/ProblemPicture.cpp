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

#include "cli/ProblemPicture.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "benchmark/ProblemSpace.h"
#include "cli/Figure.h"
#include "cli/MapPicture.h"
#include "ompl_mfa/collision/PlanarOutline.h"
#include "ompl_mfa/collision/StatePlacement.h"

namespace ompl_mfa::cli
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        constexpr unsigned int ROBOT_POSES = 14;
        const Style OBSTACLE{0x5b6670, 0.6, 0xaeb8c0, 1.0};
        const Style OBSTACLE_SEEN_THROUGH{0x5b6670, 0.5, 0xaeb8c0, 0.35};
        const Style SLICE{0x9db8d2, 0.7, std::nullopt, 0.9};
        const Style SWARM{0xe39a3b, 0.8, std::nullopt, 0.3};
        const Style ROBOT{0x1f5fa8, 0.7, 0x4f8fd0, 0.22};
        const Style BEST{0x0b3c78, 2.4, std::nullopt, 1.0};
        const Style START{0x12632b, 1.4, 0x49b266, 0.55};
        const Style GOAL{0x8c1d18, 1.4, 0xe0605a, 0.55};

        /* A viewing direction: the world is rotated so that the picture lies in x and y. */
        struct View
        {
            fcl::Transform3d turned;
            double zMin;
            double zMax;
            unsigned int horizontal;
            unsigned int vertical;
            bool seenThrough;
        };

        View planarView(const benchmark::ProblemFactory &problem)
        {
            const fcl::AABBd box = problem.robot().bounds();
            return {fcl::Transform3d::Identity(), box.min_[2], box.max_[2], 0, 1, false};
        }

        View spatialView(unsigned int vertical)
        {
            constexpr double FAR = std::numeric_limits<double>::max();
            View view{fcl::Transform3d::Identity(), -FAR, FAR, 0, vertical, true};
            if (vertical == 2)
            {
                view.turned.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
            }
            return view;
        }

        /* Draws one view; coordinates are those of the rotated world. */
        class ViewPainter
        {
        public:
            ViewPainter(const benchmark::ProblemFactory &problem, const og::SimpleSetup &setup, const View &view,
                        const std::string &title)
              : problem_(problem)
              , setup_(setup)
              , placement_(setup.getStateSpace())
              , view_(view)
              , axes_(makeAxes(title))
            {
            }

            const Axes &paint(const PictureContent &content)
            {
                if (problem_.map() != nullptr)
                {
                    addMap(axes_, *problem_.map(), problem_.footprint());
                }
                for (const auto &object : problem_.world().objects())
                {
                    addOutlines(object, view_.turned, view_.seenThrough ? OBSTACLE_SEEN_THROUGH : OBSTACLE,
                                "obstacles");
                }
                addSlices(content.slices);
                for (const auto &path : content.swarm)
                {
                    axes_.addPolyline(positions(path), SWARM,
                                      &path == &content.swarm.front() ? "the swarm's paths" : "");
                }
                for (const auto &path : content.best)
                {
                    addBest(path);
                }
                addRobot(setup_.getProblemDefinition()->getStartState(0), START, "start");
                addGoal();
                return axes_;
            }

        private:
            /* The unit of the world is unknown, but for maps. */
            std::string axisLabel(unsigned int axis) const
            {
                const maps::ObstacleGrid *map = problem_.map();
                const std::string unit = map == nullptr ? "world units" : map->map().frame().yDown ? "cells" : "m";
                return std::string(1, "xyz"[axis]) + " (" + unit + ")";
            }

            Axes makeAxes(const std::string &title) const
            {
                const ob::RealVectorBounds bounds = positionBounds(*setup_.getStateSpace());
                Eigen::Vector2d lower(bounds.low[view_.horizontal], bounds.low[view_.vertical]);
                Eigen::Vector2d upper(bounds.high[view_.horizontal], bounds.high[view_.vertical]);
                if (problem_.map() != nullptr && !problem_.config().problem.volume)
                {
                    const Eigen::AlignedBox2d known = knownBox(problem_.map()->map());
                    lower = known.min();
                    upper = known.max();
                }
                Axes axes(title, axisLabel(view_.horizontal), axisLabel(view_.vertical), lower, upper);
                if (problem_.map() != nullptr && problem_.map()->map().frame().yDown)
                {
                    axes.turnYDown();
                }
                return axes;
            }

            fcl::Transform3d pose(const ob::State *state) const
            {
                fcl::Transform3d placed;
                placement_.place(state, 0, placed);
                return view_.turned * placed;
            }

            Axes::Points positions(og::PathGeometric path) const
            {
                if (!placement_.interpolatesStraight())
                {
                    path.interpolate();
                }
                Axes::Points points;
                for (const auto *state : path.getStates())
                {
                    points.emplace_back(pose(state).translation().head<2>());
                }
                return points;
            }

            /* Only the first shape drawn gets a legend entry. */
            void addOutlines(collision::CollisionObject object, const fcl::Transform3d &turned, const Style &style,
                             const std::string &legend)
            {
                object.pose = turned * object.pose;
                for (const auto &polygon : collision::planarOutline(object, view_.zMin, view_.zMax))
                {
                    axes_.addPolygon(polygon, style, isInLegend(legend) ? "" : legend);
                }
            }

            bool isInLegend(const std::string &words) const
            {
                return std::any_of(axes_.legend().begin(), axes_.legend().end(),
                                   [&words](const auto &entry) { return entry.words == words; });
            }

            void addRobotOutlines(const fcl::Transform3d &placed, const Style &style, const std::string &legend)
            {
                if (problem_.map() != nullptr)
                {
                    addFootprint(placed, style, legend);
                    return;
                }
                for (const auto &shape : problem_.robot().shapes())
                {
                    addOutlines({"robot", shape.geometry, shape.pose}, placed, style, legend);
                }
            }

            void addFootprint(const fcl::Transform3d &placed, const Style &style, const std::string &legend)
            {
                Axes::Points outline;
                for (const Eigen::Vector2d &corner : problem_.footprint().outline())
                {
                    outline.emplace_back((placed * fcl::Vector3d(corner.x(), corner.y(), 0.0)).head<2>());
                }
                if (outline.size() > 1)
                {
                    axes_.addPolygon(outline, style, isInLegend(legend) ? "" : legend);
                }
            }

            void addRobot(const ob::State *state, const Style &style, const std::string &legend)
            {
                const fcl::Transform3d placed = pose(state);
                addRobotOutlines(placed, style, legend);
                axes_.addMarkers({placed.translation().head<2>()}, 3.0, {style.stroke, 1.0, style.stroke, 1.0},
                                 isInLegend(legend) ? "" : legend);
            }

            void addGoal()
            {
                const auto *goal = dynamic_cast<const ob::GoalState *>(setup_.getGoal().get());
                if (goal)
                {
                    addRobot(goal->getState(), GOAL, "goal");
                }
            }

            void addSlices(const std::vector<og::PathGeometric> &slices)
            {
                Axes::Segments segments;
                for (const auto &slice : slices)
                {
                    const Eigen::Vector2d from = pose(slice.getState(0)).translation().head<2>();
                    const Eigen::Vector2d to = pose(slice.getState(1)).translation().head<2>();
                    if (!from.isApprox(to))
                    {
                        segments.emplace_back(from, to);
                    }
                }
                if (!segments.empty())
                {
                    axes_.addSegments(segments, SLICE, "slices");
                }
            }

            void addBest(const og::PathGeometric &path)
            {
                og::PathGeometric spaced = path;
                spaced.interpolate(static_cast<unsigned int>(path.getStateCount()) * ROBOT_POSES);
                const std::size_t step = std::max<std::size_t>(1, spaced.getStateCount() / ROBOT_POSES);
                for (std::size_t i = step; i + step <= spaced.getStateCount(); i += step)
                {
                    const fcl::Transform3d placed = pose(spaced.getState(static_cast<unsigned int>(i)));
                    addRobotOutlines(placed, ROBOT, "robot");
                }
                axes_.addPolyline(positions(path), BEST, "best path");
            }

            const benchmark::ProblemFactory &problem_;
            const og::SimpleSetup &setup_;
            collision::StatePlacement placement_;
            View view_;
            Axes axes_;
        };
    }  // namespace

    ob::RealVectorBounds positionBounds(const ob::StateSpace &space)
    {
        if (const auto *planar = dynamic_cast<const ob::SE2StateSpace *>(&space))
        {
            return planar->getBounds();
        }
        if (const auto *spatial = dynamic_cast<const ob::SE3StateSpace *>(&space))
        {
            return spatial->getBounds();
        }
        return space.as<ob::RealVectorStateSpace>()->getBounds();
    }

    void drawProblem(const benchmark::ProblemFactory &problem, const og::SimpleSetup &setup,
                     const PictureContent &content, const std::string &file)
    {
        Figure figure;
        if (benchmark::positionDimension(problem.config().problem.space) == 2)
        {
            figure.addAxes(ViewPainter(problem, setup, planarView(problem), content.title).paint(content));
        }
        else
        {
            figure.addAxes(ViewPainter(problem, setup, spatialView(1), content.title + ", from above").paint(content));
            figure.addAxes(
                ViewPainter(problem, setup, spatialView(2), content.title + ", from the side").paint(content));
        }
        figure.write(file);
    }
}  // namespace ompl_mfa::cli
