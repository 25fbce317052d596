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

#ifndef OMPL_MFA_TEST_ENGINE_REFINEMENT_ROOM_PROBLEM_
#define OMPL_MFA_TEST_ENGINE_REFINEMENT_ROOM_PROBLEM_

/* A room with a ball and a wall for any space, objectives in it, and random valid paths. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/ScopedState.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/util/RandomNumbers.h>

#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    namespace ob = ompl::base;

    /* The positions of a state must stay out of a ball around the origin and, in a plane, out of a thin wall. */
    class Room : public ob::StateValidityChecker
    {
    public:
        explicit Room(const ob::SpaceInformationPtr &si)
          : StateValidityChecker(si)
          , chart_(si->getStateSpace())
        {
        }

        bool isValid(const ob::State *state) const override
        {
            return clearance(state) > 0.0;
        }

        double clearance(const ob::State *state) const override
        {
            Eigen::VectorXd x(chart_.positionDimension());
            chart_.positions(state, x);
            if (x.size() < 2)
            {
                return 1.0;
            }
            return std::min(x.norm() - 2.0, std::hypot(std::max(0.0, std::abs(x[0]) - 0.02), std::max(0.0, x[1])));
        }

        /* The first position of a state. */
        double height(const ob::State *state) const
        {
            Eigen::VectorXd x(chart_.positionDimension());
            chart_.positions(state, x);
            return x.size() > 0 ? x[0] : 0.0;
        }

    private:
        path::StateChart chart_;
    };

    inline const Room &roomOf(const ob::SpaceInformationPtr &si)
    {
        return static_cast<const Room &>(*si->getStateValidityChecker());
    }

    /* Infinite within a band around the ball. */
    class LethalBand : public ob::StateCostIntegralObjective
    {
    public:
        explicit LethalBand(const ob::SpaceInformationPtr &si)
          : StateCostIntegralObjective(si, true)
        {
        }

        ob::Cost stateCost(const ob::State *state) const override
        {
            const double clearance = roomOf(si_).clearance(state);
            return clearance < 1.0 && clearance > 0.5 ? infiniteCost() : ob::Cost(1.0 + 1.0 / (1.0 + clearance));
        }

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            // infinite cost times no length is not a number
            return si_->equalStates(from, to) ? identityCost() : StateCostIntegralObjective::motionCost(from, to);
        }
    };

    class Climbing : public ob::MechanicalWorkOptimizationObjective
    {
    public:
        explicit Climbing(const ob::SpaceInformationPtr &si)
          : MechanicalWorkOptimizationObjective(si, 0.1)
        {
        }

        ob::Cost stateCost(const ob::State *state) const override
        {
            return ob::Cost(roomOf(si_).height(state));
        }
    };

    /* A motion costs three times as much in one direction as in the other. */
    class OneWayLength : public ob::PathLengthOptimizationObjective
    {
    public:
        using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            const bool up = roomOf(si_).height(to) > roomOf(si_).height(from);
            return ob::Cost((up ? 3.0 : 1.0) * si_->distance(from, to));
        }
    };

    using MakeObjective = ob::OptimizationObjectivePtr (*)(const ob::SpaceInformationPtr &);

    template <typename Objective>
    inline ob::OptimizationObjectivePtr make(const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<Objective>(si);
    }

    const std::vector<MakeObjective> OBJECTIVES{make<ob::PathLengthOptimizationObjective>,
                                                make<ob::MaximizeMinClearanceObjective>, make<LethalBand>,
                                                make<Climbing>, make<OneWayLength>};

    /* A path of up to \e states random states, whose motions are valid at twice the resolution. */
    inline path::Waypoints anyStrictPath(path::PathEvaluator &evaluator, const path::StateChart &chart, ompl::RNG &rng,
                                         std::size_t states)
    {
        path::Waypoints path(chart.space());
        ob::ScopedState<> state(chart.space());
        for (int tries = 0; tries < 400 && path.size() < states; ++tries)
        {
            chart.sampleUniform(rng, state.get());
            if (evaluator.checkState(state.get()) &&
                (path.empty() || evaluator.checkStrictly({{path.back(), state.get()}})))
            {
                path.append(state.get());
            }
        }
        return path;
    }
}  // namespace ompl_mfa::engine::refinement

#endif
