#ifndef OMPL_MFA_BENCHMARK_PROBLEM_SPACE_
#define OMPL_MFA_BENCHMARK_PROBLEM_SPACE_

#include <string>

#include <ompl/base/ScopedState.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa
{
    /** \brief 2 or 3: the dimension of the positions in \e kind. */
    unsigned int positionDimension(StateSpaceKind kind);

    /** \brief The name that people give to \e kind, such as `SE(2)`. */
    std::string spaceName(StateSpaceKind kind);

    /** \brief The state space of \e problem with \e bounds for its positions. */
    ompl::base::StateSpacePtr makeStateSpace(const ProblemConfig &problem, const ompl::base::RealVectorBounds &bounds);

    /** \brief \e pose as a state of \e space, a space of \e kind, its rotation normalised. */
    ompl::base::ScopedState<> makeState(const ompl::base::StateSpacePtr &space, StateSpaceKind kind,
                                        const ConfigPose &pose);

    /** \brief \e pose as messages show it, such as "(1, 2, theta 0.5)". */
    std::string describePose(StateSpaceKind kind, const ConfigPose &pose);
}  // namespace ompl_mfa

#endif
