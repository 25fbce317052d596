#include "anytime/PlanarArm.h"

#include <algorithm>
#include <cmath>

namespace ompl_mfa::anytime
{
    namespace
    {
        using Point = Eigen::Vector2d;

        double cross(const Point &a, const Point &b)
        {
            return a.x() * b.y() - a.y() * b.x();
        }

        double squaredDistance(const Point &point, const Point &from, const Point &to)
        {
            const Point along = to - from;
            const double length = along.squaredNorm();
            const double t = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
            return (point - from - t * along).squaredNorm();
        }

        bool crosses(const Point &a, const Point &b, const Point &c, const Point &d)
        {
            return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
        }

        bool collides(const Point &from, const Point &to, const Capsule &obstacle)
        {
            const double limit = obstacle.radius * obstacle.radius;
            if (squaredDistance(obstacle.from, from, to) < limit)
                return true;
            if (obstacle.from == obstacle.to)
                return false;
            return squaredDistance(obstacle.to, from, to) < limit ||
                   squaredDistance(from, obstacle.from, obstacle.to) < limit ||
                   squaredDistance(to, obstacle.from, obstacle.to) < limit ||
                   crosses(from, to, obstacle.from, obstacle.to);
        }
    }  // namespace

    bool armIsFree(const double *angles, int links, const Capsules &obstacles)
    {
        Point joint = Point::Zero();
        double heading = 0.0;
        for (int i = 0; i < links; ++i)
        {
            heading += angles[i];
            const Point next = joint + Point(std::cos(heading), std::sin(heading)) / links;
            for (const Capsule &obstacle : obstacles)
            {
                if (collides(joint, next, obstacle))
                    return false;
            }
            joint = next;
        }
        return true;
    }
}  // namespace ompl_mfa::anytime
