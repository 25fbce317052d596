#include "ompl_mfa/collision/FclStateValidityChecker.h"

#include "collision/OmplAppProblems.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST_P(OmplAppTest, AgreesWithTheReferenceOnEveryState)
        {
            const OmplAppProblem &problem = GetParam();
            const OmplAppWorld world(problem);
            const std::vector<std::vector<double>> rows =
                readRows(omplAppFolder() / "samples" / (std::string(problem.name) + ".samples"));
            ASSERT_EQ(rows.size(), 2000U);
            const std::size_t coordinates = problem.planar ? 3 : 7;
            int compared = 0;
            for (const std::vector<double> &row : rows)
            {
                const ob::ScopedState<> state = world.state(row);
                const bool valid = row[coordinates] != 0.;
                EXPECT_EQ(world.checker()->isValid(state.get()), valid) << ::testing::PrintToString(row);
                if (row.size() > coordinates + 1)
                {
                    ++compared;
                    EXPECT_NEAR(world.checker()->clearance(state.get()), row[coordinates + 1], 1e-6 * problem.scale())
                        << ::testing::PrintToString(row);
                }
            }
            EXPECT_EQ(compared, 200);
        }

        INSTANTIATE_TEST_SUITE_P(OmplApp, OmplAppTest, ::testing::ValuesIn(omplAppProblems()), problemName);
    }  // namespace
}  // namespace ompl_mfa::collision
