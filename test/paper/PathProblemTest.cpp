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

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "engine/fireflies/SliceFrame.h"
#include "ompl_mfa/optimizer/RandomSource.h"
#include "paper/Contender.h"
#include "paper/StudyScenes.h"

namespace ompl_mfa::paper
{
    namespace
    {
        std::vector<PathScene> allScenes()
        {
            auto scenes = paperScenes(OMPL_MFA_SOURCE_DIR "/benchmarks/worlds/paper_scene.yaml");
            for (const auto &scene : seededScenes(20))
            {
                scenes.push_back(scene);
            }
            return scenes;
        }

        /** \brief Distance to a rectangle or point given by its corners, counter-clockwise; 0 inside. */
        double distanceTo(const oracle::Obstacle &obstacle, const Point &point)
        {
            const auto &v = obstacle.vertices;
            if (v.size() == 1)
            {
                return (point - v[0]).norm();
            }
            double nearest = INFINITY;
            bool isInside = true;
            for (std::size_t i = 0; i < v.size(); ++i)
            {
                const Point edge = v[(i + 1) % v.size()] - v[i];
                const Point toPoint = point - v[i];
                isInside = isInside && edge.x() * toPoint.y() - edge.y() * toPoint.x() >= 0.0;
                const double t = std::min(1.0, std::max(0.0, toPoint.dot(edge) / edge.squaredNorm()));
                nearest = std::min(nearest, (toPoint - t * edge).norm());
            }
            return isInside ? 0.0 : nearest;
        }

        bool collides(const oracle::Scene &world, const Point &point)
        {
            for (const auto &obstacle : world.obstacles)
            {
                if (distanceTo(obstacle, point) < obstacle.radius + world.robotRadius)
                {
                    return true;
                }
            }
            return false;
        }
    }  // namespace

    TEST(PlanarCollision, AgreesWithSampledPoints)
    {
        RandomSource random(3);
        constexpr int SAMPLES = 4000;
        for (const auto &scene : allScenes())
        {
            const PlanarCollision collision(scene.world);
            for (int k = 0; k < 15; ++k)
            {
                const Point from(20.0 * random.uniform(), 20.0 * random.uniform());
                const Point to(20.0 * random.uniform(), 20.0 * random.uniform());
                int inside = 0;
                for (int i = 0; i < SAMPLES; ++i)
                {
                    inside += collides(scene.world, from + (i + 0.5) / SAMPLES * (to - from)) ? 1 : 0;
                }
                const double length = (to - from).norm();
                EXPECT_NEAR(collision.invalidLength(from, to), length * inside / SAMPLES, 20.0 * length / SAMPLES);
                EXPECT_EQ(collision.isValid(from), !collides(scene.world, from));
            }
        }
    }

    TEST(PlanarCollision, RefusesOtherShapes)
    {
        oracle::Scene scene;
        scene.obstacles.push_back({{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, 0.0});
        EXPECT_THROW(PlanarCollision{scene}, std::invalid_argument);
    }

    TEST(PathProblem, HasTheSlicesOfThePlanner)
    {
        const auto scene = allScenes().front();
        const PathProblem problem(scene, 6);
        const auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
        space->setBounds(0.0, 20.0);
        space->setup();
        ompl::base::ScopedState<ompl::base::RealVectorStateSpace> start(space);
        ompl::base::ScopedState<ompl::base::RealVectorStateSpace> goal(space);
        for (unsigned int k = 0; k < 2; ++k)
        {
            start[k] = scene.start[k];
            goal[k] = scene.goal[k];
        }
        const auto chart = std::make_shared<path::StateChart>(space);
        const auto frame = engine::fireflies::SliceFrame::straight(chart, start.get(), goal.get(), 7);
        ASSERT_EQ(frame.dimension(), problem.lower().size());
        for (Eigen::Index k = 0; k < 6; ++k)
        {
            EXPECT_NEAR(frame.upper()[k] - frame.lower()[k], problem.upper()[k] - problem.lower()[k], 1e-9);
        }
    }

    TEST(PathProblem, NeverBeatsTheExactOptimum)
    {
        for (const auto &scene : allScenes())
        {
            PathProblem problem(scene, 6);
            const double optimum = oracle::shortestPath(scene.world, scene.start, scene.goal).length;
            EXPECT_GE(problem.sliceOptimum(100), optimum - 1e-6) << scene.name;
            const auto run = runContender("mfa", problem, problem.lower(), problem.upper(), 1.01 * optimum, 1);
            EXPECT_LE(run.evaluations, BUDGET);
            if (run.best.isFeasible())
            {
                EXPECT_GE(run.best.cost, optimum - 1e-6) << scene.name;
                const Points path = problem.path(run.x);
                double length = 0.0;
                for (std::size_t i = 1; i < path.size(); ++i)
                {
                    length += (path[i] - path[i - 1]).norm();
                }
                EXPECT_NEAR(length, run.best.cost, 1e-9);
            }
        }
    }

    TEST(PathProblem, MayStopEarlyOnlyForWhatIsNotBrighter)
    {
        const auto scene = allScenes().front();
        PathProblem problem(scene, 6);
        RandomSource random(9);
        Brightness rival;
        for (int i = 0; i < 3000; ++i)
        {
            Eigen::VectorXd x(6);
            for (Eigen::Index k = 0; k < 6; ++k)
            {
                x[k] = problem.lower()[k] + (problem.upper()[k] - problem.lower()[k]) * random.uniform();
            }
            const auto full = problem.evaluate(x, nullptr);
            const auto lazy = problem.evaluate(x, &rival);
            EXPECT_EQ(problem.isBrighter(full, rival), problem.isBrighter(lazy, rival));
            if (problem.isBrighter(full, rival))
            {
                rival = full;
            }
        }
    }

    TEST(Contenders, KeepToTheBudgetAndRepeatWithTheirSeed)
    {
        const auto scene = allScenes().front();
        std::vector<std::string> names = contenders();
        names.insert(names.end(), ablations().begin(), ablations().end());
        for (const auto &name : names)
        {
            PathProblem problem(scene, 6);
            const auto a = runContender(name, problem, problem.lower(), problem.upper(), 0.0, 4);
            const auto b = runContender(name, problem, problem.lower(), problem.upper(), 0.0, 4);
            EXPECT_EQ(a.evaluations, BUDGET) << name;
            EXPECT_TRUE(a.x == b.x) << name;
            EXPECT_EQ(a.trace.size(), 100U);
            EXPECT_LE(a.trace.back(), a.trace[10]) << name;
        }
        PathProblem problem(scene, 6);
        EXPECT_THROW(runContender("tabu", problem, problem.lower(), problem.upper(), 0.0, 4), std::invalid_argument);
    }
}  // namespace ompl_mfa::paper
