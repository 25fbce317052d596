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

#ifndef OMPL_MFA_TEST_PATH_STATE_SPACES_
#define OMPL_MFA_TEST_PATH_STATE_SPACES_

/* The state spaces of the tests, set up and ready to allocate states. */

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

#include "path/Waypoints.h"

namespace ompl_mfa::test
{
    inline ompl::base::StateSpacePtr ready(const ompl::base::StateSpacePtr &space)
    {
        space->setup();
        return space;
    }

    /** \brief R^n with bounds [low, high] in every coordinate. */
    inline ompl::base::StateSpacePtr realVectorSpace(unsigned int n, double low = -10.0, double high = 10.0)
    {
        auto space = std::make_shared<ompl::base::RealVectorStateSpace>(n);
        space->setBounds(low, high);
        return ready(space);
    }

    /** \brief A path in R^2 through points (x, y). */
    inline path::Waypoints planarPath(const ompl::base::StateSpacePtr &space,
                                      const std::vector<std::pair<double, double>> &points)
    {
        path::Waypoints path(space);
        ompl::base::ScopedState<> state(space);
        for (const auto &[x, y] : points)
        {
            state[0] = x;
            state[1] = y;
            path.append(state.get());
        }
        return path;
    }

    template <typename Space>
    std::shared_ptr<Space> bounded(std::shared_ptr<Space> space, unsigned int n, double low, double high)
    {
        ompl::base::RealVectorBounds bounds(n);
        bounds.setLow(low);
        bounds.setHigh(high);
        space->setBounds(bounds);
        return space;
    }

    inline ompl::base::StateSpacePtr se2Space(double low = -10.0, double high = 10.0)
    {
        return ready(bounded(std::make_shared<ompl::base::SE2StateSpace>(), 2, low, high));
    }

    inline ompl::base::StateSpacePtr se3Space(double low = -10.0, double high = 10.0)
    {
        return ready(bounded(std::make_shared<ompl::base::SE3StateSpace>(), 3, low, high));
    }

    inline ompl::base::StateSpacePtr so2Space()
    {
        return ready(std::make_shared<ompl::base::SO2StateSpace>());
    }

    inline ompl::base::StateSpacePtr so3Space()
    {
        return ready(std::make_shared<ompl::base::SO3StateSpace>());
    }

    inline ompl::base::StateSpacePtr dubinsSpace(bool symmetric, double radius = 1.0)
    {
        return ready(bounded(std::make_shared<ompl::base::DubinsStateSpace>(radius, symmetric), 2, -10.0, 10.0));
    }

    inline ompl::base::StateSpacePtr reedsSheppSpace(double radius = 1.0)
    {
        return ready(bounded(std::make_shared<ompl::base::ReedsSheppStateSpace>(radius), 2, -10.0, 10.0));
    }

    /** \brief A locked compound of \e parts with \e weights. */
    inline ompl::base::StateSpacePtr compoundSpace(const std::vector<ompl::base::StateSpacePtr> &parts,
                                                   const std::vector<double> &weights)
    {
        auto space = std::make_shared<ompl::base::CompoundStateSpace>(parts, weights);
        space->lock();
        return ready(space);
    }

    /** \brief Two planar robots in one space. */
    inline ompl::base::StateSpacePtr twoSe2Space()
    {
        return compoundSpace({se2Space(), se2Space()}, {1.0, 1.0});
    }

    /** \brief A compound in a compound: ((R^2, SO(3)), SO(2), R^1) with unequal weights. */
    inline ompl::base::StateSpacePtr nestedSpace()
    {
        const auto inner = compoundSpace({realVectorSpace(2), so3Space()}, {0.5, 3.0});
        return compoundSpace({inner, so2Space(), realVectorSpace(1, -2.0, 4.0)}, {2.0, 0.25, 1.5});
    }

    /** \brief R^2 and a rotation that costs nothing (weight 0). */
    inline ompl::base::StateSpacePtr weightlessRotationSpace()
    {
        return compoundSpace({realVectorSpace(2), so2Space()}, {1.0, 0.0});
    }

    struct NamedSpace
    {
        std::string name;
        std::function<ompl::base::StateSpacePtr()> make;
    };

    inline std::ostream &operator<<(std::ostream &out, const NamedSpace &space)
    {
        return out << space.name;
    }

    /** \brief One space of every supported kind. */
    inline std::vector<NamedSpace> supportedSpaces()
    {
        return {{"R1", [] { return realVectorSpace(1); }},
                {"R2", [] { return realVectorSpace(2); }},
                {"R6", [] { return realVectorSpace(6); }},
                {"SO2", so2Space},
                {"SO3", so3Space},
                {"SE2", [] { return se2Space(); }},
                {"SE3", [] { return se3Space(); }},
                {"TwoSE2", twoSe2Space},
                {"Nested", nestedSpace},
                {"WeightlessRotation", weightlessRotationSpace},
                {"Dubins", [] { return dubinsSpace(false); }},
                {"DubinsSymmetric", [] { return dubinsSpace(true); }},
                {"ReedsShepp", [] { return reedsSheppSpace(); }}};
    }

    struct SpaceName
    {
        template <typename Info>
        std::string operator()(const Info &info) const
        {
            return info.param.name;
        }
    };
}  // namespace ompl_mfa::test

#endif
