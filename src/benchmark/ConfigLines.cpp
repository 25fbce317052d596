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

#include "ompl_mfa/benchmark/ConfigLines.h"

#include <algorithm>
#include <cmath>
#include <istream>

#include <boost/algorithm/string.hpp>
#include <boost/locale/encoding_utf.hpp>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        const std::string BYTE_ORDER_MARK = "\xEF\xBB\xBF";

        bool isUtf8(const std::string &text)
        {
            try
            {
                boost::locale::conv::utf_to_utf<char32_t>(text, boost::locale::conv::stop);
                return true;
            }
            catch (const boost::locale::conv::conversion_error &)
            {
                return false;
            }
        }

        ConfigEntry parseEntry(const std::string &line, const std::string &section, const std::string &origin)
        {
            const auto equals = line.find('=');
            if (equals == std::string::npos)
            {
                failAt(origin, "'" + line + "' is neither '[section]' nor 'key = value'");
            }
            ConfigEntry entry{lowerCase(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)), origin};
            if (entry.key.empty())
            {
                failAt(origin, "'" + line + "' has no key before '='");
            }
            if (!section.empty())
            {
                entry.key = section + "." + entry.key;
            }
            return entry;
        }
    }  // namespace

    std::vector<ConfigEntry> readConfigLines(std::istream &in, const std::string &file)
    {
        std::vector<ConfigEntry> entries;
        std::string section;
        std::string line;
        for (unsigned int number = 1; std::getline(in, line); ++number)
        {
            if (number == 1 && boost::starts_with(line, BYTE_ORDER_MARK))
            {
                line.erase(0, BYTE_ORDER_MARK.size());
            }
            const std::string origin = file + ":" + std::to_string(number);
            if (line.find('\0') != std::string::npos)
            {
                failAt(origin, "a NUL character; the file is to be UTF-8 text");
            }
            line.erase(std::find(line.begin(), line.end(), '#'), line.end());
            line = trimmed(line);
            if (line.empty())
            {
                continue;
            }
            // Names are written to logs and JSON documents, which are UTF-8; comments may contain any bytes.
            if (!isUtf8(line))
            {
                failAt(origin, "the file is to be UTF-8 text");
            }
            if (line.front() == '[')
            {
                if (line.back() != ']')
                {
                    failAt(origin, "'" + line + "' has no closing ']'");
                }
                section = lowerCase(trimmed(line.substr(1, line.size() - 2)));
            }
            else
            {
                entries.push_back(parseEntry(line, section, origin));
            }
        }
        return entries;
    }

    double realValue(const ConfigEntry &entry)
    {
        double number = 0.0;
        if (!text::readNumber(entry.value, number) || !std::isfinite(number))
        {
            failAt(entry, "expected a finite number");
        }
        return number;
    }

    std::uint_fast64_t wholeValue(const ConfigEntry &entry, std::uint_fast64_t first, std::uint_fast64_t last)
    {
        std::uint_fast64_t number = 0;
        if (!text::readNumber(entry.value, number) || number < first || number > last)
        {
            failAt(entry, "expected a whole number from " + std::to_string(first) + " to " + std::to_string(last));
        }
        return number;
    }

    bool switchValue(const ConfigEntry &entry)
    {
        return choiceValue(entry, {"0", "1", "false", "true", "no", "yes", "off", "on"}) % 2 == 1;
    }

    std::size_t choiceValue(const ConfigEntry &entry, const std::vector<std::string> &accepted)
    {
        const auto found = std::find(accepted.begin(), accepted.end(), lowerCase(entry.value));
        if (found == accepted.end())
        {
            failAt(entry, "expected one of " + boost::algorithm::join(accepted, ", "));
        }
        return static_cast<std::size_t>(found - accepted.begin());
    }

    void failAt(const std::string &origin, const std::string &message)
    {
        throw InputError(origin + ": " + message);
    }

    void failAt(const ConfigEntry &entry, const std::string &message)
    {
        failAt(entry.origin, entry.key + " = " + entry.value + ": " + message);
    }
}  // namespace ompl_mfa::benchmark
