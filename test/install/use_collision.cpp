#include <memory>

#include <fcl/geometry/shape/sphere.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl_mfa/collision/FclStateValidityChecker.h>

namespace ob = ompl::base;
namespace oc = ompl_mfa::collision;

/* A disc of radius 0.1 beside a ball of radius 0.5 about the origin. */
int main()
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(-1.0, 1.0);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    oc::Scene scene;
    scene.add({"ball", std::make_shared<fcl::Sphered>(0.5), fcl::Transform3d::Identity()});
    si->setStateValidityChecker(std::make_shared<oc::FclStateValidityChecker>(
        si, std::make_shared<const oc::Scene>(scene), oc::RigidBody::sphere(0.1)));
    si->setup();
    ob::ScopedState<> apart(space);
    apart = std::vector<double>{0.7, 0.0};
    ob::ScopedState<> inside(space);
    inside = std::vector<double>{0.55, 0.0};
    return si->isValid(apart.get()) && !si->isValid(inside.get()) ? 0 : 1;
}
