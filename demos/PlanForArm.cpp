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

#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include <ompl_mfa/planner/MFA.h>
#include <ompl_mfa/robots/JointTrajectory.h>
#include <ompl_mfa/robots/RobotProblem.h>

/* Plans for a robot arm from its description and MoveIt's scene and request, and writes the trajectory.
   Usage: demo_plan_for_arm [ROBOT.urdf ROBOT.srdf SCENE.yaml REQUEST.yaml]; without files, for the arm in benchmarks/.
 */
int main(int argc, char **argv)
{
    const std::string arms = OMPL_MFA_ARMS;
    ompl_mfa::robots::RobotFiles files;
    files.robot = argc == 5 ? argv[1] : arms + "/picker/picker.urdf";
    files.semantics = argc == 5 ? argv[2] : arms + "/picker/picker.srdf";
    files.scene = argc == 5 ? argv[3] : arms + "/problems/scene0001.yaml";
    files.request = argc == 5 ? argv[4] : arms + "/problems/request0001.yaml";
    const ompl_mfa::robots::RobotProblem problem(files);

    const ompl::geometric::SimpleSetupPtr setup = problem.makeSetup();
    setup->setPlanner(std::make_shared<ompl_mfa::MFA>(setup->getSpaceInformation()));
    if (setup->solve(1.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
    {
        return 1;
    }
    const auto trajectory = ompl_mfa::robots::timedPath(problem, setup->getSolutionPath());
    std::cout << "length " << setup->getSolutionPath().length() << ", " << trajectory.duration() << " s\n";
    std::ofstream file("trajectory.csv");
    writeCsv(trajectory, file);
    return file ? 0 : 1;
}
