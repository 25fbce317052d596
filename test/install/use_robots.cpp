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

#include <filesystem>
#include <fstream>
#include <memory>

#include <ompl_mfa/robots/RobotCollision.h>

namespace orb = ompl_mfa::robots;

/* A pendulum that reaches the floor, which it hits only if it hangs down. */
int main()
{
    const std::filesystem::path file = "pendulum.urdf";
    std::ofstream(file) << "<robot name='pendulum'><link name='base'/><link name='arm'><collision>"
                           "<origin xyz='0 0 -0.5'/><geometry><sphere radius='0.1'/></geometry></collision></link>"
                           "<joint name='pivot' type='revolute'><parent link='base'/><child link='arm'/>"
                           "<axis xyz='0 1 0'/><limit lower='-3' upper='3' velocity='1' effort='1'/></joint></robot>";
    orb::PlacedRobot robot;
    robot.model = std::make_shared<orb::RobotModel>(orb::loadRobotModel(file));
    robot.semantics = std::make_shared<orb::RobotSemantics>(*robot.model);
    const auto scene = std::make_shared<ompl_mfa::collision::RobotScene>();
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation().z() = -0.65;
    scene->world.add({"floor", robot.model->links()[1].shapes[0].geometry, pose});
    robot.scene = scene;
    robot.group = robot.semantics->jointsOf("");
    robot.values = {0.};
    const orb::RobotCollision collision(robot);
    const double down = 0.;
    const double level = 1.57;
    return collision.collides(&down) && !collision.collides(&level) ? 0 : 1;
}
