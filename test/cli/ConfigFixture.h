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

#ifndef OMPL_MFA_TEST_CLI_CONFIG_FIXTURE_
#define OMPL_MFA_TEST_CLI_CONFIG_FIXTURE_

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "cli/RunProgram.h"

/** \brief A separate folder with a world of one wall and a config that plans around it. */
class ConfigFixture : public testing::Test
{
protected:
    ConfigFixture()
      : folder_(std::filesystem::temp_directory_path() / ("ompl_mfa_cli_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
        write("wall.yaml",
              "world:\n  collision_objects:\n    - id: wall\n"
              "      primitives: [{type: box, dimensions: [1.0, 4.0, 1.0]}]\n"
              "      primitive_poses: [{position: [5.0, 3.0, 0.0], orientation: [0, 0, 0, 1]}]\n");
    }

    ~ConfigFixture() override
    {
        std::filesystem::remove_all(folder_);
    }

    std::string path(const std::string &name) const
    {
        return (folder_ / name).string();
    }

    void write(const std::string &name, const std::string &text) const
    {
        std::ofstream(folder_ / name) << text;
    }

    /** \brief Writes a.cfg: 10 m x 10 m, a disc of radius 0.5, the shortest path 9.6435 m long; returns its path. */
    std::string config(const std::string &start = "start.x = 1\nstart.y = 3\n", const std::string &planners = "",
                       const std::string &world = "world = wall.yaml\n") const
    {
        write("a.cfg",
              "[problem]\n" + world + "robot = disc\nrobot.radius = 0.5\n" + start +
                  "goal.x = 9\ngoal.y = 3\nvolume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 10\n"
                  "volume.max.y = 10\nobjective = length\n[benchmark]\ntime_limit = 0.5\nseed = 5\n[planner]\n" +
                  planners);
        return path("a.cfg");
    }

    std::filesystem::path folder_;
};

#endif
