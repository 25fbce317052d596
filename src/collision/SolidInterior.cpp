#include "collision/SolidInterior.h"

#include <algorithm>

#include "collision/ShapeKinds.h"

namespace ompl_mfa::collision
{
    SolidInterior::SolidInterior(const fcl::CollisionGeometryd &geometry, const std::string &name)
    {
        visitShape(geometry,
                   Overloaded{[this, &name](const MeshGeometry &mesh)
                              {
                                  inside_ = std::make_unique<ClosedMesh>(mesh, name);
                                  witnesses_ = ClosedMesh::partVertices(mesh);
                              },
                              [this](const OccupancyTree &map)
                              {
                                  for (const auto &cell : map.toBoxes())
                                  {
                                      witnesses_.emplace_back(cell[0], cell[1], cell[2]);
                                  }
                              },
                              [this](const auto & /*primitive*/) { witnesses_.emplace_back(fcl::Vector3d::Zero()); }});
    }

    bool SolidInterior::holds(const fcl::Transform3d &pose, const SolidInterior &other,
                              const fcl::Transform3d &otherPose) const
    {
        if (!inside_)
        {
            return false;
        }
        const fcl::Transform3d relative = pose.inverse() * otherPose;
        return std::any_of(other.witnesses_.begin(), other.witnesses_.end(),
                           [this, &relative](const fcl::Vector3d &witness)
                           { return inside_->contains(relative * witness); });
    }

    bool SolidInterior::oneHoldsTheOther(const SolidInterior &a, const fcl::Transform3d &poseA, const SolidInterior &b,
                                         const fcl::Transform3d &poseB)
    {
        return a.holds(poseA, b, poseB) || b.holds(poseB, a, poseA);
    }
}  // namespace ompl_mfa::collision
