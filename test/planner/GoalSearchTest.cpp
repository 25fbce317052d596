#include "ompl_mfa/planner/GoalSearch.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalRegion.h>

#include "path/StateSpaces.h"
#include "planner/DistanceGoal.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        class GoalSearchOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, GoalSearchOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(GoalSearchOfEverySpace, FindsStatesThatSatisfyTheGoal)
        {
            const auto space = GetParam().make();
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> origin(space);
            ob::ScopedState<> target(space);
            sampler->sampleUniform(origin.get());
            sampler->sampleUniform(target.get());
            const auto goal = std::make_shared<test::DistanceGoal>(si, target.get(), 0.15 * space->getMaximumExtent());
            GoalSearch search(std::make_shared<const StateChart>(space), si, goal, origin.get(), 5);
            Waypoints found(space);
            const ob::PlannerTerminationCondition never([] { return false; });
            for (int i = 0; i < 2000 && found.size() < 3; ++i)
                search.advance(never, found);
            ASSERT_EQ(found.size(), 3U);
            for (const ob::State *state : found.pointers())
            {
                EXPECT_TRUE(goal->isSatisfied(state));
                EXPECT_TRUE(space->satisfiesBounds(state));
            }
        }

        TEST(GoalSearch, PassesOverInvalidStates)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const auto isValid = [](const ob::State *state)
            { return state->as<ob::RealVectorStateSpace::StateType>()->values[0] > 5.5; };
            si->setStateValidityChecker(isValid);
            si->setup();
            ob::ScopedState<> origin(space);
            ob::ScopedState<> target(space);
            origin[0] = origin[1] = -5.0;
            target[0] = target[1] = 5.0;
            const auto goal = std::make_shared<test::DistanceGoal>(si, target.get(), 1.0);
            GoalSearch search(std::make_shared<const StateChart>(space), si, goal, origin.get(), 5);
            Waypoints found(space);
            const ob::PlannerTerminationCondition never([] { return false; });
            for (int i = 0; i < 2000 && found.empty(); ++i)
                search.advance(never, found);
            ASSERT_FALSE(found.empty());
            EXPECT_TRUE(isValid(found.front()));
        }

        TEST(GoalSearch, StopsWithTheCondition)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            int asked = 0;
            si->setStateValidityChecker(
                [&asked](const ob::State *)
                {
                    ++asked;
                    return true;
                });
            si->setup();
            ob::ScopedState<> origin(space);
            origin[0] = origin[1] = -5.0;
            const auto goal = std::make_shared<test::DistanceGoal>(si, origin.get(), 100.0);
            GoalSearch search(std::make_shared<const StateChart>(space), si, goal, origin.get(), 5);
            Waypoints found(space);
            EXPECT_FALSE(search.advance(ob::PlannerTerminationCondition([] { return true; }), found));
            EXPECT_EQ(asked, 0);
        }
    }  // namespace
}  // namespace ompl_mfa
