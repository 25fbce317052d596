/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_BENCHMARKS_PAPER_STUDY_
#define OMPL_MFA_BENCHMARKS_PAPER_STUDY_

#include <stdexcept>
#include <string>

namespace ompl_mfa::paper
{
    /** \brief Input and output of the study, and what is run. */
    struct StudyOptions
    {
        std::string worldFile;
        std::string outputFolder;
        unsigned int paperRuns{30};
        unsigned int seededRuns{10};
        unsigned int functionRuns{6};
        unsigned int sliceRuns{10};
        /** \brief Number of simultaneous runs. */
        unsigned int jobs{2};
        /** \brief Makes only the runs missing in the journals of the folder. */
        bool resume{false};
        /** \brief Discards the journals of an interrupted study. */
        bool overwrite{false};
    };

    /** \brief Thrown if a signal has stopped the study. */
    class Interrupted : public std::runtime_error
    {
    public:
        Interrupted(int signal, const std::string &message)
          : std::runtime_error(message)
          , signal_(signal)
        {
        }

        int signal() const
        {
            return signal_;
        }

    private:
        int signal_;
    };

    /** \brief m - 1 of the study's path problems. */
    constexpr unsigned int SLICES = 6;

    /** \brief The scenes and their optima: scenes.csv, obstacles.csv, optima.csv. */
    void writeScenes(const StudyOptions &options);

    /** \brief Path planning by contenders() and ablations(): runs.csv, times.csv, convergence.csv, paths.csv. */
    void studyPaths(const StudyOptions &options);

    /** \brief Path planning by the planner with all its parts: the same files, named planner_runs.csv and so on. */
    void studyPlanner(const StudyOptions &options);

    /** \brief How the result depends on the number of slices: slices.csv. */
    void studySlices(const StudyOptions &options);

    /** \brief Optimization of test functions: functions.csv, and populations.csv for eq. (19). */
    void studyFunctions(const StudyOptions &options);
}  // namespace ompl_mfa::paper

#endif
