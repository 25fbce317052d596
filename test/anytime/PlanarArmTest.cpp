#include "anytime/PlanarArm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using ompl_mfa::anytime::Capsule;
using Point = Eigen::Vector2d;

namespace
{
    Point along(const Point &from, const Point &to, int i, int count)
    {
        return from + (to - from) * i / count;
    }

    /* How far the arm stays out of the capsule, from points along both: at most the truth plus the points' spacing. */
    double sampledClearance(const std::vector<double> &angles, const Capsule &capsule)
    {
        constexpr int POINTS = 100;
        double nearest = std::numeric_limits<double>::infinity();
        Point joint = Point::Zero();
        double heading = 0.0;
        for (const double angle : angles)
        {
            heading += angle;
            const Point next = joint + Point(std::cos(heading), std::sin(heading)) / static_cast<double>(angles.size());
            for (int i = 0; i <= POINTS; ++i)
            {
                for (int j = 0; j <= POINTS; ++j)
                    nearest = std::min(
                        nearest, (along(joint, next, i, POINTS) - along(capsule.from, capsule.to, j, POINTS)).norm());
            }
            joint = next;
        }
        return nearest - capsule.radius;
    }
}  // namespace

TEST(PlanarArm, AgreesWithPointsAlongLinksAndObstacles)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> angle(-1.5, 1.5);
    std::uniform_real_distribution<double> place(-0.8, 0.8);
    int free = 0;
    int colliding = 0;
    for (int trial = 0; trial < 500; ++trial)
    {
        std::vector<double> angles(7);
        for (double &value : angles)
            value = angle(engine);
        Capsule capsule{{place(engine), place(engine)}, {place(engine), place(engine)}, 0.03};
        if (trial % 2 == 0)
            capsule.to = capsule.from;
        const double clearance = sampledClearance(angles, capsule);
        // the spacing of the points is at most 0.023, and half of it is what a pair of points can miss at most
        if (clearance > 0.0 && clearance < 0.02)
            continue;
        const bool isFree = ompl_mfa::anytime::armIsFree(angles.data(), 7, {capsule});
        EXPECT_EQ(isFree, clearance > 0.0) << "trial " << trial << ", clearance " << clearance;
        ++(isFree ? free : colliding);
    }
    EXPECT_GT(free, 50);
    EXPECT_GT(colliding, 50);
}
