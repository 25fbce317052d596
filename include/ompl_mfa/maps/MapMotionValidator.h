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

#ifndef OMPL_MFA_MAPS_MAP_MOTION_VALIDATOR_
#define OMPL_MFA_MAPS_MAP_MOTION_VALIDATOR_

#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/MapStateValidityChecker.h"

namespace ompl_mfa::maps
{
    /** \brief Continuous validation of motions on a map; no obstacle is missed, however small.

        Far from obstacles a motion is covered by the distances of a few states. Near them the region that the robot
        sweeps is compared with the cells. This is exact for straight motions without rotation, and for straight ones
        of points and discs. A rotating or curved motion is divided until it is free or comes closer than tolerance() to
        an obstacle, which counts as a collision. */
    class OMPL_MFA_EXPORT MapMotionValidator : public ompl::base::MotionValidator
    {
    public:
        MapMotionValidator(const ompl::base::SpaceInformationPtr &si,
                           std::shared_ptr<const MapStateValidityChecker> checker);

        /** \brief Whether the whole motion is valid; `s1` is assumed to be valid. */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief As above. If the motion is invalid, `lastValid` is set to a valid state at most tolerance() before
            the first collision (unless its pointer is null) and its fraction of the motion, in [0, 1). */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief World units: a fiftieth of a cell. */
        double tolerance() const;

    private:
        /** \brief How the space moves between two states. */
        enum class Curve
        {
            Straight,
            Dubins,
            ReedsShepp
        };

        double freeShare(const ompl::base::State *s1, const ompl::base::State *s2, bool locates) const;

        std::shared_ptr<const MapStateValidityChecker> checker_;
        Curve curve_;
        /** \brief Whether the map reaches beyond the bounds of the space. */
        bool exceedsBounds_;
    };

    /** \brief Sets the validity checker and the motion validator of \e si. Throws InputError as
        MapStateValidityChecker does. */
    OMPL_MFA_EXPORT std::shared_ptr<MapStateValidityChecker> setMapChecking(const ompl::base::SpaceInformationPtr &si,
                                                                            std::shared_ptr<const ObstacleGrid> grid,
                                                                            const Footprint &footprint);
}  // namespace ompl_mfa::maps

#endif
