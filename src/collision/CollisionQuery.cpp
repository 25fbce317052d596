#include "ompl_mfa/collision/CollisionQuery.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

namespace ompl_mfa::collision
{
    // An obstacle with the tightest box around it; FCL's own box is a box around a sphere once there is a rotation.
    struct CollisionQuery::Obstacle : fcl::CollisionObjectd
    {
        explicit Obstacle(const collision::CollisionObject &object)
          : fcl::CollisionObjectd(object.geometry, object.pose)
        {
            aabb = boundingBox(*object.geometry, object.pose);
        }
    };

    // One shape of a body. It owns no geometry, so that copying it, which every query does, counts no references.
    struct CollisionQuery::Part
    {
        Part(std::size_t bodyIndex, const RigidBody::Shape &shape)
          : body(bodyIndex)
          , pose(shape.pose)
          , object(std::shared_ptr<fcl::CollisionGeometryd>(std::shared_ptr<void>(), shape.geometry.get()))
        {
        }

        fcl::CollisionObjectd placed(const fcl::Transform3d *poses) const
        {
            fcl::CollisionObjectd copy(object);
            copy.setTransform(poses[body] * pose);
            copy.computeAABB();
            return copy;
        }

        std::size_t body;
        fcl::Transform3d pose;
        fcl::CollisionObjectd object;
    };

    namespace
    {
        // FCL keeps the contact that it finds in a vector: its memory is kept for the next query of the thread.
        fcl::CollisionResultd &clearedResult()
        {
            thread_local fcl::CollisionResultd result;
            result.clear();
            return result;
        }

        bool touch(const fcl::CollisionObjectd &a, const fcl::CollisionObjectd &b)
        {
            static const fcl::CollisionRequestd request;
            return fcl::collide(&a, &b, request, clearedResult()) > 0;
        }

        bool collideCallback(fcl::CollisionObjectd *obstacle, fcl::CollisionObjectd *part, void *found)
        {
            bool &collision = *static_cast<bool *>(found);
            collision = touch(*obstacle, *part);
            return collision;
        }

        void shrinkDistance(const fcl::CollisionObjectd &a, const fcl::CollisionObjectd &b, double &smallest)
        {
            static const fcl::DistanceRequestd request;
            fcl::DistanceResultd result(smallest);
            fcl::distance(&a, &b, request, result);
            smallest = std::min(smallest, std::max(0., result.min_distance));
        }

        bool distanceCallback(fcl::CollisionObjectd *obstacle, fcl::CollisionObjectd *part, void *smallest,
                              double &searchRadius)
        {
            double &distance = *static_cast<double *>(smallest);
            shrinkDistance(*obstacle, *part, distance);
            searchRadius = distance;
            return distance <= 0.;
        }
    }  // namespace

    CollisionQuery::CollisionQuery(std::shared_ptr<const Scene> scene, std::vector<RigidBody> bodies)
      : scene_(std::move(scene))
      , bodies_(std::move(bodies))
    {
        if (!scene_ || bodies_.empty())
        {
            throw std::invalid_argument("CollisionQuery: a scene and at least one body are needed");
        }
        for (const CollisionObject &object : scene_->objects())
        {
            obstacles_.push_back(std::make_unique<Obstacle>(object));
            broadphase_.registerObject(obstacles_.back().get());
        }
        broadphase_.setup();
        for (std::size_t body = 0; body < bodies_.size(); ++body)
        {
            for (const RigidBody::Shape &shape : bodies_[body].shapes())
            {
                parts_.emplace_back(body, shape);
            }
        }
    }

    CollisionQuery::~CollisionQuery() = default;

    bool CollisionQuery::collides(const fcl::Transform3d *poses) const
    {
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            fcl::CollisionObjectd part = parts_[i].placed(poses);
            bool collision = false;
            if (obstacles_.size() == 1)
            {
                collision = touch(*obstacles_.front(), part);
            }
            else
            {
                broadphase_.collide(&part, &collision, collideCallback);
            }
            for (std::size_t j = i + 1; j < parts_.size() && !collision; ++j)
            {
                if (parts_[j].body != parts_[i].body)
                {
                    const fcl::CollisionObjectd other = parts_[j].placed(poses);
                    collision = part.getAABB().overlap(other.getAABB()) && touch(part, other);
                }
            }
            if (collision)
            {
                return true;
            }
        }
        return false;
    }

    double CollisionQuery::distance(const fcl::Transform3d *poses, double limit) const
    {
        double smallest = limit;
        for (std::size_t i = 0; i < parts_.size() && smallest > 0.; ++i)
        {
            fcl::CollisionObjectd part = parts_[i].placed(poses);
            if (obstacles_.size() == 1)
            {
                shrinkDistance(*obstacles_.front(), part, smallest);
            }
            else
            {
                broadphase_.distance(&part, &smallest, distanceCallback);
            }
            for (std::size_t j = i + 1; j < parts_.size() && smallest > 0.; ++j)
            {
                if (parts_[j].body != parts_[i].body)
                {
                    const fcl::CollisionObjectd other = parts_[j].placed(poses);
                    shrinkDistance(part, other, smallest);
                }
            }
        }
        return smallest;
    }
}  // namespace ompl_mfa::collision
