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

#include "oracle/ShortestPath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace ompl_mfa::oracle
{
    namespace
    {
        constexpr double CONTACT = 1e-8;
        constexpr double TWO_PI = 2.0 * M_PI;
        constexpr double ARC_PIECE = 0.02;

        double cross(const Point &a, const Point &b)
        {
            return a.x() * b.y() - a.y() * b.x();
        }

        double wrap(double angle)
        {
            const double wrapped = std::fmod(angle, TWO_PI);
            return wrapped < 0.0 ? wrapped + TWO_PI : wrapped;
        }

        double distance(const Point &p, const Point &a, const Point &b)
        {
            const Point ab = b - a;
            const double squared = ab.squaredNorm();
            const double t = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
            return (p - a - t * ab).norm();
        }

        bool properlyIntersect(const Point &a, const Point &b, const Point &c, const Point &d)
        {
            return (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0) &&
                   (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
        }

        double distance(const Point &a, const Point &b, const Point &c, const Point &d)
        {
            if (properlyIntersect(a, b, c, d))
            {
                return 0.0;
            }
            return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
        }

        /** \brief An obstacle grown by the robot, which the robot's centre may touch but not enter. */
        struct Grown
        {
            Points vertices;
            double radius;
            /* The centre is inside when it is closer than reach to the core. The core of a polygon is the polygon,
               shrunk by more than the contact tolerance, so that touching and crossing differ even at radius 0. */
            Points core;
            double reach;

            bool contains(const Point &p) const
            {
                const bool inPolygon = core.size() > 2 && everyEdge([&](const Point &a, const Point &b)
                                                                    { return cross(b - a, p - a) > 0.0; });
                return inPolygon ||
                       !everyEdge([&](const Point &a, const Point &b) { return distance(p, a, b) >= reach; });
            }

            bool meets(const Point &p, const Point &q) const
            {
                return contains(p) || contains(q) ||
                       !everyEdge([&](const Point &a, const Point &b) { return distance(p, q, a, b) >= reach; });
            }

            template <typename Predicate>
            bool everyEdge(const Predicate &predicate) const
            {
                for (std::size_t i = 0; i < core.size(); ++i)
                {
                    if (!predicate(core[i], core[(i + 1) % core.size()]))
                    {
                        return false;
                    }
                }
                return true;
            }
        };

        void requireConvex(const Obstacle &obstacle)
        {
            const Points &v = obstacle.vertices;
            const std::size_t n = v.size();
            bool convex = obstacle.radius >= 0.0 && (n >= 3 || (n == 1 && obstacle.radius > 0.0));
            double turned = 0.0;
            for (std::size_t i = 0; convex && n >= 3 && i < n; ++i)
            {
                const Point in = v[(i + 1) % n] - v[i];
                const Point out = v[(i + 2) % n] - v[(i + 1) % n];
                convex = cross(in, out) > 0.0;
                turned += std::atan2(cross(in, out), in.dot(out));
            }
            if (!convex || turned > TWO_PI + 1.0)
            {
                throw std::invalid_argument("obstacle: neither a disc nor a convex counter-clockwise polygon");
            }
        }

        Grown grow(const Obstacle &obstacle, double robotRadius)
        {
            requireConvex(obstacle);
            Grown grown{obstacle.vertices, obstacle.radius + robotRadius, obstacle.vertices, 0.0};
            if (obstacle.vertices.size() == 1)
            {
                grown.reach = grown.radius - CONTACT;
                return grown;
            }
            Point middle = Point::Zero();
            for (const Point &vertex : grown.vertices)
            {
                middle += vertex / static_cast<double>(grown.vertices.size());
            }
            double inner = std::numeric_limits<double>::infinity();
            grown.everyEdge(
                [&](const Point &a, const Point &b)
                {
                    inner = std::min(inner, distance(middle, a, b));
                    return true;
                });
            for (Point &vertex : grown.core)
            {
                vertex += (middle - vertex) * (2.0 * CONTACT / inner);
            }
            grown.reach = grown.radius + CONTACT;
            return grown;
        }

        /** \brief An arc's circle: a disc, or a vertex of a polygon; start and goal are circles of radius 0. */
        struct Circle
        {
            Point centre;
            double radius;
        };

        struct Edge
        {
            std::size_t to;
            double length;
            /* Signed angle about the circle of both ends; 0 for a straight segment. */
            double sweep;
        };

        struct Node
        {
            std::size_t circle;
            double angle;
            Point position;
            std::vector<Edge> edges;
        };

        class TangentGraph
        {
        public:
            TangentGraph(const Scene &scene, const Point &start, const Point &goal)
              : lower_(scene.lower.array() - CONTACT)
              , upper_(scene.upper.array() + CONTACT)
            {
                if (!(scene.robotRadius >= 0.0))
                {
                    throw std::invalid_argument("robotRadius: must not be negative");
                }
                for (const Obstacle &obstacle : scene.obstacles)
                {
                    obstacles_.push_back(grow(obstacle, scene.robotRadius));
                }
                if (!isFree(start) || !isFree(goal))
                {
                    throw std::invalid_argument("start or goal: out of bounds or in collision");
                }

                circles_.push_back({start, 0.0});
                circles_.push_back({goal, 0.0});
                for (const Grown &obstacle : obstacles_)
                {
                    for (const Point &vertex : obstacle.vertices)
                    {
                        circles_.push_back({vertex, obstacle.radius});
                    }
                }
                onCircle_.resize(circles_.size());
                /* The first two nodes are start and goal. */
                for (std::size_t i = 0; i < circles_.size(); ++i)
                {
                    if (circles_[i].radius == 0.0)
                    {
                        addNode(i, 0.0);
                    }
                }
                for (std::size_t i = 0; i < circles_.size(); ++i)
                {
                    for (std::size_t j = i + 1; j < circles_.size(); ++j)
                    {
                        addTangents(i, j);
                    }
                }
                for (std::size_t i = 0; i < circles_.size(); ++i)
                {
                    if (circles_[i].radius > 0.0)
                    {
                        addArcs(i);
                    }
                }
            }

            ShortestPath search() const
            {
                constexpr std::size_t START = 0;
                constexpr std::size_t GOAL = 1;
                std::vector<double> cost(nodes_.size(), std::numeric_limits<double>::infinity());
                std::vector<std::pair<std::size_t, const Edge *>> parent(nodes_.size(), {START, nullptr});
                using Entry = std::pair<double, std::size_t>;
                std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
                cost[START] = 0.0;
                open.emplace(0.0, START);
                while (!open.empty())
                {
                    const auto [reached, node] = open.top();
                    open.pop();
                    if (reached > cost[node])
                    {
                        continue;
                    }
                    for (const Edge &edge : nodes_[node].edges)
                    {
                        if (reached + edge.length < cost[edge.to])
                        {
                            cost[edge.to] = reached + edge.length;
                            parent[edge.to] = {node, &edge};
                            open.emplace(cost[edge.to], edge.to);
                        }
                    }
                }
                if (!std::isfinite(cost[GOAL]))
                {
                    return {cost[GOAL], {}};
                }

                Points path{nodes_[GOAL].position};
                for (std::size_t node = GOAL; node != START; node = parent[node].first)
                {
                    appendArc(node, -parent[node].second->sweep, path);
                    path.push_back(nodes_[parent[node].first].position);
                }
                std::reverse(path.begin(), path.end());
                return {cost[GOAL], path};
            }

        private:
            bool inBounds(const Point &p) const
            {
                return (p.array() >= lower_.array()).all() && (p.array() <= upper_.array()).all();
            }

            bool isFree(const Point &p) const
            {
                return inBounds(p) && std::none_of(obstacles_.begin(), obstacles_.end(),
                                                   [&](const Grown &obstacle) { return obstacle.contains(p); });
            }

            bool isFree(const Point &p, const Point &q) const
            {
                return inBounds(p) && inBounds(q) &&
                       std::none_of(obstacles_.begin(), obstacles_.end(),
                                    [&](const Grown &obstacle) { return obstacle.meets(p, q); });
            }

            std::size_t addNode(std::size_t circle, double angle)
            {
                if (circles_[circle].radius == 0.0 && !onCircle_[circle].empty())
                {
                    return onCircle_[circle].front();
                }
                nodes_.push_back({circle, wrap(angle), pointAt(circle, angle), {}});
                onCircle_[circle].push_back(nodes_.size() - 1);
                return nodes_.size() - 1;
            }

            Point pointAt(std::size_t circle, double angle) const
            {
                return circles_[circle].centre + circles_[circle].radius * Point(std::cos(angle), std::sin(angle));
            }

            void connect(std::size_t a, std::size_t b, double length, double sweep)
            {
                nodes_[a].edges.push_back({b, length, sweep});
                nodes_[b].edges.push_back({a, length, -sweep});
            }

            void addTangent(std::size_t i, double angleOnI, std::size_t j, double angleOnJ)
            {
                const Point p = pointAt(i, angleOnI);
                const Point q = pointAt(j, angleOnJ);
                if (!isFree(p, q))
                {
                    return;
                }
                const std::size_t a = addNode(i, angleOnI);
                const std::size_t b = addNode(j, angleOnJ);
                connect(a, b, (q - p).norm(), 0.0);
            }

            void addTangents(std::size_t i, std::size_t j)
            {
                const Point between = circles_[j].centre - circles_[i].centre;
                const double length = between.norm();
                const double direction = std::atan2(between.y(), between.x());
                const double difference = circles_[i].radius - circles_[j].radius;
                const double sum = circles_[i].radius + circles_[j].radius;
                if (length > std::abs(difference))
                {
                    const double outer = std::acos(difference / length);
                    addTangent(i, direction + outer, j, direction + outer);
                    addTangent(i, direction - outer, j, direction - outer);
                }
                const bool bothAreArcs = circles_[i].radius > 0.0 && circles_[j].radius > 0.0;
                if (bothAreArcs && length > sum)
                {
                    const double inner = std::acos(sum / length);
                    addTangent(i, direction + inner, j, direction + inner + M_PI);
                    addTangent(i, direction - inner, j, direction - inner + M_PI);
                }
            }

            /* Between two successive ends an arc is either free or blocked as a whole: the circle can change sides only
               where it crosses the boundary of an obstacle or a bound. */
            void addArcs(std::size_t circle)
            {
                if (onCircle_[circle].empty())
                {
                    return;
                }
                for (const double angle : crossings(circles_[circle]))
                {
                    addNode(circle, angle);
                }
                std::vector<std::size_t> ends = onCircle_[circle];
                std::sort(ends.begin(), ends.end(),
                          [&](std::size_t a, std::size_t b) { return nodes_[a].angle < nodes_[b].angle; });
                for (std::size_t k = 0; k < ends.size(); ++k)
                {
                    const std::size_t next = (k + 1) % ends.size();
                    const double from = nodes_[ends[k]].angle;
                    const double sweep = nodes_[ends[next]].angle - from + (next == 0 ? TWO_PI : 0.0);
                    if (isFree(pointAt(circle, from + 0.5 * sweep)))
                    {
                        connect(ends[k], ends[next], circles_[circle].radius * sweep, sweep);
                    }
                }
            }

            std::vector<double> crossings(const Circle &circle) const
            {
                std::vector<double> angles;
                const auto crossLine = [&](const Point &normal, double offset)
                {
                    const double cosine = (offset - normal.dot(circle.centre)) / circle.radius;
                    if (std::abs(cosine) > 1.0)
                    {
                        return;
                    }
                    const double direction = std::atan2(normal.y(), normal.x());
                    angles.push_back(direction + std::acos(cosine));
                    angles.push_back(direction - std::acos(cosine));
                };
                for (int axis = 0; axis < 2; ++axis)
                {
                    crossLine(Point::Unit(axis), lower_[axis]);
                    crossLine(Point::Unit(axis), upper_[axis]);
                }
                for (const Grown &obstacle : obstacles_)
                {
                    for (std::size_t k = 0; k < obstacle.vertices.size(); ++k)
                    {
                        const Point &a = obstacle.vertices[k];
                        const Point &b = obstacle.vertices[(k + 1) % obstacle.vertices.size()];
                        /* The common chord of the two circles is a line, too. */
                        const Point between = a - circle.centre;
                        const double length = between.norm();
                        if (length > 0.0)
                        {
                            const double chord =
                                0.5 *
                                (length + (circle.radius * circle.radius - obstacle.radius * obstacle.radius) / length);
                            crossLine(between / length, between.dot(circle.centre) / length + chord);
                        }
                        if (obstacle.vertices.size() > 1)
                        {
                            const Point normal = Point(b.y() - a.y(), a.x() - b.x()).normalized();
                            crossLine(normal, normal.dot(a) + obstacle.radius);
                        }
                    }
                }
                return angles;
            }

            void appendArc(std::size_t from, double sweep, Points &path) const
            {
                const Circle &circle = circles_[nodes_[from].circle];
                const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / ARC_PIECE));
                for (int k = 0; k < pieces; ++k)
                {
                    const double piece = sweep / pieces;
                    const double angle = nodes_[from].angle + (k + 0.5) * piece;
                    path.push_back(circle.centre +
                                   circle.radius / std::cos(0.5 * piece) * Point(std::cos(angle), std::sin(angle)));
                }
            }

            Point lower_;
            Point upper_;
            std::vector<Grown> obstacles_;
            std::vector<Circle> circles_;
            std::vector<Node> nodes_;
            std::vector<std::vector<std::size_t>> onCircle_;
        };
    }  // namespace

    Obstacle disc(const Point &centre, double radius)
    {
        if (!(radius > 0.0))
        {
            throw std::invalid_argument("disc: the radius must be positive");
        }
        return {{centre}, radius};
    }

    Obstacle rectangle(const Point &centre, const Point &size, double angle)
    {
        if (!(size.minCoeff() > 0.0))
        {
            throw std::invalid_argument("rectangle: both sides must be positive");
        }
        const Point x = 0.5 * size.x() * Point(std::cos(angle), std::sin(angle));
        const Point y = 0.5 * size.y() * Point(-std::sin(angle), std::cos(angle));
        return {{centre - x - y, centre + x - y, centre + x + y, centre - x + y}, 0.0};
    }

    ShortestPath shortestPath(const Scene &scene, const Point &start, const Point &goal)
    {
        return TangentGraph(scene, start, goal).search();
    }
}  // namespace ompl_mfa::oracle
