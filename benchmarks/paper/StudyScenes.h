#ifndef OMPL_MFA_BENCHMARKS_PAPER_STUDY_SCENES_
#define OMPL_MFA_BENCHMARKS_PAPER_STUDY_SCENES_

#include <string>
#include <vector>

#include "paper/PathProblem.h"

namespace ompl_mfa::paper
{
    /** \brief The paper's scene with its four starting points (Fig. 9). Only the first is known; the paper does not
        print the others. \e worldFile is benchmarks/worlds/paper_scene.yaml: throws InputError if it cannot be read. */
    std::vector<PathScene> paperScenes(const std::string &worldFile);

    /** \brief Scenes of 20 m x 20 m of rising difficulty: the i-th of \e count has 3 + i obstacles, discs and turned
        rectangles in turn, drawn from the seed i. Start (1, 1) and goal (19, 19) are connected, and the straight line
        between them is not free. */
    std::vector<PathScene> seededScenes(unsigned int count);
}  // namespace ompl_mfa::paper

#endif
