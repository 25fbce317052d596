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

#ifndef OMPL_MFA_ROBOTS_ROBOT_PROBLEM_
#define OMPL_MFA_ROBOTS_ROBOT_PROBLEM_

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/FclMotionValidator.h"
#include "ompl_mfa/robots/JointSpace.h"
#include "ompl_mfa/robots/MotionRequest.h"
#include "ompl_mfa/robots/RobotCollision.h"

namespace ompl_mfa::robots
{
    /** \brief The files and names that describe a problem for a robot arm. Only the robot is required. */
    struct RobotFiles
    {
        /** \brief URDF file. */
        std::filesystem::path robot;

        /** \brief SRDF file. */
        std::filesystem::path semantics;

        /** \brief `moveit_msgs/PlanningScene` as YAML; the world is empty without it. */
        std::filesystem::path scene;

        /** \brief `moveit_msgs/MotionPlanRequest` as YAML. */
        std::filesystem::path request;

        /** \brief Folders that are searched for meshes. */
        std::vector<std::filesystem::path> packages;

        /** \brief Group of joints that move; if empty, that of the request, or the only one, or all joints. */
        std::string group;

        /** \brief Start and goal in place of those of the request: the name of a group state, or one number for each
            joint of the group, separated by commas. */
        std::string start;
        std::string goal;

        /** \brief Factors for the distances of the group's joints; all 1 if empty. */
        std::vector<double> weights;

        /** \brief Added to the padding of each link, metres. */
        double padding{0.};
    };

    /** \brief A planning problem for a robot arm. Several setups may be made from one problem. */
    class OMPL_MFA_EXPORT RobotProblem
    {
    public:
        /** \brief Longest step between two states of a motion that are checked, in joint space: radians, or metres of
            prismatic joints. */
        static constexpr double DEFAULT_STEP = 1. / 32.;

        /** \brief Load the files.
            \throw InputError naming file and fault, as the loaders do; and for a scene or request of another robot, an
            unknown joint or group, a start or goal outside of the limits. */
        explicit RobotProblem(const RobotFiles &files);
        ~RobotProblem();
        RobotProblem(const RobotProblem &) = delete;
        RobotProblem &operator=(const RobotProblem &) = delete;

        const PlacedRobot &robot() const
        {
            return robot_;
        }

        /** \brief Name of the group; empty if all joints move. */
        const std::string &groupName() const
        {
            return groupName_;
        }

        const RobotCollision &collision() const
        {
            return *collision_;
        }

        /** \brief Factors for the limits of speed and acceleration, in (0, 1], from the request. */
        double velocityScale() const
        {
            return velocityScale_;
        }

        double accelerationScale() const
        {
            return accelerationScale_;
        }

        /** \brief A new state space of the group. OMPL's settings of a space are its own, so each setup needs one. */
        JointSpace makeSpace() const;

        /** \brief Set the checkers of states and motions. `joints` is the space of `si`. */
        void setChecks(const ompl::base::SpaceInformationPtr &si, const JointSpace &joints,
                       collision::MotionValidation validation) const;

        /** \brief Set start and goal, after `setup` was given the checkers.
            \param threshold distance at which a state counts as a goal state, in joint space.
            \throw InputError if start or goal is missing, or in collision: which pair, and how deep. Goals that are
           poses are sampled by inverse kinematics, in a thread that begins here; the planner runs until its time is
           over if they cannot be reached. */
        void setStartAndGoal(ompl::geometric::SimpleSetup &setup, const JointSpace &joints,
                             double threshold = 1e-6) const;

        /** \brief A problem that is ready for a planner: discrete checks of motions with steps of DEFAULT_STEP.
            \throw InputError as setStartAndGoal() does. */
        ompl::geometric::SimpleSetupPtr makeSetup() const;

    private:
        struct Goal;

        void chooseGroup(const RobotFiles &files, const MotionRequest &request);
        void readScene(const RobotFiles &files);
        void applyState(const collision::RobotState &state);
        void readStart(const RobotFiles &files, const MotionRequest &request);
        void readGoals(const RobotFiles &files, const MotionRequest &request);
        Goal goalOf(const RequestedGoal &requested) const;
        std::vector<double> stateOf(const std::string &text, const std::string &which) const;
        void bringWithinLimits(std::vector<double> &values, const std::string &which) const;
        void requireFree(const std::vector<double> &values, const std::string &which) const;

        PlacedRobot robot_;
        std::string groupName_;
        std::vector<double> weights_;
        std::vector<double> start_;
        std::string startPlace_;
        std::vector<Goal> goals_;
        std::string place_;
        double velocityScale_{1.};
        double accelerationScale_{1.};
        std::shared_ptr<const RobotCollision> collision_;
    };
}  // namespace ompl_mfa::robots

#endif
