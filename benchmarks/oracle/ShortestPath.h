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

#ifndef OMPL_MFA_BENCHMARKS_ORACLE_SHORTEST_PATH_
#define OMPL_MFA_BENCHMARKS_ORACLE_SHORTEST_PATH_

#include <vector>

#include <Eigen/Core>
#include <Eigen/StdVector>

namespace ompl_mfa::oracle
{
    /* The exact optimum for comparison with planners in the plane. Usage:

           oracle::Scene scene;
           scene.obstacles = {oracle::disc({5.0, 5.0}, 1.5), oracle::rectangle({10.0, 8.0}, {2.0, 4.0}, 0.3)};
           scene.robotRadius = 0.3;
           scene.lower = {0.0, 0.0};
           scene.upper = {20.0, 20.0};
           const oracle::ShortestPath best = oracle::shortestPath(scene, {0.3, 2.2}, {20.0, 20.0});

       and link ompl_mfa_oracle. The method is a visibility graph of common tangents: every obstacle, grown by the
       robot, is bounded by circular arcs and straight edges, and a shortest path consists of segments tangent to two
       such arcs and of sections of the arcs themselves (Chew, "Planning the shortest path for a disc in O(n^2 log n)
       time", 1985). There is no discretisation: the length is exact except for rounding and a contact tolerance of 1e-8
       m. */

    using Point = Eigen::Vector2d;
    using Points = std::vector<Point, Eigen::aligned_allocator<Point>>;

    /** \brief A convex obstacle: all points within \e radius of a convex polygon. Metres.

        One vertex and a positive radius make a disc; three or more vertices, counter-clockwise and without collinear
        triples, make a polygon. Obstacles may overlap. */
    struct Obstacle
    {
        Points vertices;
        double radius{0.0};
    };

    /** \brief A disc. Throws std::invalid_argument unless the radius is positive. */
    Obstacle disc(const Point &centre, double radius);

    /** \brief A box of the given side lengths (m), turned by \e angle (rad). Throws std::invalid_argument unless both
        sides are positive. */
    Obstacle rectangle(const Point &centre, const Point &size, double angle = 0.0);

    struct Scene
    {
        std::vector<Obstacle> obstacles;
        /** \brief Radius of the disc robot (m); 0 is a point. */
        double robotRadius{0.0};
        /** \brief Bounds of the robot's centre. */
        Point lower{Point::Constant(-1e6)};
        Point upper{Point::Constant(1e6)};
    };

    struct ShortestPath
    {
        /** \brief Exact length (m); infinite when start and goal are not connected. */
        double length;
        /** \brief Polyline from start to goal, empty when they are not connected. Arcs are replaced by tangent polygons
            of at most 0.02 rad per segment: it touches obstacles without entering them, and is longer than \e length by
            less than 4e-5 of the arcs' length. */
        Points path;
    };

    /** \brief The shortest collision-free path of the robot's centre. Touching an obstacle or a bound is allowed.

        Throws std::invalid_argument for a start or goal that is out of bounds or in collision, a negative robot radius,
        or an obstacle that is neither a disc nor a convex counter-clockwise polygon. */
    ShortestPath shortestPath(const Scene &scene, const Point &start, const Point &goal);
}  // namespace ompl_mfa::oracle

#endif
