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

#include "ompl_mfa/robots/RobotProblem.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/robots/RobotValidityChecker.h"
#include "robots/PoseGoal.h"
#include "robots/UnknownName.h"
#include "text/NumberText.h"

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    namespace
    {
        constexpr int DIGITS = 6;

        // Files have rounded numbers, such as a joint at pi and a limit of 3.14159. Radians or metres.
        constexpr double LIMIT_TOLERANCE = 1e-4;

        std::string outsideText(const Joint &joint, double value)
        {
            const auto number = [](double one) { return text::numberText(one, DIGITS); };
            return " is outside of the limits of the joint '" + joint.name + "': " + number(value) +
                   "; accepted is from " + number(joint.lower) + " to " + number(joint.upper);
        }
    }  // namespace

    struct RobotProblem::Goal
    {
        /** \brief Not used if there is a pose. */
        JointBox box;
        std::optional<PoseTarget> pose;
        std::string place;
    };

    RobotProblem::RobotProblem(const RobotFiles &files)
      : weights_(files.weights)
      , place_(files.robot.string())
    {
        const auto model = std::make_shared<RobotModel>(loadRobotModel(files.robot, files.packages));
        robot_.model = model;
        robot_.semantics = files.semantics.empty() ? std::make_shared<RobotSemantics>(*model)
                                                   : std::make_shared<RobotSemantics>(*model, files.semantics);
        robot_.padding = files.padding;
        const MotionRequest request = files.request.empty() ? MotionRequest() : loadMotionRequest(files.request);
        velocityScale_ = request.velocityScale;
        accelerationScale_ = request.accelerationScale;
        chooseGroup(files, request);
        readScene(files);
        applyState(request.start);
        readStart(files, request);
        readGoals(files, request);
        if (!weights_.empty() && weights_.size() != robot_.group.size())
        {
            throw InputError(place_ + ": " + std::to_string(weights_.size()) + " weights for the " +
                             std::to_string(robot_.group.size()) + " joints of the group");
        }
        makeSpace();
        collision_ = std::make_shared<RobotCollision>(robot_);
    }

    RobotProblem::~RobotProblem() = default;

    void RobotProblem::chooseGroup(const RobotFiles &files, const MotionRequest &request)
    {
        groupName_ = files.group.empty() ? request.group : files.group;
        const std::vector<std::string> &groups = robot_.semantics->groups();
        if (!request.group.empty() && request.group != groupName_)
        {
            throw InputError(request.file.string() + ": group_name = " + request.group +
                             ": the request is for another group than '" + groupName_ + "'");
        }
        if (groupName_.empty() && groups.size() > 1)
        {
            throw InputError(files.semantics.string() +
                             ": there are several groups; name one: " + unknownName("group", "", groups));
        }
        if (groupName_.empty() && groups.size() == 1)
        {
            groupName_ = groups.front();
        }
        try
        {
            robot_.group = robot_.semantics->jointsOf(groupName_);
        }
        catch (const InputError &error)
        {
            throw InputError((request.group.empty() ? "" : request.file.string() + ": group_name: ") + error.what());
        }
    }

    void RobotProblem::readScene(const RobotFiles &files)
    {
        const RobotModel &model = *robot_.model;
        robot_.values.resize(model.joints().size());
        for (std::size_t i = 0; i < robot_.values.size(); ++i)
        {
            robot_.values[i] = model.defaultValue(i);
        }
        for (const GroupState &state : robot_.semantics->states())
        {
            for (const auto &[joint, value] : state.values)
            {
                robot_.values[joint] = state.name == "default" ? value : robot_.values[joint];
            }
        }
        if (files.scene.empty())
        {
            robot_.scene = std::make_shared<collision::RobotScene>();
            return;
        }
        bool isApplied = false;
        const collision::RobotFrames frames = [&](const std::string &frame, const collision::RobotState &state)
        {
            if (!isApplied)
            {
                applyState(state);
                isApplied = true;
            }
            const auto link = model.findLink(frame);
            return !link ? std::nullopt : std::make_optional(robot_.base * model.linkPoses(robot_.values)[*link]);
        };
        const auto scene =
            std::make_shared<collision::RobotScene>(collision::loadRobotScene(files.scene, frames, files.packages));
        if (!scene->robotName.empty() && scene->robotName != model.name())
        {
            throw InputError(files.scene.string() + ": robot_model_name = " + scene->robotName +
                             ": the scene is of another robot than '" + model.name() + "'");
        }
        applyState(scene->state);
        robot_.scene = scene;
    }

    void RobotProblem::applyState(const collision::RobotState &state)
    {
        std::string unknown;
        bool someAreKnown = state.joints.empty();
        for (const auto &[name, value] : state.joints)
        {
            const auto joint = robot_.model->findJoint(name);
            if (joint)
            {
                robot_.values[*joint] = value;
                someAreKnown = true;
            }
            else if (name != robot_.semantics->virtualJoint())
            {
                unknown += (unknown.empty() ? "" : ", ") + name;
            }
        }
        if (!someAreKnown)
        {
            throw InputError(state.place + ": the state is of another robot than '" + robot_.model->name() +
                             "', which has none of its joints: " + unknown);
        }
        if (!unknown.empty())
        {
            // Robots are often simplified: joints of wheels and sensors are left out.
            OMPL_INFORM("%s: joints that the robot does not have are ignored: %s", state.place.c_str(),
                        unknown.c_str());
        }
        const auto base = state.bases.find(robot_.semantics->virtualJoint());
        if (base != state.bases.end())
        {
            robot_.base = base->second;
        }
    }

    void RobotProblem::readStart(const RobotFiles &files, const MotionRequest &request)
    {
        for (const std::size_t joint : robot_.group)
        {
            start_.push_back(robot_.values[joint]);
        }
        startPlace_ = !request.start.place.empty() ? request.start.place
                      : !files.scene.empty()       ? files.scene.string()
                                                   : place_;
        if (!files.start.empty())
        {
            start_ = stateOf(files.start, "start");
            startPlace_ = "start = " + files.start;
        }
        bringWithinLimits(start_, startPlace_ + ": the start");
    }

    void RobotProblem::readGoals(const RobotFiles &files, const MotionRequest &request)
    {
        if (!files.goal.empty())
        {
            const std::string place = "goal = " + files.goal;
            std::vector<double> values = stateOf(files.goal, "goal");
            bringWithinLimits(values, place + ": the goal");
            goals_.push_back({{values, values, values}, std::nullopt, place});
            return;
        }
        for (const RequestedGoal &goal : request.goals)
        {
            goals_.push_back(goalOf(goal));
        }
    }

    std::vector<double> RobotProblem::stateOf(const std::string &text, const std::string &which) const
    {
        std::vector<double> values;
        std::istringstream list(text);
        bool areNumbers = true;
        for (std::string part; areNumbers && std::getline(list, part, ',');)
        {
            double value = 0.;
            areNumbers = text::readNumber(trimmed(part), value) && std::isfinite(value);
            values.push_back(value);
        }
        if (areNumbers)
        {
            if (values.size() != robot_.group.size())
            {
                throw InputError(which + " = " + text + ": " + std::to_string(values.size()) + " values for the " +
                                 std::to_string(robot_.group.size()) + " joints of the group");
            }
            return values;
        }
        const GroupState &state = robot_.semantics->state(groupName_, text);
        values.clear();
        for (const std::size_t joint : robot_.group)
        {
            const auto value = state.values.find(joint);
            values.push_back(value == state.values.end() ? robot_.values[joint] : value->second);
        }
        return values;
    }

    void RobotProblem::bringWithinLimits(std::vector<double> &values, const std::string &which) const
    {
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            const Joint &joint = robot_.model->joints()[robot_.group[i]];
            if (values[i] < joint.lower - LIMIT_TOLERANCE || values[i] > joint.upper + LIMIT_TOLERANCE)
            {
                throw InputError(which + outsideText(joint, values[i]));
            }
            values[i] = std::clamp(values[i], joint.lower, joint.upper);
        }
    }

    RobotProblem::Goal RobotProblem::goalOf(const RequestedGoal &requested) const
    {
        Goal goal;
        goal.place = requested.place;
        if (requested.pose)
        {
            // Finds faults.
            static_cast<void>(PoseSampler(robot_, *requested.pose));
            goal.pose = requested.pose;
            return goal;
        }
        std::vector<const JointTarget *> targets(robot_.group.size(), nullptr);
        for (const JointTarget &target : requested.joints)
        {
            const auto joint = robot_.model->findJoint(target.joint);
            const auto found = joint ? std::find(robot_.group.begin(), robot_.group.end(), *joint) : robot_.group.end();
            if (found == robot_.group.end())
            {
                std::vector<std::string> names;
                for (const std::size_t one : robot_.group)
                {
                    names.push_back(robot_.model->joints()[one].name);
                }
                throw InputError(target.place +
                                 ": goal_constraints: " + unknownName("joint of the group", target.joint, names));
            }
            targets[static_cast<std::size_t>(found - robot_.group.begin())] = &target;
        }
        for (std::size_t i = 0; i < targets.size(); ++i)
        {
            // A joint without a constraint may have any value.
            const Joint &joint = robot_.model->joints()[robot_.group[i]];
            const double position = targets[i] != nullptr ? targets[i]->position : start_[i];
            const double lower = targets[i] != nullptr ? position - targets[i]->below : std::max(joint.lower, -M_PI);
            const double upper = targets[i] != nullptr ? position + targets[i]->above : std::min(joint.upper, M_PI);
            if (upper < joint.lower - LIMIT_TOLERANCE || lower > joint.upper + LIMIT_TOLERANCE)
            {
                throw InputError(targets[i]->place + ": the goal" + outsideText(joint, position));
            }
            goal.box.lower.push_back(std::clamp(lower, joint.lower, joint.upper));
            goal.box.upper.push_back(std::clamp(upper, joint.lower, joint.upper));
            goal.box.preferred.push_back(std::clamp(position, goal.box.lower.back(), goal.box.upper.back()));
        }
        return goal;
    }

    JointSpace RobotProblem::makeSpace() const
    {
        return JointSpace(*robot_.model, robot_.group, weights_);
    }

    void RobotProblem::setChecks(const ob::SpaceInformationPtr &si, const JointSpace &joints,
                                 collision::MotionValidation validation) const
    {
        const auto checker = std::make_shared<RobotValidityChecker>(si, joints, collision_);
        si->setStateValidityChecker(checker);
        if (validation == collision::MotionValidation::Continuous)
        {
            si->setMotionValidator(std::make_shared<RobotMotionValidator>(si, checker));
        }
        else
        {
            si->setMotionValidator(std::make_shared<RobotDiscreteValidator>(si, checker));
        }
    }

    void RobotProblem::requireFree(const std::vector<double> &values, const std::string &which) const
    {
        const std::vector<RobotContact> contacts = collision_->contacts(values.data());
        if (contacts.empty())
        {
            return;
        }
        const RobotContact &deepest =
            *std::max_element(contacts.begin(), contacts.end(),
                              [](const RobotContact &a, const RobotContact &b) { return a.depth < b.depth; });
        throw InputError(which + " is in collision: '" + deepest.first + "' with '" + deepest.second +
                         "', by at most " + text::numberText(deepest.depth, 3) + " m" +
                         (contacts.size() == 1 ? ""
                                               : ", and " + std::to_string(contacts.size() - 1) +
                                                     (contacts.size() == 2 ? " further pair" : " further pairs")));
    }

    void RobotProblem::setStartAndGoal(ompl::geometric::SimpleSetup &setup, const JointSpace &joints,
                                       double threshold) const
    {
        if (goals_.empty())
        {
            throw InputError(place_ +
                             ": there is no goal; give a request with goal_constraints or the name of a state");
        }
        requireFree(start_, startPlace_ + ": the start");
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        ob::ScopedState<> state(joints.space());
        joints.setState(start_.data(), state.get());
        setup.setStartState(state);

        std::vector<JointBox> boxes;
        std::vector<PoseTarget> poses;
        for (const Goal &goal : goals_)
        {
            if (goal.pose)
            {
                poses.push_back(*goal.pose);
            }
            else if (!goal.box.isPoint() || !collision_->collides(goal.box.preferred.data()))
            {
                boxes.push_back(goal.box);
            }
        }
        if (!poses.empty())
        {
            const auto goal = makePoseGoal(si, joints, robot_, poses, std::move(boxes));
            goal->setThreshold(threshold);
            setup.setGoal(goal);
            return;
        }
        if (boxes.empty())
        {
            requireFree(goals_.front().box.preferred, goals_.front().place + ": the goal");
        }
        if (boxes.size() == 1 && boxes.front().isPoint())
        {
            joints.setState(boxes.front().preferred.data(), state.get());
            setup.setGoalState(state, threshold);
            return;
        }
        const auto goal = std::make_shared<JointGoal>(si, joints, std::move(boxes));
        goal->setThreshold(threshold);
        setup.setGoal(goal);
    }

    ompl::geometric::SimpleSetupPtr RobotProblem::makeSetup() const
    {
        const JointSpace joints = makeSpace();
        auto setup = std::make_shared<ompl::geometric::SimpleSetup>(joints.space());
        joints.space()->setLongestValidSegmentFraction(
            std::min(0.5, DEFAULT_STEP / joints.space()->getMaximumExtent()));
        setChecks(setup->getSpaceInformation(), joints, collision::MotionValidation::Discrete);
        setup->getSpaceInformation()->setup();
        setStartAndGoal(*setup, joints);
        return setup;
    }
}  // namespace ompl_mfa::robots
