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

#include "benchmark/LogText.h"

#include <algorithm>
#include <cmath>
#include <locale>

#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    /* "-nan" and "-inf" make ompl_benchmark_statistics fail; a separator inside a value would shift all columns. */
    std::string cleanValue(const std::string &value)
    {
        double number = 0.0;
        if (text::readNumber(value, number) && !std::isfinite(number))
        {
            return std::isinf(number) && number > 0.0 ? "inf" : "nan";
        }
        std::string clean = value;
        std::replace_if(
            clean.begin(), clean.end(),
            [](char letter) { return letter == ';' || letter == ',' || letter == '\n' || letter == '\r'; }, ' ');
        return clean;
    }

    std::string oneWord(const std::string &text)
    {
        std::string word = text.empty() ? "NO_NAME" : text;
        std::replace_if(
            word.begin(), word.end(), [](char letter) { return std::isspace(letter, std::locale::classic()); }, '_');
        return word;
    }

    std::string progressTime(double seconds)
    {
        return text::fixedText(seconds, 6);
    }

    std::set<std::string> propertyNames(const PlannerLog &planner)
    {
        std::set<std::string> names;
        for (const LogProperties &run : planner.runs)
        {
            for (const auto &property : run)
            {
                names.insert(property.first);
            }
        }
        return names;
    }
}  // namespace ompl_mfa::benchmark
