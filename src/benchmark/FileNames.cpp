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

#include "benchmark/FileNames.h"

#include <algorithm>
#include <cstdlib>

#include "ompl_mfa/benchmark/ConfigLines.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        bool isControlCharacter(char letter)
        {
            const auto byte = static_cast<unsigned char>(letter);
            return byte < 32 || byte == 127;
        }
    }  // namespace

    std::string fileNamePart(const std::string &name)
    {
        const char *const digits = "0123456789ABCDEF";
        std::string part;
        for (const char letter : name)
        {
            if (letter == '/' || letter == '%' || isControlCharacter(letter))
            {
                const auto byte = static_cast<unsigned char>(letter);
                part += {'%', digits[byte / 16], digits[byte % 16]};
            }
            else
            {
                part += letter;
            }
        }
        return part;
    }

    bool hasControlCharacter(const std::string &text)
    {
        return std::any_of(text.begin(), text.end(), isControlCharacter);
    }

    bool isFileName(const std::string &name)
    {
        return !name.empty() && name != "." && name != ".." && name.size() <= LONGEST_NAME &&
               name.find('/') == std::string::npos && !hasControlCharacter(name);
    }

    std::filesystem::path writtenPath(const std::string &path, const std::string &origin)
    {
        if (hasControlCharacter(path))
        {
            failAt(origin, "a path without control characters is accepted");
        }
        const bool isAtHome = path == "~" || path.compare(0, 2, "~/") == 0;
        const std::string rest = isAtHome ? path.substr(std::min<std::size_t>(path.size(), 2)) : path;
        if (!isAtHome && path.compare(0, 1, "~") == 0)
        {
            failAt(origin, "the home folder of another user is not looked up; '~/...' is that of this one");
        }
        for (const std::filesystem::path &component : std::filesystem::path(rest))
        {
            if (component == "~")
            {
                failAt(origin, "no folder may be called '~'; '~/...' is the home folder");
            }
        }
        if (!isAtHome)
        {
            return path;
        }
        const char *home = std::getenv("HOME");
        if (home == nullptr || *home == '\0')
        {
            failAt(origin, "'~' is the folder that the environment variable HOME names, and it is not set");
        }
        // A path that begins with '/' would replace the home folder: '~//a' is '~/a'.
        return std::filesystem::path(home) / rest.substr(std::min(rest.size(), rest.find_first_not_of('/')));
    }
}  // namespace ompl_mfa::benchmark
