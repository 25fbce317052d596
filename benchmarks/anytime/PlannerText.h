#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_TEXT_
#define OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_TEXT_

#include <string>
#include <vector>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::anytime
{
    /** \brief RRT*, Informed RRT*, PRM*, BIT*, ABIT*, AIT*, AnytimePathShortening and those of EIT*, BLIT* and AORRTC
        that the linked OMPL has; RRT-Connect for its first solutions. */
    std::vector<std::string> peers();

    /** \brief Splits `A,B:KEY=VALUE,KEY=VALUE,C` into `A`, `B:KEY=VALUE,KEY=VALUE` and `C`; `peers` stands for all
        peers(). Throws InputError for an empty list. */
    std::vector<std::string> splitPlanners(const std::string &text);

    /** \brief Reads `PLANNER` or `PLANNER:KEY=VALUE,...`. Throws InputError where the planner is not known or the text
        has another form; the parameters are checked when the planner is made. */
    PlannerSpec parsePlanner(const std::string &text);
}  // namespace ompl_mfa::anytime

#endif
