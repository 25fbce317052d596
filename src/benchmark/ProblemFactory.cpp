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

#include "ompl_mfa/benchmark/ProblemFactory.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include <boost/algorithm/string/predicate.hpp>

#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/ObstacleBasedValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/util/RandomNumbers.h>

#include "benchmark/NearbyState.h"
#include "benchmark/ObjectiveFactory.h"
#include "benchmark/ProblemSpace.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/collision/SceneLoader.h"
#include "text/NumberText.h"

namespace ompl_mfa
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        std::shared_ptr<const collision::Scene> loadWorld(const BenchmarkConfig &config)
        {
            if (!config.problem.world)
                return std::make_shared<collision::Scene>();
            const std::filesystem::path file = findResource(config, *config.problem.world);
            try
            {
                return std::make_shared<collision::Scene>(collision::loadScene(file));
            }
            catch (const InputError &error)
            {
                failAt(*config.problem.world, error.what());
            }
        }

        collision::RigidBody loadRobotOf(const BenchmarkConfig &config)
        {
            const ProblemConfig &problem = config.problem;
            const std::string &robot = problem.robot.value;
            if (robot == "point" || robot == "disc" || robot == "sphere")
                return collision::RigidBody::sphere(problem.robotRadius);
            const std::filesystem::path file = findResource(config, problem.robot);
            try
            {
                return collision::loadRobot(file, positionDimension(problem.space) == 2
                                                      ? collision::RobotCentring::PlanarVertexMean
                                                      : collision::RobotCentring::VertexMean);
            }
            catch (const InputError &error)
            {
                failAt(problem.robot, error.what());
            }
        }

        ob::RealVectorBounds givenBounds(const ConfigVolume &volume, unsigned int dimension)
        {
            ob::RealVectorBounds bounds(dimension);
            for (unsigned int i = 0; i < dimension; ++i)
            {
                bounds.setLow(i, volume.min[i]);
                bounds.setHigh(i, volume.max[i]);
            }
            return bounds;
        }

        /* The world's box, enlarged to hold start and goal, as in OMPL.app. */
        ob::RealVectorBounds inferredBounds(const BenchmarkConfig &config, const collision::Scene &world)
        {
            const ProblemConfig &problem = config.problem;
            const unsigned int dimension = positionDimension(problem.space);
            ob::RealVectorBounds bounds(dimension);
            if (world.objects().empty())
                throw InputError(config.file.string() +
                                 ": neither problem.world nor problem.volume.* bounds the problem; give one of them");
            const fcl::AABBd box = world.bounds();
            for (unsigned int i = 0; i < dimension; ++i)
            {
                const double start = i == 0 ? problem.start.x : i == 1 ? problem.start.y : problem.start.z;
                const double goal = i == 0 ? problem.goal.x : i == 1 ? problem.goal.y : problem.goal.z;
                bounds.setLow(i, std::min({box.min_[i], start, goal}));
                bounds.setHigh(i, std::max({box.max_[i], start, goal}));
                if (bounds.low[i] >= bounds.high[i])
                    throw InputError(config.file.string() + ": the world, start and goal are flat along " +
                                     std::string(1, "xyz"[i]) + "; give problem.volume.*");
            }
            return bounds;
        }

        ob::RealVectorBounds boundsOf(const BenchmarkConfig &config, const collision::Scene &world)
        {
            return config.problem.volume ? givenBounds(*config.problem.volume, positionDimension(config.problem.space))
                                         : inferredBounds(config, world);
        }

        ob::ValidStateSamplerPtr makeSampler(const ob::SpaceInformation *si, std::size_t kind)
        {
            switch (kind)
            {
                case 0:
                    return std::make_shared<ob::UniformValidStateSampler>(si);
                case 1:
                    return std::make_shared<ob::GaussianValidStateSampler>(si);
                case 2:
                    return std::make_shared<ob::ObstacleBasedValidStateSampler>(si);
                case 3:
                    return std::make_shared<ob::MaximizeClearanceValidStateSampler>(si);
                default:
                    return std::make_shared<ob::BridgeTestValidStateSampler>(si);
            }
        }

        void setContextValue(ob::ParamSet &parameters, const ConfigEntry &entry, const std::string &owner)
        {
            if (!parameters.hasParam(entry.key))
            {
                std::vector<std::string> names;
                parameters.getParamNames(names);
                failAt(entry, owner + " has no such setting" + suggestion(entry.key, names));
            }
            positiveValue(entry);
            bool isSet = false;
            try
            {
                isSet = parameters.setParam(entry.key, entry.value);
            }
            catch (const std::exception &error)
            {
                failAt(entry, error.what());
            }
            if (!isSet)
                failAt(entry, "not accepted by " + owner);
        }

        /* The settings of a problem's space information, sorted by what they configure and when. */
        struct Context
        {
            std::vector<ConfigEntry> space;
            std::vector<ConfigEntry> projection;
            std::vector<ConfigEntry> sampling;
            ConfigEntry sampler{"sampler", "uniform", ""};
        };

        Context sortContext(const std::vector<ConfigEntry> &entries)
        {
            Context context;
            for (const auto &entry : entries)
            {
                if (entry.key == "sampler")
                    context.sampler = entry;
                else if (boost::starts_with(entry.key, "projection."))
                    context.projection.push_back(entry);
                else if (boost::contains(entry.key, "valid_segment"))
                    context.space.push_back(entry);
                else
                    context.sampling.push_back(entry);
            }
            return context;
        }

        std::vector<ConfigEntry> overridden(std::vector<ConfigEntry> entries, const std::vector<ConfigEntry> &overrides)
        {
            for (const auto &entry : overrides)
            {
                const auto same = std::find_if(entries.begin(), entries.end(),
                                               [&entry](const ConfigEntry &other) { return other.key == entry.key; });
                if (same == entries.end())
                    entries.push_back(entry);
                else
                    *same = entry;
            }
            return entries;
        }

        void setSampler(const ob::SpaceInformationPtr &si, const Context &context)
        {
            const std::size_t kind =
                choiceValue(context.sampler, {"uniform", "gaussian", "obstacle_based", "max_clearance", "bridge_test"});
            const auto allocate =
                [kind, sampling = context.sampling, name = context.sampler.value](const ob::SpaceInformation *space)
            {
                ob::ValidStateSamplerPtr sampler = makeSampler(space, kind);
                for (const auto &entry : sampling)
                    setContextValue(sampler->params(), entry, "the sampler '" + name + "'");
                return sampler;
            };
            allocate(si.get());
            si->setValidStateSamplerAllocator(allocate);
        }

        std::shared_ptr<collision::FclStateValidityChecker> makeChecker(
            const ob::SpaceInformationPtr &si, const ProblemConfig &problem,
            const std::shared_ptr<const collision::Scene> &world, const collision::RigidBody &robot)
        {
            try
            {
                return std::make_shared<collision::FclStateValidityChecker>(si, world, robot, problem.meshInterior);
            }
            catch (const InputError &error)
            {
                failAt(problem.world ? *problem.world : problem.robot, error.what());
            }
        }

        std::string describeBounds(const ob::RealVectorBounds &bounds)
        {
            constexpr int DIGITS = 6;
            std::string text;
            for (std::size_t i = 0; i < bounds.low.size(); ++i)
                text += (i == 0 ? "[" : " x [") + numberText(bounds.low[i], DIGITS) + ", " +
                        numberText(bounds.high[i], DIGITS) + "]";
            return text;
        }

        /* By how much a state collides, and where to it could go: for a slip of the pen, not for a state within an
           obstacle. */
        std::string describeCollision(const ob::SpaceInformation &si, StateSpaceKind kind, const ConfigPose &pose,
                                      const ob::RealVectorBounds &bounds)
        {
            constexpr double SMALL_PART = 0.01;
            constexpr int DIGITS = 4;
            double squaredSize = 0.0;
            for (const double length : bounds.getDifference())
                squaredSize += length * length;
            const auto nearby = findNearbyState(si, kind, pose, SMALL_PART * std::sqrt(squaredSize));
            return nearby ? " by " + numberText(nearby->distance, DIGITS) + "; a valid state nearby is " +
                                describePose(kind, nearby->pose)
                          : "";
        }

        void requireValid(const og::SimpleSetup &setup, const ob::ScopedState<> &state, const std::string &which,
                          const ConfigPose &pose, const ProblemConfig &problem, const ob::RealVectorBounds &bounds)
        {
            const std::string described = which + " " + describePose(problem.space, pose);
            if (!setup.getStateSpace()->satisfiesBounds(state.get()))
                failAt(pose.origin, described + " is outside the bounds " + describeBounds(bounds));
            if (!setup.getSpaceInformation()->isValid(state.get()))
            {
                failAt(pose.origin, described + " is in collision" +
                                        (problem.world ? " with the world '" + problem.world->value + "'" : "") +
                                        describeCollision(*setup.getSpaceInformation(), problem.space, pose, bounds));
            }
        }
    }  // namespace

    ProblemFactory::ProblemFactory(BenchmarkConfig config)
      : config_(std::move(config))
      , world_(loadWorld(config_))
      , robot_(loadRobotOf(config_))
    {
        boundsOf(config_, *world_);
    }

    og::SimpleSetupPtr ProblemFactory::create(const std::vector<ConfigEntry> &plannerContext) const
    {
        const ProblemConfig &problem = config_.problem;
        const Context context = sortContext(overridden(problem.context, plannerContext));
        const ob::RealVectorBounds bounds = boundsOf(config_, *world_);
        const ob::StateSpacePtr space = makeStateSpace(problem, bounds);
        space->setName(spaceName(problem.space));
        for (const auto &entry : context.space)
            setContextValue(space->params(), entry, "the state space");

        auto setup = std::make_shared<og::SimpleSetup>(space);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        collision::setCollisionChecking(si, makeChecker(si, problem, world_, robot_), problem.motionValidation);
        if (const auto objective = makeObjective(si, problem))
            setup->setOptimizationObjective(objective);
        si->setup();
        for (const auto &entry : context.projection)
            setContextValue(space->params(), entry, "the state space");
        setSampler(si, context);
        si->setup();

        const ob::ScopedState<> start = makeState(space, problem.space, problem.start);
        const ob::ScopedState<> goal = makeState(space, problem.space, problem.goal);
        requireValid(*setup, start, "start", problem.start, problem, bounds);
        requireValid(*setup, goal, "goal", problem.goal, problem, bounds);
        setup->setStartAndGoalStates(start, goal, problem.threshold);
        return setup;
    }

    og::SimpleSetupPtr ProblemFactory::create(const PlannerSpec &spec) const
    {
        og::SimpleSetupPtr setup = create(spec.context);
        setup->setPlanner(createPlanner(setup->getSpaceInformation(), spec));
        return setup;
    }

    void setRandomSeed(std::uint_fast32_t seed)
    {
        if (seed == 0)
            throw InputError("seed = 0: expected a whole number from 1 to 4294967295");
        ompl::RNG::setSeed(seed);
    }
}  // namespace ompl_mfa
