#ifndef OMPL_MFA_BENCHMARKS_PAPER_PAGMO_CONTENDER_
#define OMPL_MFA_BENCHMARKS_PAPER_PAGMO_CONTENDER_

#include <string>

#include <Eigen/Core>

#include "paper/Recorder.h"

namespace ompl_mfa::paper
{
    /** \brief ga (pagmo's sga), pso, de, sade, cmaes, abc (bee_colony) and gwo. */
    bool isPagmoContender(const std::string &algorithm);

    /** \brief Runs the algorithm with 100 individuals on the unit cube scaled to the box until \e recorder is spent.
       One that stops by itself, having converged, starts again with a new random population. */
    void runPagmo(const std::string &algorithm, Recorder &recorder, const Eigen::VectorXd &lower,
                  const Eigen::VectorXd &upper, unsigned int seed);
}  // namespace ompl_mfa::paper

#endif
