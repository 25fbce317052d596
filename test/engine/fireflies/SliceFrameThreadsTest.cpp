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

/* One frame, read by several threads at once: const member functions may be called together, each thread with its own
   scratch. */

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/fireflies/SliceFrame.h"
#include "engine/fireflies/SliceModes.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        class SliceFrameThreads : public ::testing::Test
        {
        protected:
            static constexpr unsigned int THREADS = 4;
            static constexpr int REPEATS = 10000;

            SliceFrameThreads()
              : frame_(makeFrame())
              , modes_(frame_)
            {
                ompl::RNG rng(11);
                for (unsigned int i = 0; i < THREADS; ++i)
                {
                    Eigen::VectorXd x(frame_.dimension());
                    for (Eigen::Index k = 0; k < x.size(); ++k)
                    {
                        x[k] = rng.uniformReal(-0.5, 0.5);
                    }
                    coordinates_.push_back(x);
                    Eigen::VectorXd scratch;
                    path::Waypoints path(space_);
                    frame_.toWaypoints(x, path, scratch);
                    paths_.push_back(path);
                }
            }

            SliceFrame makeFrame() const
            {
                ob::ScopedState<ob::SE3StateSpace> start(space_);
                ob::ScopedState<ob::SE3StateSpace> goal(space_);
                start->setXYZ(-4.0, 0.0, 1.0);
                start->rotation().setIdentity();
                goal->setXYZ(4.0, 2.0, -1.0);
                goal->rotation().setAxisAngle(0.0, 0.0, 1.0, 1.0);
                return SliceFrame::straight(std::make_shared<const path::StateChart>(space_), start.get(), goal.get(),
                                            9);
            }

            bool samePath(const path::Waypoints &a, const path::Waypoints &b) const
            {
                bool same = a.size() == b.size();
                for (std::size_t i = 0; same && i < a.size(); ++i)
                {
                    same = space_->equalStates(a[i], b[i]);
                }
                return same;
            }

            /* How many answers of concurrent threads differ from those of a single thread. */
            static unsigned int differences(const std::function<bool(unsigned int)> &asAlone)
            {
                std::atomic<unsigned int> wrong{0};
                std::vector<std::thread> threads;
                for (unsigned int i = 0; i < THREADS; ++i)
                {
                    threads.emplace_back(
                        [&asAlone, &wrong, i]
                        {
                            for (int repeat = 0; repeat < REPEATS; ++repeat)
                            {
                                if (!asAlone(i))
                                {
                                    ++wrong;
                                }
                            }
                        });
                }
                for (auto &thread : threads)
                {
                    thread.join();
                }
                return wrong;
            }

            ob::StateSpacePtr space_ = test::se3Space();
            SliceFrame frame_;
            SliceModes modes_;
            std::vector<Eigen::VectorXd> coordinates_;
            std::vector<path::Waypoints> paths_;
        };

        TEST_F(SliceFrameThreads, WaypointsAreThoseOfTheirCoordinates)
        {
            EXPECT_EQ(differences(
                          [this](unsigned int i)
                          {
                              Eigen::VectorXd scratch;
                              path::Waypoints path(space_);
                              frame_.toWaypoints(coordinates_[i], path, scratch);
                              return samePath(path, paths_[i]);
                          }),
                      0U);
        }

        TEST_F(SliceFrameThreads, CoordinatesAreThoseOfTheirPath)
        {
            EXPECT_EQ(differences(
                          [this](unsigned int i)
                          {
                              Eigen::VectorXd x(frame_.dimension());
                              frame_.toCoordinates(paths_[i], x);
                              return (x - coordinates_[i]).norm() < 1e-6;
                          }),
                      0U);
        }

        TEST_F(SliceFrameThreads, CrossingsAreThoseOfTheirPath)
        {
            std::vector<path::Waypoints> alone(THREADS, path::Waypoints(space_));
            for (unsigned int i = 0; i < THREADS; ++i)
            {
                ASSERT_TRUE(frame_.crossings(paths_[i], alone[i]));
            }
            EXPECT_EQ(differences(
                          [&](unsigned int i)
                          {
                              path::Waypoints onSlices(space_);
                              return frame_.crossings(paths_[i], onSlices) && samePath(onSlices, alone[i]);
                          }),
                      0U);
        }

        TEST_F(SliceFrameThreads, ModesAreThoseOfTheirCoordinates)
        {
            std::vector<Eigen::VectorXd> alone(THREADS, Eigen::VectorXd(frame_.dimension()));
            for (unsigned int i = 0; i < THREADS; ++i)
            {
                modes_.toCoordinates(coordinates_[i], alone[i]);
            }
            EXPECT_EQ(differences(
                          [&](unsigned int i)
                          {
                              Eigen::VectorXd x(frame_.dimension());
                              modes_.toCoordinates(coordinates_[i], x);
                              return x == alone[i];
                          }),
                      0U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
