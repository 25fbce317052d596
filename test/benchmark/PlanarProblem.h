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

#ifndef OMPL_MFA_TEST_BENCHMARK_PLANAR_PROBLEM_
#define OMPL_MFA_TEST_BENCHMARK_PLANAR_PROBLEM_

#include <cmath>
#include <memory>

#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

namespace ompl_mfa::test
{
    /* The square [0, 10]^2 without a disc around its centre; clearance is exact. */
    class DiscChecker : public ompl::base::StateValidityChecker
    {
    public:
        DiscChecker(const ompl::base::SpaceInformationPtr &si, double radius)
          : ompl::base::StateValidityChecker(si)
          , radius_(radius)
        {
        }

        bool isValid(const ompl::base::State *state) const override
        {
            return clearance(state) > 0.0;
        }

        double clearance(const ompl::base::State *state) const override
        {
            const auto &x = *state->as<ompl::base::RealVectorStateSpace::StateType>();
            return std::hypot(x[0] - 5.0, x[1] - 5.0) - radius_;
        }

    private:
        double radius_;
    };

    /* From (1, 5) to (9, 5) around the disc. */
    inline ompl::geometric::SimpleSetupPtr planarProblem(double radius = 2.0)
    {
        const auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
        space->setBounds(0.0, 10.0);
        auto setup = std::make_shared<ompl::geometric::SimpleSetup>(space);
        const auto &si = setup->getSpaceInformation();
        setup->setStateValidityChecker(std::make_shared<DiscChecker>(si, radius));
        setup->setOptimizationObjective(std::make_shared<ompl::base::PathLengthOptimizationObjective>(si));
        ompl::base::ScopedState<> start(space);
        ompl::base::ScopedState<> goal(space);
        start[0] = 1.0;
        start[1] = 5.0;
        goal[0] = 9.0;
        goal[1] = 5.0;
        setup->setStartAndGoalStates(start, goal);
        return setup;
    }

    /* Length of the shortest path of planarProblem(): two tangents and an arc. */
    inline double planarOptimum(double radius = 2.0)
    {
        const double tangent = std::sqrt(16.0 - radius * radius);
        return 2.0 * tangent + radius * 2.0 * std::asin(radius / 4.0);
    }
}  // namespace ompl_mfa::test

#endif
