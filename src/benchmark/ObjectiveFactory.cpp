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

#include "benchmark/ObjectiveFactory.h"

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/maps/ClearanceCostObjective.h"
#include "ompl_mfa/maps/SmoothnessObjective.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        ob::OptimizationObjectivePtr makeClearanceCost(const ob::SpaceInformationPtr &si, const ProblemConfig &problem)
        {
            const auto checker =
                std::dynamic_pointer_cast<const maps::MapStateValidityChecker>(si->getStateValidityChecker());
            if (!checker)
            {
                throw InputError("clearance_cost is for maps; the world is to be a .yaml of map_server or a .map");
            }
            maps::ClearanceCostObjective::Settings settings;
            settings.costScalingFactor = problem.costScalingFactor;
            settings.inscribedRadius = problem.inscribedRadius.value_or(checker->footprint().inscribedRadius());
            settings.penalty = problem.costPenalty;
            return std::make_shared<maps::ClearanceCostObjective>(si, checker, settings);
        }

        ob::OptimizationObjectivePtr makeObjective(const ob::SpaceInformationPtr &si, const ProblemConfig &problem,
                                                   ObjectiveKind kind)
        {
            switch (kind)
            {
                case ObjectiveKind::Length:
                    break;
                case ObjectiveKind::MaxMinClearance:
                    return std::make_shared<ob::MaximizeMinClearanceObjective>(si);
                case ObjectiveKind::MechanicalWork:
                    return std::make_shared<ob::MechanicalWorkOptimizationObjective>(si);
                case ObjectiveKind::Proximity:
                    return std::make_shared<ProximityIntegralObjective>(si);
                case ObjectiveKind::Smoothness:
                    return std::make_shared<maps::SmoothnessObjective>(si);
                case ObjectiveKind::ClearanceCost:
                    return makeClearanceCost(si, problem);
                case ObjectiveKind::Weighted:
                {
                    auto sum = std::make_shared<ob::MultiOptimizationObjective>(si);
                    for (const auto &[term, weight] : problem.objectiveWeights)
                    {
                        sum->addObjective(makeObjective(si, problem, term), weight);
                    }
                    sum->lock();
                    return sum;
                }
            }
            return std::make_shared<ob::PathLengthOptimizationObjective>(si);
        }
    }  // namespace

    ProximityIntegralObjective::ProximityIntegralObjective(const ob::SpaceInformationPtr &si)
      : ob::StateCostIntegralObjective(si, true)
    {
        description_ = "Proximity Integral";
    }

    ob::Cost ProximityIntegralObjective::stateCost(const ob::State *state) const
    {
        return ob::Cost(1.0 / (1.0 + si_->getStateValidityChecker()->clearance(state)));
    }

    ob::OptimizationObjectivePtr makeObjective(const ob::SpaceInformationPtr &si, const ProblemConfig &problem)
    {
        if (!problem.objective)
        {
            return nullptr;
        }
        ob::OptimizationObjectivePtr objective = makeObjective(si, problem, *problem.objective);
        if (problem.objectiveThreshold)
        {
            objective->setCostThreshold(ob::Cost(*problem.objectiveThreshold));
        }
        return objective;
    }
}  // namespace ompl_mfa::benchmark
