#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_PLANAR_ARM_
#define OMPL_MFA_BENCHMARKS_ANYTIME_PLANAR_ARM_

#include <vector>

#include <Eigen/Core>
#include <Eigen/StdVector>

namespace ompl_mfa::anytime
{
    /** \brief All points within \e radius of a segment; a disc where both ends are the same. Lengths in units of the
        arm's. */
    struct Capsule
    {
        Eigen::Vector2d from;
        Eigen::Vector2d to;
        double radius;
    };
    using Capsules = std::vector<Capsule, Eigen::aligned_allocator<Capsule>>;

    /** \brief Whether an arm of \e links links without width, 1 long in all and with its base at the origin, keeps out
        of all obstacles. Angles in radians, each relative to the link before. */
    bool armIsFree(const double *angles, int links, const Capsules &obstacles);
}  // namespace ompl_mfa::anytime

#endif
