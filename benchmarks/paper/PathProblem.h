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

#ifndef OMPL_MFA_BENCHMARKS_PAPER_PATH_PROBLEM_
#define OMPL_MFA_BENCHMARKS_PAPER_PATH_PROBLEM_

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"
#include "oracle/ShortestPath.h"

namespace ompl_mfa::paper
{
    using oracle::Point;
    using oracle::Points;

    /** \brief A scene of discs and rectangles with a start and a goal; lengths in metres. */
    struct PathScene
    {
        std::string name;
        oracle::Scene world;
        Point start;
        Point goal;
    };

    /** \brief Exact collisions of the disc robot's centre with discs and rectangles grown by its radius, without
        discretisation. The geometry is that of the oracle, which computes the optimum. */
    class PlanarCollision
    {
    public:
        /** \brief Throws std::invalid_argument for an obstacle that is neither a disc nor a rectangle. */
        explicit PlanarCollision(const oracle::Scene &scene);

        /** \brief The length of the segment within obstacles (m). */
        double invalidLength(const Point &from, const Point &to) const;

        bool isValid(const Point &point) const;

    private:
        /** \brief All points within radius of a rectangle; a disc has half sides 0. */
        struct Grown
        {
            Point centre;
            Point axis;
            Point halfSides;
            double radius;
            double reach;
        };

        using Interval = std::pair<double, double>;

        static Interval crossing(const Grown &obstacle, const Point &from, const Point &step);

        std::vector<Grown> obstacles_;
        Point lower_;
        Point upper_;
    };

    /** \brief Path length over m - 1 fixed slices (section III.C): the unknowns are the lateral offsets (m) from the
        straight line, one per slice, within the bounds of the scene. The violation is the length in collision. */
    class PathProblem : public ObjectiveFunction
    {
    public:
        /** \brief \e slices = m - 1, at least 1. */
        PathProblem(const PathScene &scene, unsigned int slices);

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;

        /** \brief d x 1, d the number of slices. */
        const Eigen::VectorXd &lower() const
        {
            return lower_;
        }

        const Eigen::VectorXd &upper() const
        {
            return upper_;
        }

        /** \brief Start, one point on each slice, and goal. */
        Points path(const Eigen::Ref<const Eigen::VectorXd> &x) const;

        /** \brief The shortest collision-free path that has its vertices on the slices, with \e resolution offsets per
            slice: approximately a lower bound for algorithms over these slices. Infinite if there is none. */
        double sliceOptimum(unsigned int resolution) const;

        const PlanarCollision &collision() const
        {
            return collision_;
        }

    private:
        Point pointOn(Eigen::Index slice, double offset) const
        {
            return origins_[static_cast<std::size_t>(slice)] + offset * lateral_;
        }

        PlanarCollision collision_;
        Point start_;
        Point goal_;
        Point lateral_;
        Points origins_;
        Eigen::VectorXd lower_;
        Eigen::VectorXd upper_;
    };
}  // namespace ompl_mfa::paper

#endif
