#ifndef OMPL_MFA_COLLISION_BODY_MOTION_
#define OMPL_MFA_COLLISION_BODY_MOTION_

#include <cmath>

#include <fcl/common/types.h>

namespace ompl_mfa::collision
{
    /** \brief Motion of a body over the share t in [0, 1]: its reference point on a segment, its orientation about an
        axis that is fixed in the body, both at constant speed. Lengths in the units of the world, angles in radians. */
    struct BodyMotion
    {
        /** \brief Position of the reference point at t = 0. */
        fcl::Vector3d start{fcl::Vector3d::Zero()};

        /** \brief From there to its position at t = 1. */
        fcl::Vector3d displacement{fcl::Vector3d::Zero()};

        /** \brief Orientation at t = 0. */
        fcl::Matrix3d rotation{fcl::Matrix3d::Identity()};

        /** \brief Unit axis in the frame of the body. */
        fcl::Vector3d axis{fcl::Vector3d::UnitZ()};

        /** \brief Rotation about the axis from t = 0 to t = 1. */
        double angle{0.};

        void place(double t, fcl::Transform3d &pose) const
        {
            pose.setIdentity();
            pose.translation() = start + t * displacement;
            if (angle == 0.)
            {
                pose.linear() = rotation;
            }
            else
            {
                pose.linear() = rotation * Eigen::AngleAxisd(t * angle, axis).toRotationMatrix();
            }
        }
    };
}  // namespace ompl_mfa::collision

#endif
