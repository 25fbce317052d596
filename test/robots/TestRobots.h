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

#ifndef OMPL_MFA_TEST_ROBOTS_TEST_ROBOTS_
#define OMPL_MFA_TEST_ROBOTS_TEST_ROBOTS_

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ompl_mfa/robots/RobotCollision.h"

namespace ompl_mfa::robots
{
    /** \brief A robot of the repository or of the shared folder of arms. */
    struct TestRobot
    {
        std::string name;
        std::filesystem::path folder;
        std::string group;

        std::filesystem::path urdf(bool spherized = false) const
        {
            return folder / (name + (spherized ? "_spherized.urdf" : ".urdf"));
        }

        std::filesystem::path srdf() const
        {
            return folder / (name + ".srdf");
        }
    };

    inline std::filesystem::path sharedArms()
    {
        const char *given = std::getenv("OMPL_MFA_ARMS_DIR");
        return given != nullptr ? given : std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "../shared/arms";
    }

    inline TestRobot picker()
    {
        return {"picker", std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks/arms/picker", "arm"};
    }

    /** \brief The robots of the shared folder; none if it is absent. */
    inline std::vector<TestRobot> sharedRobots()
    {
        std::vector<TestRobot> robots;
        for (const TestRobot &robot : {TestRobot{"panda", sharedArms() / "panda", "panda_arm"},
                                       TestRobot{"fetch", sharedArms() / "fetch", "arm_with_torso"}})
        {
            if (std::filesystem::exists(robot.urdf()))
            {
                robots.push_back(robot);
            }
        }
        return robots;
    }

    inline std::vector<TestRobot> allRobots()
    {
        std::vector<TestRobot> robots = sharedRobots();
        robots.insert(robots.begin(), picker());
        return robots;
    }

    /** \brief The robot with its default values in a scene. */
    inline PlacedRobot placed(
        const TestRobot &robot, bool spherized = false,
        std::shared_ptr<const collision::RobotScene> scene = std::make_shared<collision::RobotScene>(),
        const std::string &group = "")
    {
        PlacedRobot result;
        result.model = std::make_shared<RobotModel>(loadRobotModel(robot.urdf(spherized)));
        result.semantics = std::make_shared<RobotSemantics>(*result.model, robot.srdf());
        result.scene = std::move(scene);
        result.group = result.semantics->jointsOf(group.empty() ? robot.group : group);
        for (std::size_t i = 0; i < result.model->joints().size(); ++i)
        {
            result.values.push_back(result.model->defaultValue(i));
        }
        return result;
    }

    /** \brief Uniform values of a group's joints within their limits, of continuous joints within a turn. */
    class RandomJoints
    {
    public:
        explicit RandomJoints(const PlacedRobot &robot, unsigned int seed = 1)
          : random_(seed)
        {
            for (const std::size_t joint : robot.group)
            {
                const Joint &one = robot.model->joints()[joint];
                ranges_.emplace_back(std::max(one.lower, -M_PI), std::min(one.upper, M_PI));
            }
        }

        std::vector<double> next()
        {
            std::vector<double> values;
            for (auto &range : ranges_)
            {
                values.push_back(range(random_));
            }
            return values;
        }

    private:
        std::mt19937 random_;
        std::vector<std::uniform_real_distribution<double>> ranges_;
    };
}  // namespace ompl_mfa::robots

#endif
