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

#include "ompl_mfa/collision/CollisionQuery.h"

#include <algorithm>
#include <stdexcept>

#include "collision/QueryShapes.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Poses of all shapes of the bodies; the memory is reused by the next query of the thread.
        fcl::Transform3d *scratchPoses(std::size_t count)
        {
            thread_local std::vector<fcl::Transform3d> poses;
            if (poses.size() < count)
            {
                poses.resize(count);
            }
            return poses.data();
        }
    }  // namespace

    // Data of a query for the callbacks of the broadphase.
    struct CollisionQuery::PartQuery
    {
        const Part &part;
        const fcl::Transform3d &world;
        bool collision{false};
        double smallest{0.};
    };

    struct CollisionQuery::Sweep
    {
        const BodyMotion *motions;
        double tolerance;
        bool untilFirst;
        const Part *part{nullptr};
        double reached{1.};

        bool isDone() const
        {
            return reached <= 0. || (untilFirst && reached < 1.);
        }

        void advance(const PairFunctions &functions, const MovingShape &other)
        {
            reached = advancePair(functions, part->moving(motions), other, {tolerance, untilFirst}, reached);
        }
    };

    CollisionQuery::CollisionQuery(std::shared_ptr<const Scene> scene, std::vector<RigidBody> bodies,
                                   MeshInterior interior)
      : scene_(std::move(scene))
      , bodies_(std::move(bodies))
      , solidInteriors_(interior == MeshInterior::Solid)
    {
        if (!scene_ || bodies_.empty())
        {
            throw std::invalid_argument("CollisionQuery: a scene and at least one body are needed");
        }
        addObstacles();
        for (std::size_t body = 0; body < bodies_.size(); ++body)
        {
            for (const RigidBody::Shape &shape : bodies_[body].shapes())
            {
                parts_.emplace_back(body, shape);
                if (solidInteriors_)
                {
                    parts_.back().solid =
                        std::make_unique<SolidInterior>(*shape.geometry, "robot body " + std::to_string(body));
                }
            }
        }
        findPairs();
    }

    void CollisionQuery::addObstacles()
    {
        for (const CollisionObject &object : scene_->objects())
        {
            obstacles_.push_back(std::make_unique<Obstacle>(object, obstacles_.size()));
            if (solidInteriors_)
            {
                obstacles_.back()->solid =
                    std::make_unique<SolidInterior>(*object.geometry, "obstacle '" + object.id + "'");
            }
            broadphase_.registerObject(obstacles_.back().get());
        }
        broadphase_.setup();
    }

    void CollisionQuery::findPairs()
    {
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            for (std::size_t j = i + 1; j < parts_.size(); ++j)
            {
                if (parts_[i].body != parts_[j].body)
                {
                    bodyPairs_.emplace_back(i, j);
                }
            }
        }
        for (Part &part : parts_)
        {
            for (const auto &obstacle : obstacles_)
            {
                part.obstacleFunctions.push_back(pairFunctions(*part.geometry, *obstacle->geometry));
            }
            for (const Part &other : parts_)
            {
                part.partFunctions.push_back(pairFunctions(*part.geometry, *other.geometry));
            }
        }
    }

    CollisionQuery::~CollisionQuery() = default;

    bool CollisionQuery::collideCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd * /*part*/, void *query)
    {
        auto &state = *static_cast<PartQuery *>(query);
        const auto &obstacle = static_cast<const Obstacle &>(*object);
        state.collision = state.part.obstacleFunctions[obstacle.index].collide(*state.part.geometry, state.world,
                                                                               *obstacle.geometry, obstacle.pose);
        return state.collision;
    }

    bool CollisionQuery::distanceCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd * /*part*/, void *query,
                                          double &searchRadius)
    {
        auto &state = *static_cast<PartQuery *>(query);
        const auto &obstacle = static_cast<const Obstacle &>(*object);
        DistanceSearch search{state.smallest};
        state.smallest = state.part.obstacleFunctions[obstacle.index].distance(
            *state.part.geometry, state.world, *obstacle.geometry, obstacle.pose, search);
        searchRadius = state.smallest;
        return state.smallest <= 0.;
    }

    bool CollisionQuery::overlapCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd *part, void *query)
    {
        double searchRadius = 0.;
        distanceCallback(object, part, query, searchRadius);
        return false;
    }

    bool CollisionQuery::advanceCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd * /*part*/, void *query)
    {
        auto &sweep = *static_cast<Sweep *>(query);
        const auto &obstacle = static_cast<const Obstacle &>(*object);
        sweep.advance(sweep.part->obstacleFunctions[obstacle.index], obstacle.atRest());
        return sweep.isDone();
    }

    bool CollisionQuery::collides(const fcl::Transform3d *poses) const
    {
        fcl::Transform3d *worlds = scratchPoses(parts_.size());
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            parts_[i].place(poses, worlds[i]);
            if (hitsObstacle(parts_[i], worlds[i]))
            {
                return true;
            }
        }
        for (const auto &[i, j] : bodyPairs_)
        {
            if (parts_[i].partFunctions[j].collide(*parts_[i].geometry, worlds[i], *parts_[j].geometry, worlds[j]))
            {
                return true;
            }
        }
        return solidInteriors_ && isInside(worlds);
    }

    bool CollisionQuery::hitsObstacle(const Part &part, const fcl::Transform3d &world) const
    {
        if (obstacles_.size() == 1)
        {
            const Obstacle &obstacle = *obstacles_.front();
            return part.obstacleFunctions[0].collide(*part.geometry, world, *obstacle.geometry, obstacle.pose);
        }
        PartQuery query{part, world};
        PlacedShape placed(part, world);
        broadphase_.collide(&placed, &query, collideCallback);
        return query.collision;
    }

    bool CollisionQuery::isInside(const fcl::Transform3d *worlds) const
    {
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            for (const auto &obstacle : obstacles_)
            {
                if (SolidInterior::oneHoldsTheOther(*parts_[i].solid, worlds[i], *obstacle->solid, obstacle->pose))
                {
                    return true;
                }
            }
        }
        return std::any_of(bodyPairs_.begin(), bodyPairs_.end(),
                           [this, worlds](const std::pair<std::size_t, std::size_t> &pair)
                           {
                               return SolidInterior::oneHoldsTheOther(*parts_[pair.first].solid, worlds[pair.first],
                                                                      *parts_[pair.second].solid, worlds[pair.second]);
                           });
    }

    double CollisionQuery::distance(const fcl::Transform3d *poses, double limit) const
    {
        fcl::Transform3d *worlds = scratchPoses(parts_.size());
        double smallest = limit;
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            parts_[i].place(poses, worlds[i]);
            smallest = distanceToObstacles(parts_[i], worlds[i], smallest);
        }
        for (const auto &[i, j] : bodyPairs_)
        {
            DistanceSearch search{smallest};
            smallest = std::min(smallest, parts_[i].partFunctions[j].distance(*parts_[i].geometry, worlds[i],
                                                                              *parts_[j].geometry, worlds[j], search));
        }
        if (smallest > 0. && solidInteriors_ && isInside(worlds))
        {
            return 0.;
        }
        return smallest > 0. ? smallest : -deepestOverlap(worlds);
    }

    double CollisionQuery::deepestOverlap(const fcl::Transform3d *worlds) const
    {
        double smallest = 0.;
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            PartQuery query{parts_[i], worlds[i], false, smallest};
            PlacedShape placed(parts_[i], worlds[i]);
            broadphase_.collide(&placed, &query, overlapCallback);
            smallest = query.smallest;
        }
        for (const auto &[i, j] : bodyPairs_)
        {
            DistanceSearch search{smallest};
            smallest = std::min(smallest, parts_[i].partFunctions[j].distance(*parts_[i].geometry, worlds[i],
                                                                              *parts_[j].geometry, worlds[j], search));
        }
        return -smallest;
    }

    double CollisionQuery::distanceToObstacles(const Part &part, const fcl::Transform3d &world, double smallest) const
    {
        if (obstacles_.size() == 1)
        {
            const Obstacle &obstacle = *obstacles_.front();
            DistanceSearch search{smallest};
            return part.obstacleFunctions[0].distance(*part.geometry, world, *obstacle.geometry, obstacle.pose, search);
        }
        PartQuery query{part, world, false, smallest};
        PlacedShape placed(part, world);
        broadphase_.distance(&placed, &query, distanceCallback);
        return query.smallest;
    }

    double CollisionQuery::advance(const BodyMotion *motions, double tolerance, bool untilFirst) const
    {
        Sweep sweep{motions, tolerance, untilFirst};
        for (const Part &part : parts_)
        {
            sweep.part = &part;
            PlacedShape swept(part, motions[part.body], part.reach.core + part.reach.margin + tolerance);
            broadphase_.collide(&swept, &sweep, advanceCallback);
            if (sweep.isDone())
            {
                return sweep.reached;
            }
        }
        for (const auto &[i, j] : bodyPairs_)
        {
            sweep.part = &parts_[i];
            sweep.advance(parts_[i].partFunctions[j], parts_[j].moving(motions));
            if (sweep.isDone())
            {
                break;
            }
        }
        return sweep.reached;
    }
}  // namespace ompl_mfa::collision
