#ifndef OMPL_MFA_BENCHMARK_NEARBY_STATE_
#define OMPL_MFA_BENCHMARK_NEARBY_STATE_

#include <optional>

#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa
{
    /** \brief A valid pose near one that is not. */
    struct NearbyState
    {
        /** \brief It may be farther than `distance` by a fiftieth, for the sake of coordinates with few digits. */
        ConfigPose pose;
        /** \brief The least distance at which a position was found to be valid, world units. */
        double distance{0.0};
    };

    /** \brief The nearest valid state to \e pose, which is not valid, among those of the same orientation, up to the
        distance \e farthest (above 0, world units); empty where none is found.

        Positions are tried on circles or spheres of growing radius, in 64 or 206 directions; in the best one the
        distance is narrowed down. \e si is the space
        information of a problem of kind \e kind, set up. */
    std::optional<NearbyState> findNearbyState(const ompl::base::SpaceInformation &si, StateSpaceKind kind,
                                               const ConfigPose &pose, double farthest);
}  // namespace ompl_mfa

#endif
