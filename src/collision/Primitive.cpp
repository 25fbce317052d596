#include "ompl_mfa/collision/Primitive.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

namespace ompl_mfa::collision
{
    namespace
    {
        using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
        using Dimensions = std::vector<double>;

        Geometry makeBox(const Dimensions &d)
        {
            return std::make_shared<fcl::Boxd>(d[0], d[1], d[2]);
        }

        Geometry makeSphere(const Dimensions &d)
        {
            return std::make_shared<fcl::Sphered>(d[0]);
        }

        // shape_msgs/SolidPrimitive lists the height first, FCL takes the radius first.
        Geometry makeCylinder(const Dimensions &d)
        {
            return std::make_shared<fcl::Cylinderd>(d[1], d[0]);
        }

        Geometry makeCone(const Dimensions &d)
        {
            return std::make_shared<fcl::Coned>(d[1], d[0]);
        }
    }  // namespace

    const std::vector<PrimitiveKind> &primitiveKinds()
    {
        static const std::vector<PrimitiveKind> kinds{
            {"box", 1, {"x", "y", "z"}, false, makeBox},
            {"sphere", 2, {"radius"}, true, makeSphere},
            {"cylinder", 3, {"height", "radius"}, false, makeCylinder},
            {"cone", 4, {"height", "radius"}, false, makeCone},
        };
        return kinds;
    }

    const PrimitiveKind *findPrimitiveKind(const std::string &nameOrNumber)
    {
        for (const PrimitiveKind &kind : primitiveKinds())
        {
            if (nameOrNumber == kind.name || nameOrNumber == std::to_string(kind.number))
            {
                return &kind;
            }
        }
        return nullptr;
    }

    Geometry makePrimitive(const PrimitiveKind &kind, const Dimensions &dimensions)
    {
        std::ostringstream message;
        if (dimensions.size() != kind.dimensions.size())
        {
            message << "a " << kind.name << " has " << kind.dimensions.size() << " dimensions (";
            for (std::size_t i = 0; i < kind.dimensions.size(); ++i)
            {
                message << (i == 0 ? "" : " ") << kind.dimensions[i];
            }
            message << "), not " << dimensions.size();
            throw std::invalid_argument(message.str());
        }
        for (std::size_t i = 0; i < dimensions.size(); ++i)
        {
            const bool accepted =
                std::isfinite(dimensions[i]) && (dimensions[i] > 0. || (kind.mayVanish && dimensions[i] == 0.));
            if (!accepted)
            {
                message << kind.name << ' ' << kind.dimensions[i] << " = " << dimensions[i] << ": must be "
                        << (kind.mayVanish ? "at least 0" : "greater than 0") << " and finite";
                throw std::invalid_argument(message.str());
            }
        }
        return kind.make(dimensions);
    }
}  // namespace ompl_mfa::collision
