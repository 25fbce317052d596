#include "ompl_mfa/collision/FclMotionValidator.h"

#include "collision/OmplAppProblems.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Whether one of many states between two collides: says nothing about a motion without such a state.
        bool someStateCollides(const OmplAppWorld &world, const ob::ScopedState<> &from, const ob::ScopedState<> &to)
        {
            ob::ScopedState<> between(from);
            constexpr int states = 1000;
            for (int i = 1; i < states; ++i)
            {
                world.si()->getStateSpace()->interpolate(from.get(), to.get(), double(i) / states, between.get());
                world.si()->enforceBounds(between.get());
                if (!world.checker()->isValid(between.get()))
                {
                    return true;
                }
            }
            return false;
        }

        // OMPL.app made these paths with discrete checks. Motion 82 of Barriers.path has a robot corner inside a
        // barrier over 39% of its length, between two valid states: a continuous check has to refuse it.
        TEST_P(OmplAppTest, ShippedPathIsValidStateByStateAndMotionByMotion)
        {
            const OmplAppProblem &problem = GetParam();
            const OmplAppWorld world(problem);
            const std::vector<std::vector<double>> rows =
                readRows(omplAppFolder() / problem.folder / (std::string(problem.name) + ".path"));
            ASSERT_GT(rows.size(), 2U);
            const FclMotionValidator continuous(world.si(), world.checker());
            std::vector<std::size_t> refused;
            for (std::size_t i = 0; i < rows.size(); ++i)
            {
                const ob::ScopedState<> state = world.state(rows[i]);
                EXPECT_TRUE(world.si()->isValid(state.get())) << "state " << i;
                if (i > 0)
                {
                    const ob::ScopedState<> previous = world.state(rows[i - 1]);
                    EXPECT_TRUE(world.si()->checkMotion(previous.get(), state.get())) << "motion " << i;
                    const bool valid = continuous.checkMotion(previous.get(), state.get());
                    EXPECT_EQ(valid, !someStateCollides(world, previous, state)) << "motion " << i;
                    if (!valid)
                    {
                        refused.push_back(i);
                    }
                }
            }
            EXPECT_EQ(refused, std::string(problem.name) == "Barriers" ? std::vector<std::size_t>{82}
                                                                       : std::vector<std::size_t>{});
        }

        INSTANTIATE_TEST_SUITE_P(OmplApp, OmplAppTest, ::testing::ValuesIn(omplAppProblems()), problemName);
    }  // namespace
}  // namespace ompl_mfa::collision
