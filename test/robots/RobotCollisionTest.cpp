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

#include "ompl_mfa/robots/RobotCollision.h"

#include <set>
#include <thread>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include "collision/TestFiles.h"
#include "robots/TestRobots.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using collision::RobotScene;
        using Scene = std::shared_ptr<RobotScene>;

        /* A few boxes, balls and cylinders around the robot. */
        Scene clutter()
        {
            auto scene = std::make_shared<RobotScene>();
            std::mt19937 random(3);
            std::uniform_real_distribution<double> unit(-1., 1.);
            for (int i = 0; i < 12; ++i)
            {
                // Too large to be inside of a link, where its mesh, a surface, would not touch it.
                const double size = 0.11 + 0.03 * unit(random);
                std::shared_ptr<fcl::CollisionGeometryd> shape;
                switch (i % 3)
                {
                    case 0:
                        shape = std::make_shared<fcl::Boxd>(size, 2. * size, size);
                        break;
                    case 1:
                        shape = std::make_shared<fcl::Sphered>(size);
                        break;
                    default:
                        shape = std::make_shared<fcl::Cylinderd>(size, 2. * size);
                }
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() =
                    fcl::Vector3d(0.75 + 0.3 * unit(random), 0.8 * unit(random), 0.6 + 0.5 * unit(random));
                pose.linear() = Eigen::AngleAxisd(unit(random), fcl::Vector3d(1., 2., 3.).normalized()).matrix();
                scene->world.add({"object" + std::to_string(i), shape, pose});
            }
            return scene;
        }

        /* What a check has to look at, found independently of the library: all shapes in the world, by pairs. */
        struct BruteForce
        {
            explicit BruteForce(const PlacedRobot &placedRobot)
              : robot(placedRobot)
            {
            }

            /* Whether the joints between two links contain one of the group. */
            bool moveRelatively(std::size_t a, std::size_t b) const
            {
                const std::set<std::size_t> ofA = movers(a);
                const std::set<std::size_t> ofB = movers(b);
                return ofA != ofB;
            }

            std::set<std::size_t> movers(std::size_t link) const
            {
                std::set<std::size_t> result;
                while (link > 0)
                {
                    const Joint &joint = robot.model->joints()[link - 1];
                    const std::size_t source = joint.mimic ? joint.mimic->joint : link - 1;
                    if (joint.isMoving() && std::count(robot.group.begin(), robot.group.end(), source) > 0)
                    {
                        result.insert(link - 1);
                    }
                    link = joint.parentLink;
                }
                return result;
            }

            bool isChecked(std::size_t a, std::size_t b) const
            {
                const auto &links = robot.model->links();
                const auto inScene = robot.scene->allowed.find(links[a].name, links[b].name);
                return moveRelatively(a, b) && !links[a].shapes.empty() && !links[b].shapes.empty() &&
                       !(inScene ? *inScene
                                 : robot.semantics->allowed().find(links[a].name, links[b].name).value_or(false));
            }

            template <typename Visit>
            void forEachPair(const std::vector<double> &q, const Visit &visit) const
            {
                std::vector<double> values = robot.values;
                for (std::size_t i = 0; i < q.size(); ++i)
                {
                    values[robot.group[i]] = q[i];
                }
                const auto poses = robot.model->linkPoses(values);
                const auto &links = robot.model->links();
                for (std::size_t i = 0; i < links.size(); ++i)
                {
                    for (const auto &shape : links[i].shapes)
                    {
                        for (const auto &object : robot.scene->world.objects())
                        {
                            if (!movers(i).empty())
                            {
                                visit(*shape.geometry, poses[i] * shape.pose, *object.geometry, object.pose);
                            }
                        }
                        for (std::size_t j = i + 1; j < links.size(); ++j)
                        {
                            for (const auto &other : links[j].shapes)
                            {
                                if (isChecked(i, j))
                                {
                                    visit(*shape.geometry, poses[i] * shape.pose, *other.geometry,
                                          poses[j] * other.pose);
                                }
                            }
                        }
                    }
                }
            }

            bool collides(const std::vector<double> &q) const
            {
                bool hit = false;
                forEachPair(q,
                            [&hit](const auto &a, const auto &poseA, const auto &b, const auto &poseB)
                            {
                                fcl::CollisionResultd result;
                                hit = hit || fcl::collide(&a, poseA, &b, poseB, fcl::CollisionRequestd(), result) > 0;
                            });
                return hit;
            }

            double distance(const std::vector<double> &q) const
            {
                double smallest = std::numeric_limits<double>::infinity();
                forEachPair(q,
                            [&smallest](const auto &a, const auto &poseA, const auto &b, const auto &poseB)
                            {
                                fcl::DistanceRequestd request;
                                request.distance_tolerance = 1e-10;
                                fcl::DistanceResultd result;
                                fcl::distance(&a, poseA, &b, poseB, request, result);
                                smallest = std::min(smallest, result.min_distance);
                            });
                return smallest;
            }

            PlacedRobot robot;
        };

        using Pairs = std::set<std::pair<std::string, std::string>>;

        Pairs sorted(const std::vector<std::pair<std::string, std::string>> &pairs)
        {
            Pairs result;
            for (const auto &[first, second] : pairs)
            {
                result.emplace(std::min(first, second), std::max(first, second));
            }
            EXPECT_EQ(result.size(), pairs.size());
            return result;
        }

        TEST(RobotCollision, ChecksThePairsOfThePicker)
        {
            const RobotCollision collision(placed(picker()));
            // written out by hand from picker.urdf and picker.srdf, with the hand's links as one body
            Pairs expected;
            for (const char *link :
                 {"upper_arm", "forearm", "wrist_link", "palm", "left_finger_link", "right_finger_link"})
            {
                expected.emplace(std::min<std::string>("foot", link), std::max<std::string>("foot", link));
                expected.emplace(std::min<std::string>("carriage", link), std::max<std::string>("carriage", link));
            }
            for (const char *link : {"forearm", "wrist_link", "palm", "left_finger_link", "right_finger_link"})
            {
                expected.emplace(std::min<std::string>("turret", link), std::max<std::string>("turret", link));
            }
            for (const char *link : {"wrist_link", "palm", "left_finger_link", "right_finger_link"})
            {
                expected.emplace(std::min<std::string>("upper_arm", link), std::max<std::string>("upper_arm", link));
            }
            for (const char *link : {"palm", "left_finger_link", "right_finger_link"})
            {
                expected.emplace(std::min<std::string>("forearm", link), std::max<std::string>("forearm", link));
            }
            EXPECT_EQ(sorted(collision.checkedPairs()), expected);
            EXPECT_TRUE(collision.checkedObstacles().empty());
        }

        TEST(RobotCollision, ChecksThePairsOfSemanticsAndMatrix)
        {
            for (const TestRobot &one : allRobots())
            {
                Scene scene = clutter();
                PlacedRobot robot = placed(one, false, scene);
                const auto &links = robot.model->links();
                const auto check = [&]
                {
                    const BruteForce independent(robot);
                    Pairs expected;
                    for (std::size_t i = 0; i < links.size(); ++i)
                    {
                        for (std::size_t j = i + 1; j < links.size(); ++j)
                        {
                            if (independent.isChecked(i, j))
                            {
                                expected.emplace(std::min(links[i].name, links[j].name),
                                                 std::max(links[i].name, links[j].name));
                            }
                        }
                    }
                    EXPECT_EQ(sorted(RobotCollision(robot).checkedPairs()), expected) << one.name;
                    return expected;
                };
                const Pairs before = check();
                ASSERT_FALSE(before.empty());
                // the scene's matrix wins over the semantics, in both directions
                scene->allowed.set(before.begin()->first, before.begin()->second, true);
                const std::size_t tip = robot.model->joints()[robot.group.back()].childLink;
                const std::size_t parent = robot.model->joints()[tip - 1].parentLink;
                scene->allowed.set(links[tip].name, links[parent].name, false);
                const Pairs after = check();
                EXPECT_EQ(after.count(*before.begin()), 0U);
                if (!links[parent].shapes.empty())
                {
                    EXPECT_EQ(after.size(), before.size()) << one.name;
                }
                // a link may be allowed to touch an object
                const std::size_t obstacles = RobotCollision(robot).checkedObstacles().size();
                scene->allowed.set(links[tip].name, "object3", true);
                scene->allowed.setDefault("object4", true);
                const std::size_t fewer = RobotCollision(robot).checkedObstacles().size();
                EXPECT_LT(fewer, obstacles);
            }
        }

        TEST(RobotCollision, AgreesWithBruteForce)
        {
            for (const TestRobot &one : allRobots())
            {
                for (const bool spherized : {false, true})
                {
                    const PlacedRobot robot = placed(one, spherized, clutter());
                    const BruteForce brute(robot);
                    const RobotCollision collision(robot);
                    RandomJoints random(robot);
                    int hits = 0;
                    const int states = one.name == "picker" ? 1000 : 100;
                    for (int state = 0; state < states; ++state)
                    {
                        const std::vector<double> q = random.next();
                        const bool hit = collision.collides(q.data());
                        EXPECT_EQ(hit, brute.collides(q)) << one.name << ", state " << state;
                        const double distance = collision.distance(q.data());
                        hits += hit ? 1 : 0;
                        if (hit)
                        {
                            EXPECT_LE(distance, 0.);
                        }
                        else
                        {
                            EXPECT_NEAR(distance, brute.distance(q), 1e-5) << one.name << ", state " << state;
                            EXPECT_EQ(collision.distance(q.data(), 0.5 * distance), 0.5 * distance);
                        }
                    }
                    EXPECT_GT(hits, states / 20) << one.name;
                    EXPECT_LT(hits, states - states / 20) << one.name;
                }
            }
        }

        TEST(RobotCollision, PaddingShrinksAndEnlargesLinks)
        {
            for (const TestRobot &one : allRobots())
            {
                PlacedRobot robot = placed(one, false, clutter());
                const RobotCollision exact(robot);
                robot.padding = 0.005;
                const RobotCollision larger(robot);
                robot.padding = -0.005;
                const RobotCollision smaller(robot);
                RandomJoints random(robot);
                int onlyLarger = 0;
                int notSmaller = 0;
                for (int state = 0; state < 20000; ++state)
                {
                    const std::vector<double> q = random.next();
                    const bool hit = exact.collides(q.data());
                    EXPECT_TRUE(!hit || larger.collides(q.data()));
                    EXPECT_TRUE(hit || !smaller.collides(q.data()));
                    onlyLarger += !hit && larger.collides(q.data()) ? 1 : 0;
                    notSmaller += hit && !smaller.collides(q.data()) ? 1 : 0;
                }
                EXPECT_GT(onlyLarger, 0) << one.name;
                EXPECT_GT(notSmaller, 0) << one.name;
            }
        }

        TEST(RobotCollision, PaddingOfPrimitivesIsExact)
        {
            const auto scene = std::make_shared<RobotScene>();
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = fcl::Vector3d(1.11, 0.012, 0.33);
            scene->world.add({"wall", std::make_shared<fcl::Sphered>(0.1), pose});
            PlacedRobot robot = placed(picker(), false, scene, "hand");
            const std::vector<double> q{0.};
            const double before = RobotCollision(robot).distance(q.data());
            scene->padding["left_finger_link"] = 0.003;
            robot.padding = 0.002;
            EXPECT_NEAR(RobotCollision(robot).distance(q.data()), before - 0.005, 1e-6);
            scene->padding["left_finger_link"] = -1.;
            collision::expectInputError([&robot] { RobotCollision{robot}; }, "left_finger_link", "vanishes");
        }

        TEST(RobotCollision, AttachedObjectsCollideUnlessAllowed)
        {
            const auto scene = std::make_shared<RobotScene>();
            PlacedRobot robot = placed(picker(), false, scene);
            const std::vector<double> q{0.2, 0., 0., 0., 0.};
            ASSERT_FALSE(RobotCollision(robot).collides(q.data()));
            // a bar that reaches back along the arm
            collision::AttachedObject bar;
            bar.id = "bar";
            bar.link = "palm";
            bar.shapes.push_back({std::make_shared<fcl::Boxd>(1., 0.02, 0.02), fcl::Transform3d::Identity()});
            scene->attached.push_back(bar);
            const auto contacts = RobotCollision(robot).contacts(q.data());
            std::set<std::string> touched;
            for (const RobotContact &contact : contacts)
            {
                touched.insert(contact.first == "bar" ? contact.second : contact.first);
            }
            EXPECT_EQ(touched, (std::set<std::string>{"forearm", "upper_arm"}));
            scene->attached[0].touchLinks = {"forearm"};
            EXPECT_TRUE(RobotCollision(robot).collides(q.data()));
            scene->allowed.set("bar", "upper_arm", true);
            EXPECT_FALSE(RobotCollision(robot).collides(q.data()));
            scene->allowed.set("bar", "forearm", false);
            EXPECT_TRUE(RobotCollision(robot).collides(q.data()));
            scene->attached[0].touchLinks = {"arm"};
            collision::expectInputError([&robot] { RobotCollision{robot}; }, "touch_links", "'bar'", "'arm'");
        }

        TEST(RobotCollision, DepthsOfContactsSeparate)
        {
            const auto scene = std::make_shared<RobotScene>();
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = fcl::Vector3d(0.82, 0., 0.53);
            scene->world.add({"post", std::make_shared<fcl::Boxd>(0.02, 2., 2.), pose});
            const PlacedRobot robot = placed(picker(), false, scene);
            const std::vector<double> q{0.2, 0., 0., 0., 0.};
            const auto contacts = RobotCollision(robot).contacts(q.data());
            const auto wrist = std::find_if(contacts.begin(), contacts.end(),
                                            [](const RobotContact &contact) { return contact.first == "wrist_link"; });
            ASSERT_NE(wrist, contacts.end());
            EXPECT_EQ(wrist->second, "post");
            // the ball of radius 0.035 is centred in the plate, or nearly so
            EXPECT_NEAR(wrist->depth, 0.045, 0.002);
        }

        TEST(RobotCollision, MotionsAreCoveredAsAWhole)
        {
            for (const TestRobot &one : allRobots())
            {
                const PlacedRobot robot = placed(one, false, clutter());
                const RobotCollision collision(robot);
                RandomJoints random(robot);
                int freeMotions = 0;
                int blocked = 0;
                for (int motion = 0; motion < (one.name == "picker" ? 400 : 60); ++motion)
                {
                    const std::vector<double> from = random.next();
                    std::vector<double> step = random.next();
                    if (collision.collides(from.data()))
                    {
                        continue;
                    }
                    for (std::size_t i = 0; i < step.size(); ++i)
                    {
                        step[i] = (motion % 2 == 0 ? 1. : 0.1) * (step[i] - from[i]);
                    }
                    const double whole = collision.advance(from.data(), step.data(), 1e-7, true);
                    const double reached = collision.advance(from.data(), step.data(), 1e-7, false);
                    EXPECT_EQ(whole >= 1., reached >= 1.);
                    (whole >= 1. ? freeMotions : blocked)++;
                    // no state of the free part collides, and soon after it one does
                    bool collidesLater = false;
                    for (int i = 0; i <= 2000; ++i)
                    {
                        std::vector<double> q = from;
                        for (std::size_t k = 0; k < q.size(); ++k)
                        {
                            q[k] += i / 2000. * step[k];
                        }
                        const bool hit = collision.collides(q.data());
                        EXPECT_TRUE(!hit || i / 2000. >= reached) << one.name << ", motion " << motion;
                        collidesLater = collidesLater || hit;
                    }
                    EXPECT_TRUE(reached >= 1. || collidesLater ||
                                collision.advance(from.data(), step.data(), 1e-12, true) < 1.);
                }
                EXPECT_GT(freeMotions, 5) << one.name;
                EXPECT_GT(blocked, 5) << one.name;
            }
        }

        TEST(RobotCollision, ThinWallsAreNotPassed)
        {
            const auto scene = std::make_shared<RobotScene>();
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = fcl::Vector3d(0.6, 0., 0.5);
            scene->world.add({"wall", std::make_shared<fcl::Boxd>(0.4, 1e-6, 1.), pose});
            const PlacedRobot robot = placed(picker(), false, scene);
            const RobotCollision collision(robot);
            const std::vector<double> from{0.2, -1.5, 0., 0., 0.};
            const std::vector<double> step{0., 3., 0., 0., 0.};
            EXPECT_LT(collision.advance(from.data(), step.data(), 1e-7, true), 1.);
            const double reached = collision.advance(from.data(), step.data(), 1e-7, false);
            EXPECT_GT(reached, 0.2);
            EXPECT_LT(reached, 0.5);
        }

        TEST(RobotCollision, BatchesOfBallsGiveTheAnswersOfSingleStates)
        {
            for (const TestRobot &one : allRobots())
            {
                const PlacedRobot robot = placed(one, true, clutter());
                const RobotCollision collision(robot);
                EXPECT_TRUE(collision.isOfBalls());
                EXPECT_FALSE(RobotCollision(placed(one, false, clutter())).isOfBalls());
                RandomJoints random(robot);
                constexpr std::size_t COUNT = 7;
                for (int batch = 0; batch < (one.name == "picker" ? 135000 : 5000); ++batch)
                {
                    std::vector<std::vector<double>> states;
                    std::vector<const double *> pointers;
                    std::size_t first = COUNT;
                    for (std::size_t i = 0; i < COUNT; ++i)
                    {
                        states.push_back(random.next());
                    }
                    for (std::size_t i = COUNT; i-- > 0;)
                    {
                        first = collision.collides(states[i].data()) ? i : first;
                    }
                    for (const auto &state : states)
                    {
                        pointers.push_back(state.data());
                    }
                    EXPECT_EQ(collision.firstColliding(pointers.data(), COUNT), first) << one.name;
                    EXPECT_EQ(collision.anyCollides(pointers.data(), COUNT), first < COUNT) << one.name;
                    EXPECT_FALSE(collision.anyCollides(pointers.data(), first)) << one.name;
                }
            }
        }

        TEST(RobotCollision, AnswersAreTheSameFromSeveralThreads)
        {
            const PlacedRobot robot = placed(picker(), false, clutter());
            const RobotCollision collision(robot);
            RandomJoints random(robot);
            std::vector<std::vector<double>> states;
            std::vector<char> expected;
            for (int i = 0; i < 20000; ++i)
            {
                states.push_back(random.next());
                // of another checker, whose order has not changed
                expected.push_back(0);
            }
            const RobotCollision other(robot);
            for (std::size_t i = 0; i < states.size(); ++i)
            {
                expected[i] = other.collides(states[i].data()) ? 1 : 0;
            }
            std::vector<std::thread> threads;
            std::vector<int> wrong(4, 0);
            for (std::size_t thread = 0; thread < wrong.size(); ++thread)
            {
                threads.emplace_back(
                    [&, thread]
                    {
                        for (std::size_t i = 0; i < states.size(); ++i)
                        {
                            const std::size_t k = (i * 7919 + thread * 1009) % states.size();
                            wrong[thread] += collision.collides(states[k].data()) != (expected[k] != 0) ? 1 : 0;
                        }
                    });
            }
            for (std::thread &thread : threads)
            {
                thread.join();
            }
            EXPECT_EQ(wrong, std::vector<int>(4, 0));
        }
    }  // namespace
}  // namespace ompl_mfa::robots
