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

#ifndef OMPL_MFA_BENCHMARK_FILE_NAMES_
#define OMPL_MFA_BENCHMARK_FILE_NAMES_

#include <filesystem>
#include <string>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief Maximum length in bytes of a name within a file name: with the additions for logs, shards and paths, the
        whole stays within the 255 bytes that file systems accept. */
    constexpr std::size_t LONGEST_NAME = 100;

    /** \brief \e name for use within a file name: `/`, `%` and control characters are written as `%` and two
        hexadecimal digits, so that different names remain different and none contains a folder. */
    OMPL_MFA_EXPORT std::string fileNamePart(const std::string &name);

    /** \brief Whether \e text contains a control character: a byte below 32, or 127. */
    OMPL_MFA_EXPORT bool hasControlCharacter(const std::string &text);

    /** \brief Whether \e name is a valid file name: neither empty nor `.` nor `..`, at most LONGEST_NAME bytes, without
        `/` and control characters. */
    OMPL_MFA_EXPORT bool isFileName(const std::string &name);

    /** \brief Expands a path given by a user: `~` and `~/...` refer to the folder in the environment variable HOME, as
        in a shell. Throws InputError "\e origin: ..." for a control character, for `~NAME`, for a folder named `~`, and
        if HOME is needed but not set. */
    OMPL_MFA_EXPORT std::filesystem::path writtenPath(const std::string &path, const std::string &origin);
}  // namespace ompl_mfa::benchmark

#endif
