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

/* Times of one validity check, one clearance and one motion in each kind of world, compared with plain FCL for the same
   objects at the same poses: fcl::collide and fcl::distance on placed objects, through FCL's broadphase if the world
   has several.

   micro_collision [--benchmark_filter=...]; OMPL_MFA_OMPLAPP_DIR names the folder of OMPL.app's problems, if any. */

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <benchmark/benchmark.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <ompl/base/DiscreteMotionValidator.h>

#include "CollisionWorlds.h"
#include "ompl_mfa/collision/FclMotionValidator.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        // Samples for all benchmarks of a world: uniform states, and motions over a fraction of the distance between
        // them.
        class Samples
        {
        public:
            Samples(const World &world, double motionShare)
              : space_(world.si->getStateSpace())
            {
                const ob::StateSamplerPtr sampler = space_->allocDefaultStateSampler();
                for (std::size_t i = 0; i < 2 * count; ++i)
                {
                    states_.push_back(space_->allocState());
                    sampler->sampleUniform(states_.back());
                }
                for (std::size_t i = 0; i < count && motionShare > 0.; ++i)
                {
                    space_->interpolate(states_[i], states_[count + i], motionShare, states_[count + i]);
                    space_->enforceBounds(states_[count + i]);
                }
            }

            ~Samples()
            {
                for (ob::State *state : states_)
                {
                    space_->freeState(state);
                }
            }

            Samples(const Samples &) = delete;
            Samples &operator=(const Samples &) = delete;

            const ob::State *state(std::size_t i) const
            {
                return states_[i % count];
            }

            const ob::State *motionEnd(std::size_t i) const
            {
                return states_[count + i % count];
            }

            static constexpr std::size_t count = 1024;

        private:
            ob::StateSpacePtr space_;
            std::vector<ob::State *> states_;
        };

        // The world as in a program that uses FCL only.
        class PlainFcl
        {
        public:
            explicit PlainFcl(const World &world)
              : robot_(world.checker->query().bodies().front().shapes().front().geometry)
            {
                for (const CollisionObject &object : world.scene->objects())
                {
                    objects_.push_back(std::make_unique<fcl::CollisionObjectd>(object.geometry, object.pose));
                    manager_.registerObject(objects_.back().get());
                }
                manager_.setup();
            }

            bool collide(const fcl::Transform3d &pose)
            {
                place(pose);
                if (objects_.size() == 1)
                {
                    fcl::CollisionResultd result;
                    return fcl::collide(objects_.front().get(), &robot_, fcl::CollisionRequestd(), result) > 0;
                }
                fcl::DefaultCollisionData<double> query;
                manager_.collide(&robot_, &query, fcl::DefaultCollisionFunction<double>);
                return query.result.isCollision();
            }

            double distance(const fcl::Transform3d &pose)
            {
                place(pose);
                if (objects_.size() == 1)
                {
                    fcl::DistanceResultd result;
                    return fcl::distance(objects_.front().get(), &robot_, fcl::DistanceRequestd(), result);
                }
                fcl::DefaultDistanceData<double> query;
                manager_.distance(&robot_, &query, fcl::DefaultDistanceFunction<double>);
                return query.result.min_distance;
            }

        private:
            void place(const fcl::Transform3d &pose)
            {
                robot_.setTransform(pose);
                robot_.computeAABB();
            }

            std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
            fcl::DynamicAABBTreeCollisionManager<double> manager_;
            fcl::CollisionObjectd robot_;
        };

        std::vector<fcl::Transform3d> placedStates(const World &world, const Samples &samples)
        {
            std::vector<fcl::Transform3d> poses(Samples::count);
            for (std::size_t i = 0; i < poses.size(); ++i)
            {
                world.checker->placement().place(samples.state(i), 0, poses[i]);
            }
            return poses;
        }

        void registerStates(const World &world, const std::shared_ptr<Samples> &samples)
        {
            const auto plain = std::make_shared<PlainFcl>(world);
            const auto poses = std::make_shared<std::vector<fcl::Transform3d>>(placedStates(world, *samples));
            benchmark::RegisterBenchmark(
                ("validity/" + world.name + "/fcl::collide").c_str(),
                [plain, poses](benchmark::State &run)
                {
                    std::size_t i = 0;
                    for ([[maybe_unused]] auto _ : run)
                    {
                        benchmark::DoNotOptimize(plain->collide((*poses)[i++ % Samples::count]));
                    }
                });
            benchmark::RegisterBenchmark(("validity/" + world.name + "/isValid").c_str(),
                                         [world, samples](benchmark::State &run)
                                         {
                                             std::size_t i = 0;
                                             for ([[maybe_unused]] auto _ : run)
                                             {
                                                 benchmark::DoNotOptimize(world.checker->isValid(samples->state(i++)));
                                             }
                                         });
            benchmark::RegisterBenchmark(
                ("clearance/" + world.name + "/fcl::distance").c_str(),
                [plain, poses](benchmark::State &run)
                {
                    std::size_t i = 0;
                    for ([[maybe_unused]] auto _ : run)
                    {
                        benchmark::DoNotOptimize(plain->distance((*poses)[i++ % Samples::count]));
                    }
                });
            benchmark::RegisterBenchmark(
                ("clearance/" + world.name + "/clearance").c_str(),
                [world, samples](benchmark::State &run)
                {
                    std::size_t i = 0;
                    for ([[maybe_unused]] auto _ : run)
                    {
                        benchmark::DoNotOptimize(world.checker->clearance(samples->state(i++)));
                    }
                });
        }

        // Motions that start at a valid state, as in planners.
        void registerMotions(const World &world, double share, double fraction)
        {
            const auto samples = std::make_shared<Samples>(world, share);
            const auto si = std::make_shared<ob::SpaceInformation>(world.si->getStateSpace());
            si->setStateValidityChecker(world.checker);
            si->setStateValidityCheckingResolution(fraction > 0. ? fraction : 0.01);
            std::shared_ptr<ob::MotionValidator> validator;
            std::string name = "continuous";
            if (fraction > 0.)
            {
                validator = std::make_shared<ob::DiscreteMotionValidator>(si);
                name = "discrete " + std::to_string(fraction).substr(0, 6);
            }
            else
            {
                validator = std::make_shared<FclMotionValidator>(si, world.checker);
            }
            benchmark::RegisterBenchmark(
                ("motion/" + world.name + "/" + std::to_string(share).substr(0, 4) + " of the space/" + name).c_str(),
                [world, samples, validator, si, fraction](benchmark::State &run)
                {
                    si->getStateSpace()->setLongestValidSegmentFraction(fraction > 0. ? fraction : 0.01);
                    si->getStateSpace()->setup();
                    std::vector<std::size_t> starts;
                    for (std::size_t i = 0; i < Samples::count; ++i)
                    {
                        if (world.checker->isValid(samples->state(i)))
                        {
                            starts.push_back(i);
                        }
                    }
                    std::size_t i = 0;
                    std::size_t valid = 0;
                    for ([[maybe_unused]] auto _ : run)
                    {
                        const std::size_t motion = starts[i++ % starts.size()];
                        valid += validator->checkMotion(samples->state(motion), samples->motionEnd(motion)) ? 1 : 0;
                    }
                    run.counters["valid"] = static_cast<double>(valid) / static_cast<double>(i);
                });
        }
    }  // namespace
}  // namespace ompl_mfa::collision

int main(int argc, char **argv)
{
    using namespace ompl_mfa::collision;
    benchmark::Initialize(&argc, argv);
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);
    const char *folder = std::getenv("OMPL_MFA_OMPLAPP_DIR");
    for (const World &world : makeWorlds(folder != nullptr ? folder : ""))
    {
        registerStates(world, std::make_shared<Samples>(world, 0.));
        for (const double share : {0.1, 0.5})
        {
            for (const double fraction : {0.01, 0.001, 0.})
            {
                registerMotions(world, share, fraction);
            }
        }
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
