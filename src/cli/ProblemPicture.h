#ifndef OMPL_MFA_CLI_PROBLEM_PICTURE_
#define OMPL_MFA_CLI_PROBLEM_PICTURE_

#include <string>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ompl_mfa::cli
{
    /** \brief What a picture of a planning result shows besides the problem. */
    struct PictureContent
    {
        std::string title;
        /** \brief Pairs of states between which a slice lies. */
        std::vector<ompl::geometric::PathGeometric> slices;
        /** \brief Drawn faintly. */
        std::vector<ompl::geometric::PathGeometric> swarm;
        /** \brief The best path; empty for none. */
        std::vector<ompl::geometric::PathGeometric> best;
    };

    /** \brief Draws the obstacles, the robot at start and goal and on its way, and \e content.

        A planar problem is seen from above, with the part of the world at the robot's height; a spatial one from above
        and from the side, with all of the world. The
        extension of \e file is its format. Throws InputError if it cannot be written, or as pictureFormat(). */
    void drawProblem(const ProblemFactory &problem, const ompl::geometric::SimpleSetup &setup,
                     const PictureContent &content, const std::string &file);
}  // namespace ompl_mfa::cli

#endif
