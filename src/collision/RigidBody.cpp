#include "ompl_mfa/collision/RigidBody.h"

#include <algorithm>
#include <stdexcept>

#include "collision/ShapeReach.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    RigidBody::RigidBody(std::vector<Shape> shapes)
      : shapes_(std::move(shapes))
    {
        if (shapes_.empty())
        {
            throw std::invalid_argument("RigidBody: a body needs at least one shape");
        }
        for (const Shape &shape : shapes_)
        {
            if (!shape.geometry)
            {
                throw std::invalid_argument("RigidBody: a shape has no geometry");
            }
            const ShapeReach reach = shapeReach(*shape.geometry, shape.pose);
            radius_ = std::max(radius_, reach.core + reach.margin);
            planarRadius_ = std::max(planarRadius_, reach.planarCore + reach.margin);
        }
    }

    std::size_t RigidBody::skippedFaces() const
    {
        std::size_t faces = 0;
        for (const Shape &shape : shapes_)
        {
            faces += shape.skippedFaces;
        }
        return faces;
    }

    fcl::AABBd RigidBody::bounds() const
    {
        fcl::AABBd box;
        for (const Shape &shape : shapes_)
        {
            box += boundingBox(*shape.geometry, shape.pose);
        }
        return box;
    }

    RigidBody RigidBody::sphere(double radius)
    {
        return RigidBody({{makePrimitive(*findPrimitiveKind("sphere"), {radius})}});
    }

    RigidBody RigidBody::box(double lengthX, double lengthY, double lengthZ)
    {
        return RigidBody({{makePrimitive(*findPrimitiveKind("box"), {lengthX, lengthY, lengthZ})}});
    }
}  // namespace ompl_mfa::collision
