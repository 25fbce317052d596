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

#include "ompl_mfa/robots/RobotValidityChecker.h"

#include <fcl/geometry/shape/box.h>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "collision/TestFiles.h"
#include "robots/TestRobots.h"

namespace ob = ompl::base;

namespace ompl_mfa::robots
{
    namespace
    {
        std::vector<double> valuesOf(const JointSpace &joints, const ob::State *state)
        {
            std::vector<double> buffer(joints.dimension());
            const double *values = joints.values(state, buffer.data());
            return {values, values + joints.dimension()};
        }

        TEST(JointSpace, IsAVectorSpaceWithoutContinuousJoints)
        {
            const PlacedRobot robot = placed(picker());
            const JointSpace joints(*robot.model, robot.group);
            const auto *space = dynamic_cast<const ob::RealVectorStateSpace *>(joints.space().get());
            ASSERT_NE(space, nullptr);
            EXPECT_EQ(space->getDimension(), 5U);
            EXPECT_EQ(space->getBounds().low[1], -2.7);
            EXPECT_EQ(joints.names(), (std::vector<std::string>{"lift", "turn", "shoulder", "elbow", "wrist"}));
        }

        TEST(JointSpace, ContinuousJointsTurnTheShorterWayRound)
        {
            const PlacedRobot robot =
                placed(picker(), false, std::make_shared<collision::RobotScene>(), "arm_and_roll");
            const JointSpace joints(*robot.model, robot.group);
            joints.space()->setup();
            joints.space()->sanityChecks();
            ob::ScopedState<> a(joints.space());
            ob::ScopedState<> b(joints.space());
            const std::vector<double> from{0.1, 0., 0., 0., 0., 3.};
            const std::vector<double> to{0.4, 0., 0., 0., 0.4, -3. + 4. * M_PI};
            joints.setState(from.data(), a.get());
            joints.setState(to.data(), b.get());
            const double turn = 2. * M_PI - 6.;
            EXPECT_NEAR(joints.space()->distance(a.get(), b.get()), std::sqrt(0.09 + 0.16 + turn * turn), 1e-12);
            std::vector<double> difference(6);
            joints.difference(a.get(), b.get(), difference.data());
            EXPECT_NEAR(difference[5], turn, 1e-12);
            EXPECT_NEAR(difference[0], 0.3, 1e-12);
            EXPECT_NEAR(valuesOf(joints, b.get())[5], -3., 1e-12);
        }

        TEST(JointSpace, WeightsScaleTheDistance)
        {
            const PlacedRobot robot = placed(picker());
            const JointSpace joints(*robot.model, robot.group, {10., 1., 1., 1., 1.});
            ob::ScopedState<> a(joints.space());
            ob::ScopedState<> b(joints.space());
            const std::vector<double> from{0.1, 0., 0., 0., 0.};
            const std::vector<double> to{0.4, 4. - 2., 0., 0., 0.};
            joints.setState(from.data(), a.get());
            joints.setState(to.data(), b.get());
            EXPECT_NEAR(joints.space()->distance(a.get(), b.get()), std::sqrt(9. + 4.), 1e-12);
            EXPECT_THROW(JointSpace(*robot.model, robot.group, {1.}), std::invalid_argument);
            EXPECT_THROW(JointSpace(*robot.model, robot.group, {0., 1., 1., 1., 1.}), std::invalid_argument);
        }

        class RobotValidityCheckerTest : public ::testing::TestWithParam<const char *>
        {
        protected:
            void SetUp() override
            {
                const auto scene = std::make_shared<collision::RobotScene>();
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() = fcl::Vector3d(0.6, 0., 0.5);
                scene->world.add({"wall", std::make_shared<fcl::Boxd>(0.4, 0.001, 1.), pose});
                robot_ = placed(picker(), false, scene, GetParam());
                joints_ = std::make_unique<JointSpace>(*robot_.model, robot_.group);
                si_ = std::make_shared<ob::SpaceInformation>(joints_->space());
                checker_ =
                    std::make_shared<RobotValidityChecker>(si_, *joints_, std::make_shared<RobotCollision>(robot_));
                si_->setStateValidityChecker(checker_);
                si_->setMotionValidator(std::make_shared<RobotMotionValidator>(si_, checker_));
                si_->setup();
            }

            ob::ScopedState<> state(std::vector<double> values) const
            {
                values.resize(robot_.group.size(), 0.);
                ob::ScopedState<> result(joints_->space());
                joints_->setState(values.data(), result.get());
                return result;
            }

