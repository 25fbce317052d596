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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_RUN_FILE_
#define OMPL_MFA_BENCHMARKS_ANYTIME_RUN_FILE_

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <tuple>

#include "anytime/RunProcess.h"

namespace ompl_mfa::anytime
{
    /** \brief The runs of a campaign in a text file, a JSON object a line, appended as they come. A campaign that was
        interrupted, at any moment, goes on from its file. */
    class RunFile
    {
    public:
        /** \brief Opens \e file, and makes it if there is none; a last line without its end, which an interruption
            leaves, is removed. Throws InputError, naming file and line, where it is not a file of runs. */
        explicit RunFile(const std::filesystem::path &file);

        /** \brief Whether there is a run of this world, planner, seed, time limit and clock. */
        bool has(const RunRequest &request) const;

        /** \brief Appends a run that has finished. */
        void append(const RunProcess &run);

    private:
        using Key = std::tuple<std::string, std::string, std::uint32_t, double, std::string>;

        static Key keyOf(const RunRequest &request);

        void readKeys(const std::filesystem::path &file);

        std::set<Key> keys_;
        std::ofstream out_;
    };
}  // namespace ompl_mfa::anytime

#endif
