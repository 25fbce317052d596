#include "ConservativeAdvancement.h"

#include <algorithm>
#include <cmath>

namespace ompl_mfa::collision
{
    namespace
    {
        // Bounds what grazing costs; a motion that needs more counts as touching.
        constexpr int maximumSteps = 1000;

        fcl::Vector3d velocity(const MovingShape &shape)
        {
            return shape.motion != nullptr ? shape.motion->displacement : fcl::Vector3d::Zero();
        }

        double rotationSpeed(const MovingShape &shape)
        {
            return shape.motion != nullptr ? std::abs(shape.motion->angle) * shape.reach : 0.;
        }

        struct Approach
        {
            fcl::Vector3d velocity;
            double rotation;
        };

        struct Clearance
        {
            double distance;

            // Bound on how fast the distance can shrink, by the unit of the share.
            double speed;
        };

        // Two convex shapes cannot meet before they have closed the gap between two parallel planes, so only the
        // speed across these counts. Of other shapes nothing is known but that they are this far apart.
        Clearance clearanceAt(double t, const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                              const Approach &approach, double end)
        {
            fcl::Transform3d poseA;
            fcl::Transform3d poseB;
            a.place(t, poseA);
            b.place(t, poseB);
            if (functions.separate != nullptr)
            {
                const ConvexSeparation gap = functions.separate(*a.geometry, poseA, *b.geometry, poseB);
                return {gap.lower, approach.rotation - approach.velocity.dot(gap.normal)};
            }
            const double speed = approach.velocity.norm() + approach.rotation;
            // No need to know of a distance that lasts to the end.
            const double enough = speed * (end - t) * 1.000001 + 1e-300;
            return {functions.distance(*a.geometry, poseA, *b.geometry, poseB, enough), speed};
        }
    }  // namespace

    void MovingShape::place(double t, fcl::Transform3d &world) const
    {
        if (motion == nullptr)
        {
            world = *pose;
            return;
        }
        motion->place(t, world);
        world = world * *pose;
    }

    double advancePair(const PairFunctions &functions, const MovingShape &a, const MovingShape &b, double tolerance,
                       double end)
    {
        const Approach approach{velocity(a) - velocity(b), rotationSpeed(a) + rotationSpeed(b)};
        double reached = 0.;
        double next = 0.;
        for (int step = 0; step < maximumSteps; ++step)
        {
            const Clearance clearance = clearanceAt(next, functions, a, b, approach, end);
            if (clearance.distance <= tolerance)
            {
                return reached;
            }
            reached = next;
            if (clearance.distance >= clearance.speed * (end - reached))
            {
                return end;
            }
            next = std::min(end, reached + clearance.distance / clearance.speed);
        }
        return reached;
    }
}  // namespace ompl_mfa::collision
