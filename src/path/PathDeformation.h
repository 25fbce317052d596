#ifndef OMPL_MFA_PATH_PATH_DEFORMATION_
#define OMPL_MFA_PATH_PATH_DEFORMATION_

#include "path/PathEvaluator.h"
#include "path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief Whether \e path seems to be of the same homotopy class as \e other: whether \e rungs motions between
       them, at equal parts of their lengths, are all valid. Two paths of one class may fail the test, and two of
       different classes pass it where what separates them lies between two rungs.

        L. Jaillet and T. Simeon, Path deformation roadmaps: compact graphs with useful cycles for motion planning, IJRR
        27(11-12), 2008, whose visibility deformation is tested here at a few places. */
    bool seemDeformable(PathEvaluator &evaluator, const Waypoints &path, const Waypoints &other,
                        unsigned int rungs = 7);
}  // namespace ompl_mfa

#endif
