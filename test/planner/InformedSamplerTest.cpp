#include "ompl_mfa/planner/InformedSampler.h"

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* Path length under another name: nothing is taken for certain of it. */
        class Derived : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
        };

        class InformedSamplerTest : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            InformedSamplerTest()
              : space_(GetParam().make())
              , si_(std::make_shared<ob::SpaceInformation>(space_))
              , chart_(std::make_shared<const StateChart>(space_))
              , start_(space_)
              , goal_(space_)
              , state_(space_)
            {
                ompl::RNG rng(7);
                chart_->sampleUniform(rng, start_.get());
                chart_->sampleUniform(rng, goal_.get());
                bound_ = 1.3 * space_->distance(start_.get(), goal_.get());
            }

            double lengthThroughState() const
            {
                return space_->distance(start_.get(), state_.get()) + space_->distance(state_.get(), goal_.get());
            }

            /* How many of 300 samples a path shorter than the bound can lead through, and how many were drawn. */
            std::pair<int, int> informed(const CostBounds &bounds)
            {
                InformedSampler sampler(chart_, bounds, 3);
                int within = 0;
                int drawn = 0;
                for (int i = 0; i < 300; ++i)
                {
                    if (!sampler.sample(start_.get(), goal_.get(), bound_, state_.get()))
                        continue;
                    EXPECT_TRUE(space_->satisfiesBounds(state_.get()));
                    ++drawn;
                    within += lengthThroughState() < bound_ ? 1 : 0;
                }
                return {within, drawn};
            }

            ob::StateSpacePtr space_;
            ob::SpaceInformationPtr si_;
            StateChartPtr chart_;
            ob::ScopedState<> start_;
            ob::ScopedState<> goal_;
            ob::ScopedState<> state_;
            double bound_{0.0};
        };

        INSTANTIATE_TEST_SUITE_P(Planner, InformedSamplerTest, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(InformedSamplerTest, DrawsWithinTheInformedSet)
        {
            const auto [within, drawn] =
                informed(CostBounds(si_, std::make_shared<ob::PathLengthOptimizationObjective>(si_)));
            EXPECT_GT(drawn, 0);
            EXPECT_EQ(within, drawn);
        }

        TEST_P(InformedSamplerTest, DrawsAnywhereOnceTheBoundsDoNotHold)
        {
            CostBounds bounds(si_, std::make_shared<Derived>(si_));
            bounds.observePath(start_.get(), goal_.get(), ob::Cost(0.1 * bound_));
            ASSERT_FALSE(bounds.admissible());
            const auto [within, drawn] = informed(bounds);
            EXPECT_EQ(drawn, 300);
            EXPECT_LT(within, 300);
        }
    }  // namespace
}  // namespace ompl_mfa
