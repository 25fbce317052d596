#include "benchmark/PositionTaskSpace.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

namespace
{
    namespace ob = ompl::base;

    ob::SpaceInformationPtr rigidBody()
    {
        auto space = std::make_shared<ob::SE3StateSpace>();
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-1.0);
        bounds.setHigh(2.0);
        space->setBounds(bounds);
        return std::make_shared<ob::SpaceInformation>(space);
    }

    TEST(PositionTaskSpace, SamplesWithinTheBounds)
    {
        const ompl_mfa::PositionTaskSpace task(rigidBody());
        ASSERT_EQ(task.getDimension(), 3);
        Eigen::VectorXd position(3);
        Eigen::VectorXd lower = Eigen::VectorXd::Constant(3, 2.0);
        Eigen::VectorXd upper = Eigen::VectorXd::Constant(3, -1.0);
        for (int i = 0; i < 1000; ++i)
        {
            task.sample(position);
            lower = lower.cwiseMin(position);
            upper = upper.cwiseMax(position);
        }
        EXPECT_GE(lower.minCoeff(), -1.0);
        EXPECT_LE(upper.maxCoeff(), 2.0);
        EXPECT_LT(lower.maxCoeff(), -0.9);
        EXPECT_GT(upper.minCoeff(), 1.9);
    }

    TEST(PositionTaskSpace, LiftingAndProjectingIsTheIdentity)
    {
        const auto si = rigidBody();
        const ompl_mfa::PositionTaskSpace task(si);
        ob::ScopedState<ob::SE3StateSpace> state(si);
        Eigen::VectorXd back(3);
        Eigen::VectorXd position(3);
        position << 0.5, -0.25, 1.75;
        ASSERT_TRUE(task.lift(position, nullptr, state.get()));
        EXPECT_TRUE(si->satisfiesBounds(state.get())) << "the orientation is a unit quaternion";
        task.project(state.get(), back);
        EXPECT_EQ(back, position);
    }

    TEST(PositionTaskSpace, RefusesSpacesWithoutPosition)
    {
        const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SO2StateSpace>());
        EXPECT_THROW(ompl_mfa::PositionTaskSpace task(si), ompl::Exception);
    }
}  // namespace
