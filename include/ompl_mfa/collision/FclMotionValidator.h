#ifndef OMPL_MFA_COLLISION_FCL_MOTION_VALIDATOR_
#define OMPL_MFA_COLLISION_FCL_MOTION_VALIDATOR_

#include <memory>
#include <string>
#include <utility>

#include <ompl/base/MotionValidator.h>

#include "ompl_mfa/collision/FclStateValidityChecker.h"

namespace ompl_mfa::collision
{
    /** \brief How motions between two states are checked. */
    enum class MotionValidation
    {
        /** \brief OMPL's DiscreteMotionValidator: states at the resolution of the space. */
        Discrete,

        /** \brief FclMotionValidator: all of the motion. */
        Continuous
    };

    /** \brief `discrete` or `continuous`.
        \throw InputError naming the value. */
    MotionValidation parseMotionValidation(const std::string &name);

    /** \brief Continuous motion validation by conservative advancement.

        From a pose with distance d to the obstacles no part of the body can reach one before it has travelled d; the
        travel is bounded by the translation plus the rotation times the radius of the body about its reference point.
        The motion is advanced by as much, again and again, so that no obstacle is missed however thin. A motion that
        comes closer than clearanceTolerance() to an obstacle counts as a collision.

        Source: B. Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, UC Berkeley, 1996. */
    class FclMotionValidator : public ompl::base::MotionValidator
    {
    public:
        /** \throw InputError where the space does not interpolate straight (Dubins, Reeds-Shepp). */
        FclMotionValidator(const ompl::base::SpaceInformationPtr &si,
                           std::shared_ptr<const FclStateValidityChecker> checker);

        /** \brief Whether all of the motion is valid; `s1` is taken to be valid. */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief The same, and where the motion is invalid, `lastValid` is set to the last state that was found
            valid (if its first is not null) and the share of the motion up to it, in [0, 1). */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief Distance, in the units of the world, below which a body counts as touching: 1e-7 of the diagonal of
            the scene. */
        double clearanceTolerance() const
        {
            return clearanceTolerance_;
        }

    private:
        double advance(const ompl::base::State *s1, const ompl::base::State *s2, bool untilFirst) const;

        /** \brief Share, at most `reached`, up to which the motion stays within the bounds of the space. */
        double shareWithinBounds(const ompl::base::State *s1, const ompl::base::State *s2, double reached) const;

        std::shared_ptr<const FclStateValidityChecker> checker_;
        double clearanceTolerance_;
    };

    /** \brief Give `si` the checker and the motion validator.
        \throw InputError as the constructor of FclMotionValidator does. */
    void setCollisionChecking(const ompl::base::SpaceInformationPtr &si,
                              const std::shared_ptr<FclStateValidityChecker> &checker, MotionValidation validation);
}  // namespace ompl_mfa::collision

#endif
