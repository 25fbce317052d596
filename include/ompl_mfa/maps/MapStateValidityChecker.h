/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_MAPS_MAP_STATE_VALIDITY_CHECKER_
#define OMPL_MFA_MAPS_MAP_STATE_VALIDITY_CHECKER_

#include <memory>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/Footprint.h"
#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::maps
{
    class GridRobot;
    struct GridPose;

    /** \brief A state is valid if it is within the bounds of the space and the robot touches no obstacle of the map:
        exact for point, disc and polygon.

        Const functions are safe to call from several threads and allocate nothing after a thread's first calls. */
    class OMPL_MFA_EXPORT MapStateValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \param si of R^2, SE(2), a Dubins or a Reeds-Shepp space; in R^2 the robot looks along the x axis of the
            world
            \param grid the obstacles, not null
            \throw InputError for any other space. */
        MapStateValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const ObstacleGrid> grid,
                                const Footprint &footprint);

        bool isValid(const ompl::base::State *state) const override;

        /** \brief Signed distance between robot and obstacles in world units, true to within a cell; at least 0 if the
            robot touches none, at most 0 otherwise. In collision it is minus the depth of the deepest point of the
            outline (for a disc, of the centre, plus the radius). The bounds of the space are ignored. */
        double clearance(const ompl::base::State *state) const override;

        /** \brief As clearance(), of the reference point in place of the robot. */
        double pointClearance(const ompl::base::State *state) const;

        const Footprint &footprint() const;

        const ObstacleGrid &grid() const;

    private:
        friend class MapMotionValidator;

        GridPose pose(const ompl::base::State *state) const;

        std::shared_ptr<const GridRobot> robot_;
        bool turns_;
    };
}  // namespace ompl_mfa::maps

#endif
