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

#include "drive/Drive.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <ompl/base/ScopedState.h>

#include "benchmark/NoWarnings.h"
#include "drive/Clock.h"
#include "drive/Replanner.h"
#include "drive/Route.h"
#include "drive/Stepping.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/maps/MapFile.h"
#include "ompl_mfa/planner/MFA.h"

namespace ompl_mfa::drive
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        std::shared_ptr<const maps::ObstacleGrid> unowned(const maps::ObstacleGrid *grid)
        {
            return {std::shared_ptr<const maps::ObstacleGrid>(), grid};
        }

        maps::GridMap loadAt(const benchmark::ConfigEntry &entry, const std::filesystem::path &file)
        {
            try
            {
                return maps::loadMap(file);
            }
            catch (const InputError &error)
            {
                benchmark::failAt(entry, error.what());
            }
        }

        /* A drive as it goes on. */
        class DriveRun
        {
        public:
            DriveRun(const benchmark::ProblemFactory &factory, const std::optional<maps::GridMap> &known,
                     const benchmark::PlannerSpec &spec, bool isRecorded)
              : settings_(factory.config().problem.drive)
              , isRecorded_(isRecorded)
              , world_(unowned(factory.map()), known, factory.footprint(), settings_.range, settings_.rays)
            {
                // the robot can stand at start and goal
                const benchmark::ProblemConfig &problem = factory.config().problem;
                for (const benchmark::ConfigPose &pose : {problem.start, problem.goal})
                {
                    world_.learn(world_.felt({{pose.x, pose.y}, pose.theta}));
                }
                planner_.emplace(factory.onMap(world_.grid()), spec);
                stepping_.emplace(planner_->spaceInformation(), world_, factory.footprint(), problem.turningRadius);
                state_ = std::make_unique<ob::ScopedState<>>(planner_->spaceInformation());
                next_ = std::make_unique<ob::ScopedState<>>(planner_->spaceInformation());
                *state_ = planner_->start();
                result_.trail.push_back(stepping_->pose(state_->get()));
            }

            DriveResult run()
            {
                double planless = 0.0;
                while (true)
                {
                    const double spent = plan();
                    planless = route_ ? 0.0 : planless + spent;
                    if (isOver(planless))
                    {
                        break;
                    }
                    const double most = settings_.speed * settings_.period;
                    const double distance = route_ ? advance(most) : 0.0;
                    const bool hasArrived = route_ && route_->driven() >= route_->length();
                    result_.driven += distance;
                    result_.duration += hasArrived ? distance / settings_.speed : settings_.period;
                    if (hasArrived)
                    {
                        result_.status = DriveStatus::Arrived;
                        break;
                    }
                    if (result_.status == DriveStatus::Collision)
                    {
                        break;
                    }
                }
                if (isRecorded_)
                {
                    result_.frames.push_back({world_.takeNews(), {}, {}, result_.trail.size() - 1});
                }
                return std::move(result_);
            }

        private:
            bool isOver(double planless)
            {
                if (planless >= settings_.patience)
                {
                    result_.status = DriveStatus::NoPath;
                    return true;
                }
                return result_.duration >= settings_.timeLimit;
            }

            /* Scans, learns and plans. Returns the seconds of it, without the scan. */
            double plan()
            {
                const auto seen = world_.scanned(result_.trail.back().position);
                const Clock::time_point begin = Clock::now();
                hasChanged_ = world_.learn(seen) || hasChanged_;
                const bool wasBlocked =
                    route_ && (std::exchange(isStopped_, false) || (hasChanged_ && !stepping_->isRestValid(*route_)));
                if (wasBlocked)
                {
                    ++result_.blockages;
                    route_.reset();
                }
                isWaiting_ = isWaiting_ || wasBlocked;
                const bool wasValid = route_.has_value();
                const double before = secondsSince(begin);
                const Answer answer =
                    planner_->plan(state_->get(), std::exchange(hasChanged_, false), settings_.replanTime);
                take(answer);
                if (isWaiting_)
                {
                    waited_ += before + (route_ ? answer.firstTime : answer.time);
                    if (route_)
                    {
                        result_.repairTimes.push_back(std::exchange(waited_, 0.0));
                        isWaiting_ = false;
                    }
                }
                constexpr double NEVER = std::numeric_limits<double>::infinity();
                result_.periods.push_back({result_.duration, result_.trail.back(), result_.driven, seen.size(),
                                           wasBlocked,
                                           wasValid ? 0.0
                                           : route_ ? before + answer.firstTime
                                                    : NEVER,
                                           route_ ? route_->length() - route_->driven() : NEVER});
                record();
                return before + answer.time;
            }

            void take(const Answer &answer)
            {
                constexpr double GAIN = 1e-9;
                if (!answer.path || !answer.path->check())
                {
                    return;
                }
                if (!route_)
                {
                    route_.emplace(*answer.path);
                    return;
                }
                const double cost = planner_->cost(route_->rest());
                if (planner_->cost(*answer.path) < cost - GAIN * std::abs(cost))
                {
                    route_.emplace(*answer.path);
                    ++result_.improvements;
                }
            }

            /* Moves next_ to \e distance on the route. Returns whether the robot may go there by what is known. */
            bool tryStep(double distance, bool isLong)
            {
                route_->stateAt(distance, next_->get());
                return isLong ? stepping_->isKnownFree(state_->get(), next_->get())
                              : stepping_->isKnownFree(next_->get());
            }

            /* The end of the next step towards \e end, to which next_ is moved; none if what is known forbids it. Short
               steps are for robots that turn close to obstacles. */
            std::optional<double> step(double end)
            {
                double to = std::min({route_->driven() + stepping_->longStep(), route_->endOfMotion(), end});
                bool isLong = true;
                if (!tryStep(to, true))
                {
                    isLong = false;
                    to = std::min(to, route_->driven() + stepping_->shortStep());
                    if (!stepping_->turns() || !tryStep(to, false))
                    {
                        return std::nullopt;
                    }
                }
                const bool isFree =
                    isLong ? stepping_->isTrulyFree(state_->get(), next_->get()) : stepping_->isTrulyFree(next_->get());
                if (!isFree)
                {
                    result_.status = DriveStatus::Collision;
                    return std::nullopt;
                }
                return to;
            }

            /* Drives on for \e most, or to the end of the route, or to where what is known, or what is felt on the way,
               does not let it go on. Returns how far. */
            double advance(double most)
            {
                const double begin = route_->driven();
                const double end = std::min(begin + most, route_->length());
                while (route_->driven() < end)
                {
                    const std::optional<double> to = step(end);
                    if (!to)
                    {
                        isStopped_ = true;
                        break;
                    }
                    std::swap(state_, next_);
                    route_->setDriven(*to);
                    const Pose pose = stepping_->pose(state_->get());
                    result_.trail.push_back(pose);
                    hasChanged_ = world_.learn(world_.felt(pose)) || hasChanged_;
                }
                return route_->driven() - begin;
            }

            DriveFrame::Line lineOf(const og::PathGeometric &path) const
            {
                og::PathGeometric fine = path;
                if (stepping_->isCurved())
                {
                    constexpr double SPACING = 8.0;
                    constexpr double MOST = 400.0;
                    const double step = stepping_->longStep();
                    fine.interpolate(static_cast<unsigned int>(
                        std::clamp(fine.length() / (SPACING * step), static_cast<double>(fine.getStateCount()), MOST)));
                }
                DriveFrame::Line line;
                for (const ob::State *state : fine.getStates())
                {
                    line.push_back(stepping_->pose(state).position);
                }
                return line;
            }

            void record()
            {
                constexpr std::size_t MOST_FIREFLIES = 10;
                if (!isRecorded_)
                {
                    return;
                }
                DriveFrame frame{world_.takeNews(), {}, {}, result_.trail.size() - 1};
                if (route_)
                {
                    frame.path = lineOf(route_->rest());
                }
                for (const auto &path : planner_->swarm(MOST_FIREFLIES))
                {
                    frame.swarm.push_back(lineOf(path));
                }
                result_.frames.push_back(std::move(frame));
            }

            benchmark::DriveConfig settings_;
            bool isRecorded_;
            KnownWorld world_;
            // made when start and goal are known to be free
            std::optional<Replanner> planner_;
            std::optional<Stepping> stepping_;
            std::unique_ptr<ob::ScopedState<>> state_;
            std::unique_ptr<ob::ScopedState<>> next_;
            std::optional<Route> route_;
            /* Whether validity has changed since the planner was asked last. */
            bool hasChanged_{false};
            /* Whether the next step on the route is not valid. */
            bool isStopped_{false};
            /* Whether a blocked route was not replaced yet, and the seconds spent on this. */
            bool isWaiting_{false};
            double waited_{0.0};
            DriveResult result_;
        };
    }  // namespace

    std::string statusText(DriveStatus status)
    {
        switch (status)
        {
            case DriveStatus::Arrived:
                return "arrived";
            case DriveStatus::NoPath:
                return "no path";
            case DriveStatus::TimeOut:
                return "time out";
            case DriveStatus::Collision:
                break;
        }
        return "collision";
    }

    std::optional<maps::GridMap> loadKnownMap(const benchmark::ProblemFactory &factory)
    {
        const auto &entry = factory.config().problem.drive.knownMap;
        if (!entry)
        {
            return std::nullopt;
        }
        const std::filesystem::path file = benchmark::findResource(factory.config(), *entry);
        if (!maps::isMapFile(file))
        {
            benchmark::failAt(*entry, "expected a map (.yaml of map_server, .map)");
        }
        const maps::GridMap known = loadAt(*entry, file);
        const maps::GridMap &map = factory.map()->map();
        if (known.width() != map.width() || known.height() != map.height())
        {
            benchmark::failAt(*entry, "it has " + std::to_string(known.width()) + " x " +
                                          std::to_string(known.height()) + " cells, the world " +
                                          std::to_string(map.width()) + " x " + std::to_string(map.height()));
        }
        if (known.frame().resolution != map.frame().resolution || known.frame().origin != map.frame().origin ||
            known.frame().yaw != map.frame().yaw || known.frame().yDown != map.frame().yDown)
        {
            benchmark::failAt(*entry, "its resolution and origin are not those of the world");
        }
        return known;
    }

    DriveResult drive(const benchmark::ProblemFactory &factory, const std::optional<maps::GridMap> &known,
                      const benchmark::PlannerSpec &spec, bool isRecorded)
    {
        const benchmark::NoWarnings noWarnings;
        // throws if the robot cannot be at start or goal
        factory.create();
        return DriveRun(factory, known, spec, isRecorded).run();
    }

    double omniscientLength(const benchmark::ProblemFactory &factory, double seconds)
    {
        const benchmark::NoWarnings noWarnings;
        const og::SimpleSetupPtr setup = factory.create();
        setup->setPlanner(std::make_shared<MFA>(setup->getSpaceInformation()));
        setup->solve(seconds);
        return setup->haveExactSolutionPath() ? setup->getSolutionPath().length()
                                              : std::numeric_limits<double>::infinity();
    }
}  // namespace ompl_mfa::drive
