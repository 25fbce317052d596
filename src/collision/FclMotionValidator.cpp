#include "ompl_mfa/collision/FclMotionValidator.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/DiscreteMotionValidator.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    MotionValidation parseMotionValidation(const std::string &name)
    {
        if (name == "discrete")
        {
            return MotionValidation::Discrete;
        }
        if (name == "continuous")
        {
            return MotionValidation::Continuous;
        }
        throw InputError("motion_validation = " + name + ": must be discrete or continuous");
    }

    FclMotionValidator::FclMotionValidator(const ob::SpaceInformationPtr &si,
                                           std::shared_ptr<const FclStateValidityChecker> checker)
      : ob::MotionValidator(si)
      , checker_(std::move(checker))
      , clearanceTolerance_(1e-6)
    {
        if (!checker_->placement().interpolatesStraight())
        {
            throw InputError("motion_validation = continuous: state space '" + si->getStateSpace()->getName() +
                             "' does not interpolate straight; it must be discrete");
        }
    }

    bool FclMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const bool valid = si_->isValid(s2) && advance(s1, s2) >= 1.;
        ++(valid ? valid_ : invalid_);
        return valid;
    }

    bool FclMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                         std::pair<ob::State *, double> &lastValid) const
    {
        const double reached = advance(s1, s2);
        const bool valid = reached >= 1. && si_->isValid(s2);
        if (!valid)
        {
            lastValid.second = std::min(reached, std::nextafter(1., 0.));
            if (lastValid.first != nullptr)
            {
                si_->getStateSpace()->interpolate(s1, s2, lastValid.second, lastValid.first);
            }
        }
        ++(valid ? valid_ : invalid_);
        return valid;
    }

    double FclMotionValidator::advance(const ob::State *s1, const ob::State *s2) const
    {
        const StatePlacement &placement = checker_->placement();
        double travel = 0.;
        for (std::size_t body = 0; body < placement.bodyCount(); ++body)
        {
            fcl::Transform3d a;
            fcl::Transform3d b;
            placement.place(s1, body, a);
            placement.place(s2, body, b);
            const RigidBody &shape = checker_->query().bodies()[body];
            const double radius = placement.isPlanar(body) ? shape.planarRadius() : shape.radius();
            const double angle = Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
            travel = std::max(travel, (b.translation() - a.translation()).norm() + angle * radius);
        }
        // Two bodies may come toward each other.
        travel *= placement.bodyCount() > 1 ? 2. : 1.;

        ob::State *state = si_->allocState();
        double reached = 0.;
        double next = 0.;
        while (reached < 1.)
        {
            si_->getStateSpace()->interpolate(s1, s2, next, state);
            si_->enforceBounds(state);
            const double distance = checker_->clearance(state);
            if (distance <= clearanceTolerance_)
            {
                break;
            }
            reached = next;
            if (reached >= 1. || distance >= (1. - reached) * travel)
            {
                reached = 1.;
            }
            next = std::min(1., reached + distance / travel);
        }
        si_->freeState(state);
        return reached;
    }

    void setCollisionChecking(const ob::SpaceInformationPtr &si,
                              const std::shared_ptr<FclStateValidityChecker> &checker, MotionValidation validation)
    {
        si->setStateValidityChecker(checker);
        if (validation == MotionValidation::Continuous)
        {
            si->setMotionValidator(std::make_shared<FclMotionValidator>(si, checker));
        }
        else
        {
            si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
        }
    }
}  // namespace ompl_mfa::collision
