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

#ifndef OMPL_MFA_BENCHMARK_CONFIG_LINES_
#define OMPL_MFA_BENCHMARK_CONFIG_LINES_

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief One `key = value` as written, with its place for error messages. */
    struct ConfigEntry
    {
        std::string key;
        std::string value;
        /** \brief "FILE:LINE", or the command line option. */
        std::string origin;
    };

    /** \brief A value with its place, for errors that are detected only when it is used. */
    template <typename Value>
    struct Given
    {
        Value value;
        ConfigEntry entry;
    };

    /** \brief Reads an INI-like text: `[section]`, `key = value`, `#` to the end of the line is a comment. A byte-order
        mark and CRLF line ends are accepted. Keys are returned in lower case as `section.key`, in the order of the
        text, repeated ones included. Throws InputError, naming \e file and line, for any other line.

        Boost.Program_options reads the same syntax, but its errors have no line numbers. */
    OMPL_MFA_EXPORT std::vector<ConfigEntry> readConfigLines(std::istream &in, const std::string &file);

    /** \brief The value as a finite number; throws InputError if it is not one. */
    OMPL_MFA_EXPORT double realValue(const ConfigEntry &entry);

    /** \brief The value as a whole number in [\e first, \e last]; throws InputError if it is not one. */
    OMPL_MFA_EXPORT std::uint_fast64_t wholeValue(const ConfigEntry &entry, std::uint_fast64_t first,
                                                  std::uint_fast64_t last);

    /** \brief 0, 1, true, false, yes, no, on or off; throws InputError for anything else. */
    OMPL_MFA_EXPORT bool switchValue(const ConfigEntry &entry);

    /** \brief The index of the value in \e accepted; throws InputError, listing \e accepted, if it is not among
        them. */
    OMPL_MFA_EXPORT std::size_t choiceValue(const ConfigEntry &entry, const std::vector<std::string> &accepted);

    /** \brief Throws InputError: "ORIGIN: \e message". */
    [[noreturn]] OMPL_MFA_EXPORT void failAt(const std::string &origin, const std::string &message);

    /** \brief Throws InputError: "ORIGIN: KEY = VALUE: \e message". */
    [[noreturn]] OMPL_MFA_EXPORT void failAt(const ConfigEntry &entry, const std::string &message);
}  // namespace ompl_mfa::benchmark

#endif
