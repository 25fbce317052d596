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

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/ObstacleBasedValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/util/RandomNumbers.h>

#include "benchmark/ArmConfig.h"
#include "benchmark/ConfigKeys.h"
#include "benchmark/MapProblem.h"
#include "benchmark/NearbyState.h"
#include "benchmark/ObjectiveFactory.h"
#include "benchmark/ProblemSpace.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/collision/SceneLoader.h"
#include "ompl_mfa/maps/MapMotionValidator.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        std::shared_ptr<const collision::Scene> loadWorld(const BenchmarkConfig &config, bool isMap)
        {
            if (!config.problem.world || isMap)
            {
                return std::make_shared<collision::Scene>();
            }
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

        collision::RigidBody loadRobotOf(const BenchmarkConfig &config, const maps::Footprint &footprint)
        {
            const ProblemConfig &problem = config.problem;
            if (problem.robotKind == RobotKind::Footprint)
            {
                return collision::RigidBody::sphere(footprint.reach() + footprint.margin());
            }
            if (problem.robotKind != RobotKind::File)
            {
                return collision::RigidBody::sphere(problem.robotRadius);
            }
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
            {
                throw InputError(config.file.string() +
                                 ": neither problem.world nor problem.volume.* bounds the problem; give one of them");
            }
            const fcl::AABBd box = world.bounds();
            for (unsigned int i = 0; i < dimension; ++i)
            {
                const double start = i == 0 ? problem.start.x : i == 1 ? problem.start.y : problem.start.z;
                const double goal = i == 0 ? problem.goal.x : i == 1 ? problem.goal.y : problem.goal.z;
                bounds.setLow(i, std::min({box.min_[i], start, goal}));
                bounds.setHigh(i, std::max({box.max_[i], start, goal}));
                if (bounds.low[i] >= bounds.high[i])
                {
                    throw InputError(config.file.string() + ": the world, start and goal are flat along " +
                                     std::string(1, "xyz"[i]) + "; give problem.volume.*");
                }
            }
            return bounds;
        }

        ob::RealVectorBounds boundsOf(const BenchmarkConfig &config, const collision::Scene &world)
        {
            return config.problem.volume ? givenBounds(*config.problem.volume, positionDimension(config.problem.space))
                                         : inferredBounds(config, world);
        }

        template <typename Sampler>
        std::shared_ptr<Sampler> allocateSampler(const ob::SpaceInformation *si, const ContextConfig &context)
        {
            auto sampler = std::make_shared<Sampler>(si);
            if (context.attempts)
            {
                sampler->setNrAttempts(*context.attempts);
            }
            return sampler;
        }

        template <typename Sampler>
        std::shared_ptr<Sampler> allocateNormalSampler(const ob::SpaceInformation *si, const ContextConfig &context)
        {
            auto sampler = allocateSampler<Sampler>(si, context);
            if (context.standardDeviation)
            {
                sampler->setStdDev(context.standardDeviation->value);
            }
            return sampler;
        }

        ob::ValidStateSamplerPtr makeSampler(const ob::SpaceInformation *si, const ContextConfig &context)
        {
            switch (context.sampler.value_or(SamplerKind::Uniform))
            {
                case SamplerKind::Uniform:
                    break;
                case SamplerKind::Gaussian:
                    return allocateNormalSampler<ob::GaussianValidStateSampler>(si, context);
                case SamplerKind::ObstacleBased:
                    return allocateSampler<ob::ObstacleBasedValidStateSampler>(si, context);
                case SamplerKind::MaxClearance:
                {
                    auto sampler = allocateSampler<ob::MaximizeClearanceValidStateSampler>(si, context);
                    if (context.improveAttempts)
                    {
                        sampler->setNrImproveAttempts(context.improveAttempts->value);
                    }
                    return sampler;
                }
                case SamplerKind::BridgeTest:
                    return allocateNormalSampler<ob::BridgeTestValidStateSampler>(si, context);
            }
            return allocateSampler<ob::UniformValidStateSampler>(si, context);
        }

        void setSampler(const ob::SpaceInformationPtr &si, const ContextConfig &context)
        {
            const SamplerKind kind = context.sampler.value_or(SamplerKind::Uniform);
            const std::string refusal = "the sampler '" + samplerName(kind) + "' has no such setting; ";
            if (context.standardDeviation && kind != SamplerKind::Gaussian && kind != SamplerKind::BridgeTest)
            {
                failAt(context.standardDeviation->entry, refusal + "gaussian and bridge_test have it");
            }
            if (context.improveAttempts && kind != SamplerKind::MaxClearance)
            {
                failAt(context.improveAttempts->entry, refusal + "max_clearance has it");
            }
            si->setValidStateSamplerAllocator([context](const ob::SpaceInformation *space)
                                              { return makeSampler(space, context); });
        }

        ContextConfig overridden(ContextConfig context, const ContextConfig &overrides)
        {
            const auto take = [](auto &value, const auto &other)
            {
                if (other)
                {
                    value = other;
                }
            };
            take(context.sampler, overrides.sampler);
            take(context.attempts, overrides.attempts);
            take(context.standardDeviation, overrides.standardDeviation);
            take(context.improveAttempts, overrides.improveAttempts);
            take(context.longestValidSegmentFraction, overrides.longestValidSegmentFraction);
            take(context.validSegmentCountFactor, overrides.validSegmentCountFactor);
            for (std::size_t i = 0; i < context.cellSizes.size(); ++i)
            {
                take(context.cellSizes[i], overrides.cellSizes[i]);
            }
            take(context.cellSizeFactor, overrides.cellSizeFactor);
            return context;
        }

        void setResolution(ob::StateSpace &space, const ContextConfig &context)
        {
            if (context.longestValidSegmentFraction)
            {
                space.setLongestValidSegmentFraction(*context.longestValidSegmentFraction);
            }
            if (context.validSegmentCountFactor)
            {
                space.setValidSegmentCountFactor(*context.validSegmentCountFactor);
            }
        }

        void setProjection(const ob::StateSpace &space, const ContextConfig &context)
        {
            const ob::ProjectionEvaluatorPtr projection = space.getDefaultProjection();
            for (unsigned int i = 0; i < context.cellSizes.size(); ++i)
            {
                const auto &size = context.cellSizes[i];
                if (size && i >= projection->getDimension())
                {
                    failAt(size->entry, "the projection of the space '" + space.getName() + "' has dimensions 0 to " +
                                            std::to_string(projection->getDimension() - 1));
                }
                if (size)
                {
                    projection->setCellSizes(i, size->value);
                }
            }
            if (context.cellSizeFactor)
            {
                projection->mulCellSizes(*context.cellSizeFactor);
            }
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

        void checkCollisions(const ob::SpaceInformationPtr &si, const ProblemConfig &problem,
                             const std::shared_ptr<const collision::Scene> &world, const collision::RigidBody &robot)
        {
            const auto checker = makeChecker(si, problem, world, robot);
            if (!problem.motionValidation)
            {
                collision::setCollisionChecking(si, checker, collision::MotionValidation::Discrete);
                return;
            }
            try
            {
                collision::setCollisionChecking(si, checker, problem.motionValidation->value);
            }
            catch (const InputError &error)
            {
                failAt(problem.motionValidation->entry, error.what());
            }
        }

        std::string describeBounds(const ob::RealVectorBounds &bounds)
        {
            constexpr int DIGITS = 6;
            std::string text;
            for (std::size_t i = 0; i < bounds.low.size(); ++i)
            {
                text += (i == 0 ? "[" : " x [") + text::numberText(bounds.low[i], DIGITS) + ", " +
                        text::numberText(bounds.high[i], DIGITS) + "]";
            }
            return text;
        }

        /* By how much a state collides, and a valid state nearby: a hint for slightly wrong coordinates, not for a
           state deep within an obstacle. */
        std::string describeCollision(const ob::SpaceInformation &si, StateSpaceKind kind, const ConfigPose &pose,
                                      const ob::RealVectorBounds &bounds)
        {
            constexpr double SMALL_PART = 0.01;
            constexpr int DIGITS = 4;
            double squaredSize = 0.0;
            for (const double length : bounds.getDifference())
            {
                squaredSize += length * length;
            }
            const auto nearby = findNearbyState(si, kind, pose, SMALL_PART * std::sqrt(squaredSize));
            return nearby ? " by " + text::numberText(nearby->distance, DIGITS) + "; a valid state nearby is " +
                                describePose(kind, nearby->pose)
                          : "";
        }

        void requireValid(const og::SimpleSetup &setup, const ob::ScopedState<> &state, const std::string &which,
                          const ConfigPose &pose, const ProblemConfig &problem, const ob::RealVectorBounds &bounds,
                          const maps::ObstacleGrid *map)
        {
            const std::string described = which + " " + describePose(problem.space, pose);
            if (!setup.getStateSpace()->satisfiesBounds(state.get()))
            {
                failAt(pose.origin, described + " is outside the bounds " + describeBounds(bounds));
            }
            if (!setup.getSpaceInformation()->isValid(state.get()))
            {
                const std::string cell = map != nullptr ? describeCell(*map, pose) : "";
                if (!cell.empty())
                {
                    failAt(pose.origin, described + " is " + cell);
                }
                failAt(pose.origin, described + " is in collision" +
                                        (problem.world ? " with the world '" + problem.world->value + "'" : "") +
                                        describeCollision(*setup.getSpaceInformation(), problem.space, pose, bounds));
            }
        }
    }  // namespace

    ProblemFactory::ProblemFactory(BenchmarkConfig config)
      : config_(std::move(config))
      , map_(loadMapOf(config_))
      , footprint_(map_ ? makeFootprint(config_.problem) : maps::Footprint::point())
      , problems_(map_ ? loadScenarioOf(config_, *map_) : std::vector<maps::ScenarioProblem>())
    {
        if (config_.problem.robotKind == RobotKind::Arm)
        {
            arm_ = loadArm(config_);
            world_ = {arm_, &arm_->robot().scene->world};
            return;
        }
        world_ = loadWorld(config_, map_ != nullptr);
        robot_ = loadRobotOf(config_, footprint_);
        if (!problems_.empty())
        {
            select(0);
        }
        bounds();
    }

    void ProblemFactory::select(std::size_t number)
    {
        const maps::ScenarioProblem &selected = problems_.at(number);
        const auto place = [&selected](ConfigPose &pose, const Eigen::Vector2d &position)
        {
            pose.x = position.x();
            pose.y = position.y();
            pose.origin = selected.origin;
        };
        place(config_.problem.start, selected.start);
        place(config_.problem.goal, selected.goal);
    }

    ProblemFactory ProblemFactory::onMap(std::shared_ptr<const maps::ObstacleGrid> grid) const
    {
        ProblemFactory factory = *this;
        factory.map_ = std::move(grid);
        return factory;
    }

    void ProblemFactory::setStartAndGoal(const ConfigPose &start, const ConfigPose &goal)
    {
        config_.problem.start = start;
        config_.problem.goal = goal;
    }

    ob::RealVectorBounds ProblemFactory::bounds() const
    {
        if (!map_ || config_.problem.volume)
        {
            return boundsOf(config_, *world_);
        }
        const Eigen::AlignedBox2d box = map_->map().bounds();
        ob::RealVectorBounds bounds(2);
        for (unsigned int i = 0; i < 2; ++i)
        {
            bounds.setLow(i, box.min()[i]);
            bounds.setHigh(i, box.max()[i]);
        }
        return bounds;
    }

    void ProblemFactory::setChecking(const ob::SpaceInformationPtr &si) const
    {
        const ProblemConfig &problem = config_.problem;
        if (!map_)
        {
            checkCollisions(si, problem, world_, *robot_);
            return;
        }
        maps::setMapChecking(si, map_, footprint_);
        if (problem.motionValidation && problem.motionValidation->value == collision::MotionValidation::Discrete)
        {
            si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
        }
    }

    og::SimpleSetupPtr ProblemFactory::createArm(const ContextConfig &context) const
    {
        const robots::JointSpace joints = arm_->makeSpace();
        setResolution(*joints.space(), context);
        auto setup = makeArmSetup(*arm_, joints, config_.problem, context);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        if (const auto objective = makeObjective(si, config_.problem))
        {
            setup->setOptimizationObjective(objective);
        }
        si->setup();
        setProjection(*joints.space(), context);
        setSampler(si, context);
        si->setup();
        arm_->setStartAndGoal(*setup, joints, config_.problem.threshold);
        return setup;
    }

    og::SimpleSetupPtr ProblemFactory::create(const ContextConfig &plannerContext) const
    {
        const ProblemConfig &problem = config_.problem;
        const ContextConfig context = overridden(problem.context, plannerContext);
        if (arm_)
        {
            return createArm(context);
        }
        const ob::RealVectorBounds positions = bounds();
        const ob::StateSpacePtr space = makeStateSpace(problem, positions);
        space->setName(spaceName(problem.space));
        setResolution(*space, context);

        auto setup = std::make_shared<og::SimpleSetup>(space);
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        setChecking(si);
        try
        {
            if (const auto objective = makeObjective(si, problem))
            {
                setup->setOptimizationObjective(objective);
            }
        }
        catch (const InputError &error)
        {
            failAt(problem.objectiveOrigin, error.what());
        }
        si->setup();
        setProjection(*space, context);
        setSampler(si, context);
        si->setup();

        const ob::ScopedState<> start = makeState(space, problem.space, problem.start);
        const ob::ScopedState<> goal = makeState(space, problem.space, problem.goal);
        requireValid(*setup, start, "start", problem.start, problem, positions, map_.get());
        requireValid(*setup, goal, "goal", problem.goal, problem, positions, map_.get());
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
        {
            throw InputError("seed = 0: expected a whole number from 1 to 4294967295");
        }
        ompl::RNG::setSeed(seed);
    }
}  // namespace ompl_mfa::benchmark