            PlacedRobot robot_;
            std::unique_ptr<JointSpace> joints_;
            ob::SpaceInformationPtr si_;
            std::shared_ptr<RobotValidityChecker> checker_;
        };

        TEST_P(RobotValidityCheckerTest, StatesAreValidWithinTheLimitsAndWithoutContacts)
        {
            EXPECT_TRUE(si_->isValid(state({0.2, -1.5}).get()));
            EXPECT_FALSE(si_->isValid(state({0.2, 0.}).get()));
            EXPECT_FALSE(si_->isValid(state({0.5, -1.5}).get()));
            EXPECT_GT(checker_->clearance(state({0.2, -1.5}).get()), 0.);
            EXPECT_LE(checker_->clearance(state({0.2, 0.}).get()), 0.);
        }

        TEST_P(RobotValidityCheckerTest, MotionsAreCheckedAsAWhole)
        {
            const auto from = state({0.2, -1.5});
            const auto to = state({0.2, 1.5});
            EXPECT_FALSE(si_->checkMotion(from.get(), to.get()));
            EXPECT_TRUE(si_->checkMotion(from.get(), state({0.4, -1.}).get()));
            ob::ScopedState<> last(joints_->space());
            std::pair<ob::State *, double> lastValid(last.get(), 0.);
            EXPECT_FALSE(si_->checkMotion(from.get(), to.get(), lastValid));
            EXPECT_GT(lastValid.second, 0.2);
            EXPECT_LT(lastValid.second, 0.5);
            EXPECT_TRUE(si_->isValid(last.get()));
        }

        TEST_P(RobotValidityCheckerTest, MotionsEndAtTheLimits)
        {
            const auto from = state({0.4, -1.5});
            const auto to = state({0.5, -1.5});
            ob::ScopedState<> last(joints_->space());
            std::pair<ob::State *, double> lastValid(last.get(), 0.);
            EXPECT_FALSE(si_->checkMotion(from.get(), to.get(), lastValid));
            EXPECT_NEAR(lastValid.second, 0.5, 1e-6);
            EXPECT_TRUE(si_->isValid(last.get()));
        }

        TEST_P(RobotValidityCheckerTest, DiscreteChecksAreThoseOfOmpl)
        {
            const ob::DiscreteMotionValidator theirs(si_);
            const auto compare = [&](const std::shared_ptr<RobotValidityChecker> &checker)
            {
                si_->setStateValidityChecker(checker);
                const RobotDiscreteValidator ours(si_, checker);
                joints_->space()->setLongestValidSegmentFraction(0.003);
                si_->setup();
                RandomJoints random(robot_);
                ob::ScopedState<> from(joints_->space());
                ob::ScopedState<> to(joints_->space());
                ob::ScopedState<> ourLast(joints_->space());
                ob::ScopedState<> theirLast(joints_->space());
                int valid = 0;
                int invalid = 0;
                for (int motion = 0; motion < 600; ++motion)
                {
                    joints_->setState(random.next().data(), from.get());
                    joints_->setState(random.next().data(), to.get());
                    joints_->space()->interpolate(from.get(), to.get(), motion % 3 == 0 ? 1. : 0.02 * (motion % 7),
                                                  to.get());
                    if (!si_->isValid(from.get()))
                    {
                        continue;
                    }
                    const bool expected = theirs.checkMotion(from.get(), to.get());
                    EXPECT_EQ(ours.checkMotion(from.get(), to.get()), expected);
                    std::pair<ob::State *, double> a(ourLast.get(), -1.);
                    std::pair<ob::State *, double> b(theirLast.get(), -1.);
                    EXPECT_EQ(ours.checkMotion(from.get(), to.get(), a), theirs.checkMotion(from.get(), to.get(), b));
                    EXPECT_NEAR(a.second, b.second, 1e-12);
                    EXPECT_TRUE(expected || joints_->space()->equalStates(ourLast.get(), theirLast.get()));
                    (expected ? valid : invalid)++;
                }
                EXPECT_GT(valid, 50);
                EXPECT_GT(invalid, 50);
            };
            compare(checker_);
            robot_.model = std::make_shared<RobotModel>(loadRobotModel(picker().urdf(true)));
            const auto balls = std::make_shared<RobotCollision>(robot_);
            EXPECT_TRUE(balls->isOfBalls());
            compare(std::make_shared<RobotValidityChecker>(si_, *joints_, balls));
        }

        INSTANTIATE_TEST_SUITE_P(Groups, RobotValidityCheckerTest, ::testing::Values("arm", "arm_and_roll"));
    }  // namespace
}  // namespace ompl_mfa::robots
