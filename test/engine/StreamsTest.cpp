#include "engine/Streams.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/util/RandomNumbers.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        constexpr Stream STREAMS[] = {Stream::Trees,         Stream::Roadmap, Stream::Tightening,
                                      Stream::NewTightening, Stream::Windows, Stream::WindowSwarm,
                                      Stream::Swarm,         Stream::Detours, Stream::GoalSearch};

        std::string name(std::uint64_t run, Stream stream, std::uint64_t index)
        {
            return "run " + std::to_string(run) + ", stream " + std::to_string(static_cast<int>(stream)) + ", index " +
                   std::to_string(index);
        }

        TEST(Streams, OfOneRunAndOfItsNeighboursBeginWithDifferentNumbers)
        {
            // the swarms of a run have streams of their own, for each epoch
            std::map<double, std::string> first;
            const auto expectNew = [&first](std::uint64_t seed, const std::string &owner)
            {
                const auto [other, isNew] = first.emplace(RandomSource(seed).uniform(), owner);
                EXPECT_TRUE(isNew) << owner << " draws what " << other->second << " does";
            };
            for (const std::uint64_t run : {1U, 2U, 8U, 1001U})
            {
                for (const Stream stream : STREAMS)
                {
                    for (std::uint64_t index = 0; index < 30; ++index)
                    {
                        const std::uint64_t seed = streamSeed(run, stream, index);
                        expectNew(seed, name(run, stream, index));
                        for (std::uint64_t epoch = 0; epoch < 4; ++epoch)
                            expectNew(streamSeed(seed, Stream::Epoch, epoch),
                                      name(run, stream, index) + ", epoch " + std::to_string(epoch));
                        expectNew(streamSeed(seed, Stream::Recombination),
                                  name(run, stream, index) + ", recombination");
                    }
                }
            }
            EXPECT_EQ(first.size(), 4U * 9U * 30U * 6U);
        }

        using Point = std::pair<double, double>;

        /* The states off the straight motion from start to goal whose validity a run with one guide alone asks for. */
        std::set<Point> statesOfARun(const std::string &guide, std::uint32_t seed)
        {
            std::set<Point> states;
            test::PlanningProblem problem(
                test::realVectorSpace(2, 0.0, 10.0),
                [&states](const ob::State *state)
                {
                    if (test::coordinate(state, 1) != 1.0)
                        states.emplace(test::coordinate(state, 0), test::coordinate(state, 1));
                    return test::coordinate(state, 0) <= 4.5 || test::coordinate(state, 0) >= 5.5;
                },
                {1.0, 1.0}, {9.0, 1.0});
            const auto planner = problem.planner(test::Engine::Default, seed);
            test::set(*planner, "guide", guide);
            // before the fireflies, whose paths share the corners of the square, have their first turn
            planner->solve(test::afterCalls(800));
            return states;
        }

        TEST(Streams, GuidesOfNeighbouringRunsDrawDifferentStates)
        {
            std::set<Point> seen;
            for (const std::uint32_t seed : {5U, 6U, 12U})
            {
                for (const char *guide : {"trees", "roadmap"})
                {
                    unsigned int common = 0;
                    const std::set<Point> states = statesOfARun(guide, seed);
                    EXPECT_GT(states.size(), 300U);
                    for (const Point &state : states)
                        common += seen.insert(state).second ? 0 : 1;
                    EXPECT_EQ(common, 0U) << guide << " of seed " << seed;
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa
