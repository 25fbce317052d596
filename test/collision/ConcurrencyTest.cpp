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

/* Queries from several threads, and allocations during a query. This program counts every allocation of the C++
   heap. */

#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "collision/RandomScenes.h"
#include "ompl_mfa/collision/FclMotionValidator.h"

// GCC mistakes these for the library's operators where it inlines them, and warns that they do not match.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace
{
    std::atomic<std::size_t> allocations{0};
}

void *operator new(std::size_t size)
{
    ++allocations;
    void *memory = std::malloc(size);
    if (memory == nullptr)
    {
        throw std::bad_alloc();
    }
    return memory;
}

void *operator new(std::size_t size, std::align_val_t alignment)
{
    ++allocations;
    const auto step = static_cast<std::size_t>(alignment);
    void *memory = std::aligned_alloc(step, (size + step - 1) / step * step);
    if (memory == nullptr)
    {
        throw std::bad_alloc();
    }
    return memory;
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}

namespace ompl_mfa::collision
{
    namespace
    {
        namespace ob = ompl::base;

        // Obstacles and robots of every kind; each query tests all pairs.
        struct Setting
        {
            explicit Setting(std::shared_ptr<fcl::CollisionGeometryd> robot, MeshInterior interior)
            {
                auto space = std::make_shared<ob::SE3StateSpace>();
                ob::RealVectorBounds bounds(3);
                bounds.setLow(-6.);
                bounds.setHigh(6.);
                space->setBounds(bounds);
                si = std::make_shared<ob::SpaceInformation>(space);
                Random random(1);
                Scene scene;
                for (const char *kind : {"sphere", "box", "cylinder", "cone", "capsule"})
                {
                    for (int i = 0; i < 8; ++i)
                    {
                        scene.add({kind, random.primitive(kind), random.pose(6.)});
                    }
                }
                for (int i = 0; i < 8; ++i)
                {
                    scene.add({"mesh", makeMeshGeometry(boxMesh({1., 1.5, 0.5})), random.pose(6.)});
                }
                scene.add({"map", occupancyMap({{0, 0, 0}, {1, 0, 0}, {-8, 4, 4}, {5, 5, 5}}, 0.5)});
                checker = std::make_shared<FclStateValidityChecker>(si, std::make_shared<Scene>(scene),
                                                                    RigidBody({{std::move(robot)}}), interior);
                si->setStateValidityChecker(checker);
                si->setup();
                validator = std::make_shared<FclMotionValidator>(si, checker);
                for (int i = 0; i < 120; ++i)
                {
                    states.push_back(si->allocState());
                }
                const ob::StateSamplerPtr sampler = si->allocStateSampler();
                for (ob::State *state : states)
                {
                    sampler->sampleUniform(state);
                }
            }

            ~Setting()
            {
                for (ob::State *state : states)
                {
                    si->freeState(state);
                }
            }

            Setting(const Setting &) = delete;
            Setting &operator=(const Setting &) = delete;

            // Every kind of query for every state. \param answers as many as there are states.
            void ask(std::vector<double> &answers) const
            {
                for (std::size_t i = 0; i < states.size(); ++i)
                {
                    answers[i] = checker->isValid(states[i]) ? 1. : 0.;
                    answers[i] += checker->clearance(states[i]);
                    const ob::State *next = states[(i + 1) % states.size()];
                    answers[i] += validator->checkMotion(states[i], next) ? 10. : 0.;
                    std::pair<ob::State *, double> lastValid(nullptr, 1.);
                    validator->checkMotion(states[i], next, lastValid);
                    answers[i] += 100. * lastValid.second;
                }
            }

            ob::SpaceInformationPtr si;
            std::shared_ptr<FclStateValidityChecker> checker;
            std::shared_ptr<FclMotionValidator> validator;
            std::vector<ob::State *> states;
        };

        std::vector<std::shared_ptr<fcl::CollisionGeometryd>> robots()
        {
            return {std::make_shared<fcl::Sphered>(0.4),        std::make_shared<fcl::Capsuled>(0.2, 0.8),
                    std::make_shared<fcl::Boxd>(0.5, 0.7, 0.9), std::make_shared<fcl::Cylinderd>(0.3, 1.),
                    std::make_shared<fcl::Coned>(0.4, 0.8),     makeMeshGeometry(boxMesh({0.5, 0.7, 0.9}))};
        }

        TEST(Concurrency, ThreadsGetTheAnswersOfOne)
        {
            for (const auto &robot : robots())
            {
                const Setting setting(robot, MeshInterior::Solid);
                std::vector<double> expected(setting.states.size());
                setting.ask(expected);
                std::vector<std::vector<double>> answers(4, std::vector<double>(setting.states.size()));
                std::vector<std::thread> threads;
                threads.reserve(answers.size());
                for (std::vector<double> &own : answers)
                {
                    threads.emplace_back([&setting, &own] { setting.ask(own); });
                }
                for (std::thread &thread : threads)
                {
                    thread.join();
                }
                for (const std::vector<double> &own : answers)
                {
                    EXPECT_EQ(own, expected);
                }
                const unsigned int asked =
                    setting.validator->getValidMotionCount() + setting.validator->getInvalidMotionCount();
                EXPECT_EQ(asked, 5U * 2U * setting.states.size());
            }
        }

        TEST(Concurrency, AQueryAllocatesNothing)
        {
            for (const MeshInterior interior : {MeshInterior::Free, MeshInterior::Solid})
            {
                for (const auto &robot : robots())
                {
                    const Setting setting(robot, interior);
                    std::vector<double> answers(setting.states.size());
                    setting.ask(answers);
                    const std::size_t before = allocations;
                    setting.ask(answers);
                    EXPECT_EQ(allocations - before, 0U) << "robot of FCL's node type " << robot->getNodeType();
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::collision
