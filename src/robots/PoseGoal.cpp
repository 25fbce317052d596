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

#include "robots/PoseGoal.h"

#include <chrono>
#include <thread>
#include <utility>

#include <ompl/util/Console.h>
#include <ompl/util/Time.h>

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    namespace
    {
        // A planner with many goals spends its time on them, so goals are few and apart: radians or metres.
        constexpr double SMALLEST_DISTANCE = 0.2;
        constexpr std::size_t MOST_GOALS = 64;
        constexpr double FIRST_SEARCH = 1.;

        class GoalStatesSampler
        {
        public:
            GoalStatesSampler(ob::SpaceInformationPtr si, JointSpace joints, const PlacedRobot &robot,
                              const std::vector<PoseTarget> &poses, std::vector<JointBox> boxes)
              : si_(std::move(si))
              , joints_(std::move(joints))
              , boxes_(std::move(boxes))
            {
                for (const PoseTarget &pose : poses)
                {
                    samplers_.emplace_back(robot, pose);
                }
            }

            // One attempt, for each goal in turn.
            bool attempt(ob::State *state)
            {
                const std::size_t goal = attempts_++ % (samplers_.size() + boxes_.size());
                if (goal < samplers_.size())
                {
                    if (!samplers_[goal].sample(values_))
                    {
                        return false;
                    }
                }
                else
                {
                    const JointBox &box = boxes_[goal - samplers_.size()];
                    values_ = box.preferred;
                    for (std::size_t i = 0; attempts_ > 2 * boxes_.size() && i < values_.size(); ++i)
                    {
                        values_[i] = random_.uniformReal(box.lower[i], box.upper[i]);
                    }
                }
                joints_.setState(values_.data(), state);
                return si_->isValid(state);
            }

        private:
            ob::SpaceInformationPtr si_;
            JointSpace joints_;
            std::vector<PoseSampler> samplers_;
            std::vector<JointBox> boxes_;
            std::vector<double> values_;
            std::size_t attempts_{0};
            ompl::RNG random_;
        };
    }  // namespace

    std::shared_ptr<ob::GoalLazySamples> makePoseGoal(const ob::SpaceInformationPtr &si, const JointSpace &joints,
                                                      const PlacedRobot &robot, const std::vector<PoseTarget> &poses,
                                                      std::vector<JointBox> boxes)
    {
        const auto sampler = std::make_shared<GoalStatesSampler>(si, joints, robot, poses, std::move(boxes));
        auto goal = std::make_shared<ob::GoalLazySamples>(
            si,
            [sampler, isFirst = true](const ob::GoalLazySamples *lazy, ob::State *state) mutable
            {
                if (std::exchange(isFirst, false) && lazy->hasStates())
                {
                    // A known state, which is not added again: OMPL warns of a thread that was stopped before it had
                    // any.
                    lazy->getSpaceInformation()->copyState(state, lazy->getState(0));
                    return true;
                }
                // Only successes are returned, as OMPL adds whatever state is valid.
                while (lazy->isSampling())
                {
                    if (sampler->attempt(state))
                    {
                        return lazy->getStateCount() < MOST_GOALS;
                    }
                }
                return false;
            },
            false, SMALLEST_DISTANCE);
        ob::State *state = si->allocState();
        const ompl::time::point end = ompl::time::now() + ompl::time::seconds(FIRST_SEARCH);
        while (!goal->hasStates() && ompl::time::now() < end)
        {
            if (sampler->attempt(state))
            {
                goal->addState(state);
            }
        }
        si->freeState(state);
        if (!goal->hasStates())
        {
            OMPL_WARN("no free state at the pose of the goal was found in %.0f s; sampling goes on", FIRST_SEARCH);
        }
        goal->startSampling();
        while (goal->hasStates() && goal->samplingAttemptsCount() == 0 && ompl::time::now() < end)
        {
            std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
        return goal;
    }
}  // namespace ompl_mfa::robots
