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

#ifndef OMPL_MFA_REPORT_RESULTS_READER_
#define OMPL_MFA_REPORT_RESULTS_READER_

#include <string>
#include <vector>

#include "report/Results.h"

namespace ompl_mfa::report
{
    /** \brief The experiments in \e files, in the order of the files: journals of `ompl_mfa benchmark`, logs with their
        journals beside them, and SQLite databases of Planner Arena.

        Shards of a campaign are joined. So are experiments of the same name, seed and limits with different planners.
        Throws InputError, naming the file, if a file cannot be read or is of another kind, for experiments that cannot
        be joined, if planners have different seeds in the same run, for objectives that are maximised, and if there is
       no run at all. */
    std::vector<Experiment> readResults(const std::vector<std::string> &files);

    /** \brief The experiments in the SQLite database \e file, with the tables of `ompl_benchmark_statistics`, of any
        version and with any further columns. Throws InputError if it is no such database. */
    std::vector<Experiment> readDatabase(const std::string &file);

    /** \brief The objective in the description of a problem by OMPL; empty if it has none. */
    std::string objectiveIn(const std::string &setup);

    /** \brief The processor's model in what OMPL records of a machine, or all of that on one line. */
    std::string processorIn(const std::string &cpu);

    /** \brief The name of a planner without OMPL's "geometric_" or "control_". */
    std::string plainPlannerName(const std::string &name);
}  // namespace ompl_mfa::report

#endif
