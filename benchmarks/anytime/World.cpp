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

#include "anytime/World.h"

#include <cmath>
#include <utility>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateProjections.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        /* Closed-form check of a state of R^n, including its bounds. */
        class ClosedFormChecker : public ob::StateValidityChecker
        {
        public:
            ClosedFormChecker(const ob::SpaceInformationPtr &si, StateCheck isFree)
              : StateValidityChecker(si)
              , isFree_(std::move(isFree))
            {
            }

            bool isValid(const ob::State *state) const override
            {
                return si_->satisfiesBounds(state) && isFree_(state->as<ob::RealVectorStateSpace::StateType>()->values);
            }

        private:
            StateCheck isFree_;
        };

        /* OMPL's default in the plane is an identity projection that aborts in 1.5.2. */
        void registerIdentityProjection(const ob::StateSpacePtr &space)
        {
            space->registerDefaultProjection(
                std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(space, std::vector<unsigned int>{0, 1}));
        }

        ob::ScopedState<> toState(const ob::StateSpacePtr &space, const Eigen::VectorXd &x)
        {
            ob::ScopedState<> state(space);
            for (Eigen::Index i = 0; i < x.size(); ++i)
            {
                state[static_cast<unsigned int>(i)] = x[i];
            }
            return state;
        }
    }  // namespace

    Problem countChecks(const ob::SpaceInformationPtr &si, const ob::ProblemDefinitionPtr &pdef)
    {
        Problem problem{si, pdef, nullptr};
        const auto checker = std::make_shared<path::CountingValidityChecker>(si, si->getStateValidityChecker());
        problem.checker = checker;
        si->setStateValidityChecker(checker);
        si->setup();
        return problem;
    }

    Problem makeProblem(const Eigen::VectorXd &lower, const Eigen::VectorXd &upper, const Eigen::VectorXd &start,
                        const Eigen::VectorXd &goal, double resolution, StateCheck isFree)
    {
        const auto dimension = static_cast<unsigned int>(lower.size());
        const auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
        ob::RealVectorBounds bounds(dimension);
        for (unsigned int i = 0; i < dimension; ++i)
        {
            bounds.setLow(i, lower[i]);
            bounds.setHigh(i, upper[i]);
        }
        space->setBounds(bounds);
        space->setLongestValidSegmentFraction(resolution / (upper - lower).norm());
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        si->setStateValidityChecker(std::make_shared<ClosedFormChecker>(si, std::move(isFree)));
        const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
        pdef->setStartAndGoalStates(toState(space, start), toState(space, goal));
        const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
        length->setCostThreshold(ob::Cost(0.0));
        pdef->setOptimizationObjective(length);
        Problem problem = countChecks(si, pdef);
        // setting up a space registers its own projections again
        if (dimension == 2)
        {
            registerIdentityProjection(space);
        }
        return problem;
    }

    double WorldRandom::uniform(double low, double high)
    {
        const double unit = std::ldexp(static_cast<double>(engine_() >> 11), -53);
        return low + unit * (high - low);
    }
}  // namespace ompl_mfa::anytime
