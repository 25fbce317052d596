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

#include "engine/PartRegistry.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>

#include "engine/SearchProblem.h"
#include "engine/fireflies/FireflyPart.h"
#include "engine/fireflies/Swarms.h"
#include "engine/refinement/TighteningPart.h"
#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        using Kinds = std::vector<PartKind>;

        ob::PlannerPtr guest(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<ompl::geometric::RRTConnect>(si);
        }

        Kinds kinds(const PartList &list)
        {
            Kinds result;
            for (const auto &part : list.parts)
            {
                result.push_back(part->kind());
            }
            return result;
        }

        SearchSettings paper()
        {
            SearchSettings settings;
            settings.guide = "none";
            settings.recombination = settings.tightening = false;
            return settings;
        }

        class PartRegistryTest : public ::testing::Test
        {
        protected:
            PartList make(const SearchSettings &settings, const ob::PlannerAllocator &allocator = nullptr)
            {
                search_ = std::make_unique<test::SearchProblem>(problem_->pdef, 5, settings);
                return makeParts(search_->context, allocator);
            }

            void setDistanceGoal() const
            {
                problem_->pdef->setGoal(
                    std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::unique_ptr<test::SearchProblem> search_;
        };

        TEST_F(PartRegistryTest, AllPartsButAGuestSearchByDefault)
        {
            const PartList list = make({});
            EXPECT_EQ(kinds(list), (Kinds{PartKind::Fireflies, PartKind::Recombination, PartKind::Tightening,
                                          PartKind::Trees, PartKind::Roadmap}));
            EXPECT_TRUE(list.guided);
            EXPECT_EQ(list.refiner, dynamic_cast<refinement::TighteningPart *>(list.parts[2].get()));
            EXPECT_NE(list.refiner, nullptr);
            ASSERT_NE(list.swarms, nullptr);
            EXPECT_EQ(list.swarms->options().coordinates, fireflies::Swarm::Coordinates::Modes);
            EXPECT_TRUE(list.swarms->options().pool);
            EXPECT_TRUE(list.swarms->options().bounded);
            EXPECT_EQ(list.swarms->options().fireflies.populationSize, 20U);
        }

        TEST_F(PartRegistryTest, ThePapersAlgorithmIsFirefliesOfOffsetsAndNothingElse)
        {
            const PartList list = make(paper());
            ASSERT_EQ(kinds(list), Kinds{PartKind::Fireflies});
            EXPECT_NE(dynamic_cast<fireflies::FireflyPart *>(list.parts[0].get()), nullptr);
            EXPECT_FALSE(list.guided);
            EXPECT_EQ(list.refiner, nullptr);
            ASSERT_NE(list.swarms, nullptr);
            const fireflies::Swarms::Options &options = list.swarms->options();
            EXPECT_EQ(options.coordinates, fireflies::Swarm::Coordinates::Offsets);
            EXPECT_FALSE(options.pool);
            EXPECT_FALSE(options.bounded);
            EXPECT_EQ(options.fireflies.variant, FireflyOptimizer::Variant::MFA);
            EXPECT_EQ(options.fireflies.populationSize, 100U);
            EXPECT_EQ(options.fireflies.generations, 50U);
            EXPECT_DOUBLE_EQ(options.fireflies.gamma, 0.5);
            EXPECT_DOUBLE_EQ(options.fireflies.alpha, 0.2);
            EXPECT_DOUBLE_EQ(options.fireflies.eta, 1.0);
        }

        TEST_F(PartRegistryTest, BesideAGuestTheFirefliesAreNotThePapers)
        {
            const PartList list = make(paper(), guest);
            EXPECT_EQ(kinds(list), (Kinds{PartKind::Fireflies, PartKind::GuestPlanner}));
            EXPECT_TRUE(list.guided);
            ASSERT_NE(list.swarms, nullptr);
            EXPECT_EQ(list.swarms->options().coordinates, fireflies::Swarm::Coordinates::Modes);
            EXPECT_EQ(list.swarms->options().fireflies.populationSize, 20U);
        }

        TEST_F(PartRegistryTest, TheFirefliesFlyAsTheSettingsSay)
        {
            for (SearchSettings settings : {SearchSettings(), paper()})
            {
                settings.variant = "fa";
                settings.populationSize = 7;
                settings.generations = 3;
                settings.gamma = 0.25;
                settings.alpha = 0.75;
                settings.eta = 1.5;
                const PartList list = make(settings);
                const FireflyOptimizer::Settings &fireflies = list.swarms->options().fireflies;
                EXPECT_EQ(fireflies.variant, FireflyOptimizer::Variant::FA);
                EXPECT_EQ(fireflies.populationSize, 7U);
                EXPECT_EQ(fireflies.generations, 3U);
                EXPECT_DOUBLE_EQ(fireflies.gamma, 0.25);
                EXPECT_DOUBLE_EQ(fireflies.alpha, 0.75);
                EXPECT_DOUBLE_EQ(fireflies.eta, 1.5);
            }
        }

        TEST_F(PartRegistryTest, WithoutFirefliesThereIsNoRecombinationEither)
        {
            SearchSettings settings;
            settings.fireflies = false;
            ASSERT_TRUE(settings.recombination);
            const PartList list = make(settings);
            EXPECT_EQ(kinds(list), (Kinds{PartKind::Tightening, PartKind::Trees, PartKind::Roadmap}));
            EXPECT_EQ(list.swarms, nullptr);
            EXPECT_TRUE(list.guided);
        }

        TEST_F(PartRegistryTest, SomethingHasToFindPaths)
        {
            SearchSettings settings;
            settings.fireflies = false;
            settings.guide = "none";
            for (const bool others : {false, true})
            {
                settings.recombination = settings.tightening = others;
                EXPECT_THROW(make(settings), ompl::Exception);
                EXPECT_EQ(kinds(make(settings, guest)).back(), PartKind::GuestPlanner);
            }
            setDistanceGoal();
            EXPECT_THROW(make(settings), ompl::Exception) << "a search for goals finds no path";
        }

        TEST_F(PartRegistryTest, AGuestThatIsNoneIsAnError)
        {
            EXPECT_THROW(make({}, [](const ob::SpaceInformationPtr &) { return ob::PlannerPtr(); }), ompl::Exception);
        }

        /* Each setting adds its part only, in a fixed order, whatever else is set. */
        TEST_F(PartRegistryTest, EverySettingDecidesOverItsOwnPart)
        {
            const std::vector<std::string> guides{"none", "trees", "roadmap", "both"};
            unsigned int lists = 0;
            for (unsigned int k = 0; k < 128; ++k)
            {
                SearchSettings settings;
                settings.fireflies = (k & 1U) != 0;
                settings.recombination = (k & 2U) != 0;
                settings.tightening = (k & 4U) != 0;
                settings.guide = guides[k / 8 % 4];
                const bool hasGuest = (k & 32U) != 0;
                const bool searchesGoals = (k & 64U) != 0;
                if (!settings.fireflies && settings.guide == "none" && !hasGuest)
                {
                    continue;
                }
                problem_ = test::wallProblem();
                if (searchesGoals)
                {
                    setDistanceGoal();
                }
                Kinds expected;
                const auto expect = [&expected](bool there, PartKind kind)
                {
                    if (there)
                    {
                        expected.push_back(kind);
                    }
                };
                const bool both = settings.guide == "both";
                expect(settings.fireflies, PartKind::Fireflies);
                expect(settings.fireflies && settings.recombination, PartKind::Recombination);
                expect(settings.tightening, PartKind::Tightening);
                expect(both || settings.guide == "trees", PartKind::Trees);
                expect(both || settings.guide == "roadmap", PartKind::Roadmap);
                expect(hasGuest, PartKind::GuestPlanner);
                expect(searchesGoals, PartKind::GoalSearch);
                const PartList list = make(settings, hasGuest ? guest : ob::PlannerAllocator());
                EXPECT_EQ(kinds(list), expected) << k;
                EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
                EXPECT_EQ(list.refiner != nullptr, settings.tightening) << k;
                EXPECT_EQ(list.swarms != nullptr, settings.fireflies) << k;
                EXPECT_EQ(list.guided, settings.guide != "none" || hasGuest) << k;
                ++lists;
            }
            EXPECT_EQ(lists, 120U);
        }

        /* Every part always has a share: without one it would never get a turn. */
        TEST_F(PartRegistryTest, EveryPartHasAShare)
        {
            setDistanceGoal();
            const PartList list = make({}, guest);
            ASSERT_EQ(list.parts.size(), PART_NAMES.size());
            for (const auto &part : list.parts)
            {
                for (const Share &share : {part->firstShare(), part->improvementShare(2.0)})
                {
                    EXPECT_GT(share.floor, 0.0) << PART_NAMES[static_cast<std::size_t>(part->kind())];
                    EXPECT_GT(share.weight, 0.0);
                    EXPECT_GE(share.delay, 0.0);
                }
                EXPECT_EQ(part->firstShare().delay, 0.0) << "nobody waits for a first path";
            }
        }

        TEST_F(PartRegistryTest, NoPartHasATurnBeforeThereAreEnds)
        {
            const PartList list = make({}, guest);
            for (const auto &part : list.parts)
            {
                EXPECT_EQ(part->readiness(), Readiness::Idle) << PART_NAMES[static_cast<std::size_t>(part->kind())];
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine
