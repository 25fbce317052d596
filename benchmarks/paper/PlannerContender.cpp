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

#include "paper/PlannerContender.h"

#include <chrono>
#include <limits>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/RandomNumbers.h>

#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::paper
{
    namespace
    {
        Point toPoint(const ob::State *state)
        {
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return {values[0], values[1]};
        }

        /** \brief Exact motion checks, counted. */
        class ExactMotionValidator : public ob::MotionValidator
        {
        public:
            ExactMotionValidator(const ob::SpaceInformationPtr &si, const PlanarCollision &collision)
              : MotionValidator(si)
              , collision_(collision)
            {
            }

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                ++checks;
                return collision_.invalidLength(toPoint(from), toPoint(to)) == 0.0;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> &lastValid) const override
            {
                if (checkMotion(from, to))
                {
                    return true;
                }
                double valid = 0.0;
                double invalid = 1.0;
                while (invalid - valid > 1e-9)
                {
                    const double middle = 0.5 * (valid + invalid);
                    const Point point = toPoint(from) + middle * (toPoint(to) - toPoint(from));
                    (collision_.invalidLength(toPoint(from), point) == 0.0 ? valid : invalid) = middle;
                }
                lastValid.second = valid;
                if (lastValid.first != nullptr)
                {
                    si_->getStateSpace()->interpolate(from, to, valid, lastValid.first);
                }
                return false;
            }

            mutable std::uint64_t checks{0};

        private:
            const PlanarCollision &collision_;
        };

        og::SimpleSetup makeProblem(const PathScene &scene, const PlanarCollision &collision)
        {
            const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
            ob::RealVectorBounds bounds(2);
            for (unsigned int k = 0; k < 2; ++k)
            {
                bounds.setLow(k, scene.world.lower[k]);
                bounds.setHigh(k, scene.world.upper[k]);
            }
            space->setBounds(bounds);
            og::SimpleSetup setup(space);
            setup.setStateValidityChecker([&collision](const ob::State *state)
                                          { return collision.isValid(toPoint(state)); });
            setup.getSpaceInformation()->setMotionValidator(
                std::make_shared<ExactMotionValidator>(setup.getSpaceInformation(), collision));
            ob::ScopedState<ob::RealVectorStateSpace> start(space);
            ob::ScopedState<ob::RealVectorStateSpace> goal(space);
            for (unsigned int k = 0; k < 2; ++k)
            {
                start[k] = scene.start[k];
                goal[k] = scene.goal[k];
            }
            setup.setStartAndGoalStates(start, goal);
            return setup;
        }
    }  // namespace

    PlannerRun runPlanner(const PathScene &scene, unsigned int slices, double target, std::uint32_t seed)
    {
        ompl::RNG::setSeed(seed);
        const PlanarCollision collision(scene.world);
        og::SimpleSetup setup = makeProblem(scene, collision);
        const auto planner = std::make_shared<MFA>(setup.getSpaceInformation());
        planner->params().setParam("seed", std::to_string(seed));
        setup.setPlanner(planner);
        setup.setup();

        const auto &validator =
            static_cast<const ExactMotionValidator &>(*setup.getSpaceInformation()->getMotionValidator());
        const auto start = std::chrono::steady_clock::now();
        PlannerRun result;
        Run &run = result.run;
        const auto observe = [&]
        {
            run.evaluations = std::min<std::uint64_t>(BUDGET, validator.checks / (slices + 1));
            const double best = planner->bestCost();
            while (run.trace.size() < 100 && run.evaluations * 100 >= BUDGET * (run.trace.size() + 1))
            {
                run.trace.push_back(best);
            }
            if (run.evaluationsToTarget == 0 && best <= target)
            {
                run.evaluationsToTarget = std::max<std::uint64_t>(1, run.evaluations);
                run.secondsToTarget = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            }
            return run.evaluations >= BUDGET;
        };
        const bool solved = static_cast<bool>(planner->solve(ob::PlannerTerminationCondition(observe)));
        observe();
        run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        run.trace.resize(100, planner->bestCost());
        if (!solved || setup.getProblemDefinition()->hasApproximateSolution())
        {
            return result;
        }

        const og::PathGeometric &path = setup.getSolutionPath();
        double invalid = 0.0;
        for (std::size_t i = 0; i < path.getStateCount(); ++i)
        {
            result.path.push_back(toPoint(path.getState(i)));
            if (i > 0)
            {
                invalid += collision.invalidLength(result.path[i - 1], result.path[i]);
            }
        }
        run.best = {invalid, path.length()};
        return result;
    }
}  // namespace ompl_mfa::paper
