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

#ifndef OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_
#define OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"
#include "ompl_mfa/maps/Footprint.h"
#include "ompl_mfa/maps/ObstacleGrid.h"
#include "ompl_mfa/maps/Scenario.h"
#include "ompl_mfa/robots/RobotProblem.h"

namespace ompl_mfa::benchmark
{
    /** \brief Makes the problems of one config. World and robot are loaded once and shared by all of them and by copies
        of the factory. */
    class OMPL_MFA_EXPORT ProblemFactory
    {
    public:
        /** \brief Loads world and robot. Makes no random number generator. Throws InputError for a missing or invalid
            file, and if neither the config nor a world gives bounds. */
        explicit ProblemFactory(BenchmarkConfig config);

        const BenchmarkConfig &config() const
        {
            return config_;
        }

        /** \brief Empty if the config names no world, or a map. */
        const collision::Scene &world() const
        {
            return *world_;
        }

        /** \brief The rigid body that moves; not for an arm. On a map, a ball that holds the footprint. */
        const collision::RigidBody &robot() const
        {
            return robot_.value();
        }

        /** \brief The arm that moves; null for a rigid body. */
        const robots::RobotProblem *arm() const
        {
            return arm_.get();
        }

        /** \brief Null if the world is not a map. */
        const maps::ObstacleGrid *map() const
        {
            return map_.get();
        }

        /** \brief A factory of the same problems on \e grid in place of its map, which it has to have. */
        ProblemFactory onMap(std::shared_ptr<const maps::ObstacleGrid> grid) const;

        /** \brief Replaces the start and the goal of config(). */
        void setStartAndGoal(const ConfigPose &start, const ConfigPose &goal);

        /** \brief The robot on a map; a point in other worlds. */
        const maps::Footprint &footprint() const
        {
            return footprint_;
        }

        /** \brief The problems that a scenario gives; empty without a scenario. */
        const std::vector<maps::ScenarioProblem> &problems() const
        {
            return problems_;
        }

        /** \brief Makes problem \e number < problems().size() the one that create() makes: start and goal of config()
            become its own. Initially it is the first. */
        void select(std::size_t number);

        /** \brief A new problem, set up except for its planner. \e plannerContext overrides the context of the config
            for this problem only.

            Makes random number generators, so setRandomSeed() has to be called before. Throws InputError if start or
            goal is out of bounds or in collision (the message gives a valid state nearby if there is one within a
            hundredth of the bounds' diagonal), or if the space or the sampler does not have a setting that is given. */
        ompl::geometric::SimpleSetupPtr create(const ContextConfig &plannerContext = {}) const;

        /** \brief As above, with the context and the planner of \e spec. */
        ompl::geometric::SimpleSetupPtr create(const PlannerSpec &spec) const;

    private:
        ompl::geometric::SimpleSetupPtr createArm(const ContextConfig &context) const;
        void setChecking(const ompl::base::SpaceInformationPtr &si) const;
        ompl::base::RealVectorBounds bounds() const;

        BenchmarkConfig config_;
        std::shared_ptr<const robots::RobotProblem> arm_;
        std::shared_ptr<const maps::ObstacleGrid> map_;
        maps::Footprint footprint_;
        std::vector<maps::ScenarioProblem> problems_;
        std::shared_ptr<const collision::Scene> world_;
        std::optional<collision::RigidBody> robot_;
    };

    /** \brief Seeds OMPL. Runs are repeatable if this is called before the process makes its first random number
        generator. Throws InputError for 0, which OMPL does not accept. */
    OMPL_MFA_EXPORT void setRandomSeed(std::uint_fast32_t seed);
}  // namespace ompl_mfa::benchmark

#endif
