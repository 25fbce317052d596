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

#include "paper/PathProblem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

using ompl_mfa::oracle::Obstacle;

namespace ompl_mfa::paper
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /** \brief Narrows [low, high] to where |position + t step| <= half. */
        void clip(double position, double step, double half, double &low, double &high)
        {
            if (step == 0.0)
            {
                if (std::abs(position) > half)
                {
                    high = -INF;
                }
                return;
            }
            const double a = (-half - position) / step;
            const double b = (half - position) / step;
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
        }
    }  // namespace

    PlanarCollision::PlanarCollision(const oracle::Scene &scene)
      : lower_(scene.lower)
      , upper_(scene.upper)
    {
        for (const Obstacle &obstacle : scene.obstacles)
        {
            const double radius = obstacle.radius + scene.robotRadius;
            const auto &v = obstacle.vertices;
            if (v.size() == 1)
            {
                obstacles_.push_back({v[0], Point::UnitX(), Point::Zero(), radius, radius});
                continue;
            }
            if (v.size() != 4 || ((v[1] - v[0]) - (v[2] - v[3])).norm() > 1e-9 ||
                std::abs((v[1] - v[0]).dot(v[3] - v[0])) > 1e-9)
            {
                throw std::invalid_argument("PlanarCollision: an obstacle is neither a disc nor a rectangle");
            }
            const Point halfSides(0.5 * (v[1] - v[0]).norm(), 0.5 * (v[3] - v[0]).norm());
            obstacles_.push_back(
                {0.5 * (v[0] + v[2]), (v[1] - v[0]).normalized(), halfSides, radius, halfSides.norm() + radius});
        }
    }

    PlanarCollision::Interval PlanarCollision::crossing(const Grown &obstacle, const Point &from, const Point &step)
    {
        // In the rectangle's frame the grown obstacle is two crossed rectangles and four discs at the corners; it is
        // convex, so the intersection is one interval.
        const Point toFrom = from - obstacle.centre;
        const auto turn = [&](const Point &v)
        { return Point(obstacle.axis.dot(v), obstacle.axis.x() * v.y() - obstacle.axis.y() * v.x()); };
        const Point p = turn(toFrom);
        const Point d = turn(step);
        Interval whole(INF, -INF);
        const auto unite = [&whole](double low, double high)
        {
            if (low < high)
            {
                whole = {std::min(whole.first, low), std::max(whole.second, high)};
            }
        };
        const double squaredStep = d.squaredNorm();
        const auto uniteDisc = [&](const Point &centre)
        {
            const Point f = p - centre;
            const double b = f.dot(d);
            const double root = b * b - squaredStep * (f.squaredNorm() - obstacle.radius * obstacle.radius);
            if (root > 0.0)
            {
                unite(std::max(0.0, (-b - std::sqrt(root)) / squaredStep),
                      std::min(1.0, (-b + std::sqrt(root)) / squaredStep));
            }
        };
        const Point &half = obstacle.halfSides;
        if (half.x() == 0.0)
        {
            uniteDisc(Point::Zero());
            return whole;
        }
        for (const Point &grow : {Point(obstacle.radius, 0.0), Point(0.0, obstacle.radius)})
        {
            double low = 0.0;
            double high = 1.0;
            clip(p.x(), d.x(), half.x() + grow.x(), low, high);
            clip(p.y(), d.y(), half.y() + grow.y(), low, high);
            unite(low, high);
        }
        for (const double sign : {-1.0, 1.0})
        {
            uniteDisc({half.x(), sign * half.y()});
            uniteDisc({-half.x(), sign * half.y()});
        }
        return whole;
    }

    double PlanarCollision::invalidLength(const Point &from, const Point &to) const
    {
        const Point step = to - from;
        const double squared = step.squaredNorm();
        if (squared == 0.0)
        {
            return 0.0;
        }
        // No segment of the study's scenes crosses more obstacles; overlaps with further ones would count twice.
        std::array<Interval, 16> crossings;
        std::size_t count = 0;
        for (const auto &obstacle : obstacles_)
        {
            const Point toCentre = obstacle.centre - from;
            const double nearest = std::clamp(toCentre.dot(step) / squared, 0.0, 1.0);
            if ((toCentre - nearest * step).squaredNorm() >= obstacle.reach * obstacle.reach)
            {
                continue;
            }
            const Interval interval = crossing(obstacle, from, step);
            if (interval.first < interval.second && count < crossings.size())
            {
                crossings[count++] = interval;
            }
        }
        std::sort(crossings.begin(), crossings.begin() + count);
        double covered = 0.0;
        double end = 0.0;
        for (std::size_t i = 0; i < count; ++i)
        {
            covered += std::max(0.0, crossings[i].second - std::max(end, crossings[i].first));
            end = std::max(end, crossings[i].second);
        }
        return covered * std::sqrt(squared);
    }

    bool PlanarCollision::isValid(const Point &point) const
    {
        if ((point.array() < lower_.array()).any() || (point.array() > upper_.array()).any())
        {
            return false;
        }
        // A short segment across the point: crossing() tests the obstacle's interior.
        return std::all_of(obstacles_.begin(), obstacles_.end(),
                           [&point](const Grown &obstacle)
                           {
                               const Point step(1e-9, 0.0);
                               const Interval interval = crossing(obstacle, point - 0.5 * step, step);
                               return !(interval.first < 0.5 && interval.second > 0.5);
                           });
    }

    PathProblem::PathProblem(const PathScene &scene, unsigned int slices)
      : collision_(scene.world)
      , start_(scene.start)
      , goal_(scene.goal)
    {
        const Point along = (goal_ - start_).normalized();
        lateral_ = {-along.y(), along.x()};
        lower_.resize(slices);
        upper_.resize(slices);
        for (unsigned int k = 0; k < slices; ++k)
        {
            origins_.push_back(start_ + (goal_ - start_) * (k + 1.0) / (slices + 1.0));
            double low = -INF;
            double high = INF;
            const Point middle = 0.5 * (scene.world.lower + scene.world.upper);
            const Point half = 0.5 * (scene.world.upper - scene.world.lower);
            clip(origins_[k].x() - middle.x(), lateral_.x(), half.x(), low, high);
            clip(origins_[k].y() - middle.y(), lateral_.y(), half.y(), low, high);
            lower_[k] = low;
            upper_[k] = high;
        }
    }

    Brightness PathProblem::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        double length = 0.0;
        Point previous = start_;
        for (Eigen::Index k = 0; k <= x.size(); ++k)
        {
            const Point next = k < x.size() ? pointOn(k, x[k]) : goal_;
            length += (next - previous).norm();
            previous = next;
        }
        if (rival != nullptr && rival->isFeasible() && length >= rival->cost)
        {
            return {};
        }
        double violation = 0.0;
        previous = start_;
        for (Eigen::Index k = 0; k <= x.size(); ++k)
        {
            const Point next = k < x.size() ? pointOn(k, x[k]) : goal_;
            violation += collision_.invalidLength(previous, next);
            if (rival != nullptr && violation > rival->violation)
            {
                return {};
            }
            previous = next;
        }
        return {violation, length};
    }

    Points PathProblem::path(const Eigen::Ref<const Eigen::VectorXd> &x) const
    {
        Points points{start_};
        for (Eigen::Index k = 0; k < x.size(); ++k)
        {
            points.push_back(pointOn(k, x[k]));
        }
        points.push_back(goal_);
        return points;
    }

    double PathProblem::sliceOptimum(unsigned int resolution) const
    {
        Points layer{start_};
        std::vector<double> costs{0.0};
        for (Eigen::Index k = 0; k <= lower_.size(); ++k)
        {
            Points next;
            if (k == lower_.size())
            {
                next = {goal_};
            }
            else
            {
                for (unsigned int i = 0; i < resolution; ++i)
                {
                    next.push_back(pointOn(k, lower_[k] + (upper_[k] - lower_[k]) * i / (resolution - 1.0)));
                }
            }
            std::vector<double> nextCosts(next.size(), INF);
            for (std::size_t j = 0; j < next.size(); ++j)
            {
                for (std::size_t i = 0; i < layer.size(); ++i)
                {
                    const double cost = costs[i] + (next[j] - layer[i]).norm();
                    if (cost < nextCosts[j] && collision_.invalidLength(layer[i], next[j]) == 0.0)
                    {
                        nextCosts[j] = cost;
                    }
                }
            }
            layer = std::move(next);
            costs = std::move(nextCosts);
        }
        return costs.front();
    }
}  // namespace ompl_mfa::paper
