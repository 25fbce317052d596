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

#include "ompl_mfa/collision/FclStateValidityChecker.h"

#include <limits>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        std::vector<RigidBody> single(RigidBody body)
        {
            std::vector<RigidBody> bodies;
            bodies.push_back(std::move(body));
            return bodies;
        }
    }  // namespace

    FclStateValidityChecker::FclStateValidityChecker(const ob::SpaceInformationPtr &si,
                                                     std::shared_ptr<const Scene> scene, std::vector<RigidBody> bodies,
                                                     MeshInterior interior)
      : ob::StateValidityChecker(si)
      , placement_(si->getStateSpace())
      , query_(std::move(scene), std::move(bodies), interior)
    {
        if (placement_.bodyCount() != query_.bodies().size())
        {
            throw InputError("state space '" + si->getStateSpace()->getName() + "' places " +
                             std::to_string(placement_.bodyCount()) + " bodies; " +
                             std::to_string(query_.bodies().size()) + " were given");
        }
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
    }

    FclStateValidityChecker::FclStateValidityChecker(const ob::SpaceInformationPtr &si,
                                                     std::shared_ptr<const Scene> scene, RigidBody body,
                                                     MeshInterior interior)
      : FclStateValidityChecker(si, std::move(scene), single(std::move(body)), interior)
    {
    }

    const fcl::Transform3d *FclStateValidityChecker::place(const ob::State *state) const
    {
        thread_local std::vector<fcl::Transform3d> poses;
        if (poses.size() < placement_.bodyCount())
        {
            poses.resize(placement_.bodyCount());
        }
        for (std::size_t body = 0; body < placement_.bodyCount(); ++body)
        {
            placement_.place(state, body, poses[body]);
        }
        return poses.data();
    }

    bool FclStateValidityChecker::isValid(const ob::State *state) const
    {
        return si_->satisfiesBounds(state) && !query_.collides(place(state));
    }

    double FclStateValidityChecker::clearance(const ob::State *state) const
    {
        return query_.distance(place(state), std::numeric_limits<double>::infinity());
    }
}  // namespace ompl_mfa::collision
