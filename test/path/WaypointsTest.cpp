#include "ompl_mfa/path/Waypoints.h"

#include <initializer_list>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/geometric/PathGeometric.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        double &value(ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        double value(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        std::vector<double> values(const Waypoints &path)
        {
            std::vector<double> result;
            for (const ob::State *state : path.pointers())
                result.push_back(value(state));
            return result;
        }

        class WaypointsTest : public ::testing::Test
        {
        protected:
            Waypoints make(std::initializer_list<double> list) const
            {
                Waypoints path(space_);
                ob::ScopedState<ob::RealVectorStateSpace> state(space_);
                for (const double v : list)
                {
                    state[0] = v;
                    path.append(state.get());
                }
                return path;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(1);
        };

        TEST_F(WaypointsTest, AppendsCopies)
        {
            Waypoints path(space_);
            EXPECT_TRUE(path.empty());
            ob::ScopedState<ob::RealVectorStateSpace> state(space_);
            state[0] = 3.0;
            path.append(state.get());
            state[0] = 4.0;
            EXPECT_EQ(path.size(), 1U);
            EXPECT_EQ(values(path), (std::vector<double>{3.0}));
            EXPECT_NE(path[0], state.get());
        }

        TEST_F(WaypointsTest, FrontAndBackAreTheEnds)
        {
            const Waypoints path = make({1.0, 2.0, 3.0});
            EXPECT_EQ(value(path.front()), 1.0);
            EXPECT_EQ(value(path.back()), 3.0);
        }

        TEST_F(WaypointsTest, CopiesAreDeep)
        {
            Waypoints path = make({1.0, 2.0});
            const Waypoints copy(path);
            value(path[0]) = 9.0;
            EXPECT_EQ(values(copy), (std::vector<double>{1.0, 2.0}));
            Waypoints assigned = make({5.0, 6.0, 7.0});
            assigned = path;
            EXPECT_EQ(values(assigned), (std::vector<double>{9.0, 2.0}));
            const Waypoints &self = assigned;
            assigned = self;
            EXPECT_EQ(values(assigned), (std::vector<double>{9.0, 2.0}));
        }

        TEST_F(WaypointsTest, MovesTakeTheStates)
        {
            Waypoints path = make({1.0, 2.0});
            const ob::State *first = path[0];
            Waypoints moved(std::move(path));
            EXPECT_EQ(moved[0], first);
            Waypoints assigned = make({4.0});
            assigned = std::move(moved);
            EXPECT_EQ(assigned[0], first);
            EXPECT_EQ(values(assigned), (std::vector<double>{1.0, 2.0}));
        }

        TEST_F(WaypointsTest, ReusesMemoryWhenTheLengthChanges)
        {
            Waypoints path = make({1.0, 2.0, 3.0});
            const auto before = path.pointers();
            path.clear();
            EXPECT_TRUE(path.empty());
            path.resize(3);
            EXPECT_EQ(path.pointers(), before);
        }

        TEST_F(WaypointsTest, AreAppendedToAPathAsCopies)
        {
            Waypoints waypoints = make({1.0, 2.0});
            ompl::geometric::PathGeometric path(std::make_shared<ob::SpaceInformation>(space_));
            waypoints.appendTo(path);
            value(waypoints[1]) = 3.0;
            waypoints.appendTo(path);
            ASSERT_EQ(path.getStateCount(), 4U);
            for (unsigned int i = 0; i < 4; ++i)
                EXPECT_EQ(value(path.getState(i)), (std::vector<double>{1.0, 2.0, 1.0, 3.0})[i]);
        }

        TEST_F(WaypointsTest, InsertsAnywhere)
        {
            Waypoints path = make({1.0, 3.0});
            ob::ScopedState<ob::RealVectorStateSpace> state(space_);
            state[0] = 2.0;
            path.insert(1, state.get());
            state[0] = 0.0;
            path.insert(0, state.get());
            state[0] = 4.0;
            path.insert(4, state.get());
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0}));
        }

        TEST_F(WaypointsTest, ErasesARangeAndKeepsTheOrder)
        {
            Waypoints path = make({0.0, 1.0, 2.0, 3.0, 4.0});
            path.erase(1, 3);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0, 4.0}));
            path.erase(2, 3);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0}));
            path.erase(1, 1);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0}));
        }

        TEST_F(WaypointsTest, ReversesOnlyTheStatesInUse)
        {
            Waypoints path = make({0.0, 1.0, 2.0, 3.0});
            path.resize(3);
            path.reverse();
            EXPECT_EQ(values(path), (std::vector<double>{2.0, 1.0, 0.0}));
        }
    }  // namespace
}  // namespace ompl_mfa
