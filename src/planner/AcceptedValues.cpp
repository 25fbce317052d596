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

#include "planner/AcceptedValues.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

#include "text/NumberText.h"

namespace ompl_mfa::planner
{
    namespace
    {
        std::string joined(const std::vector<std::string> &words, const char *separator)
        {
            std::string text;
            for (const auto &word : words)
            {
                text += (text.empty() ? "" : separator) + word;
            }
            return text;
        }

        /* OMPL's user interfaces distinguish real from whole numbers by the decimal point in a suggested range. */
        template <typename T>
        std::string suggested(T value)
        {
            std::string text = AcceptedValues<T>::write(value);
            if (std::is_floating_point_v<T> && text.find_first_of(".e") == std::string::npos)
            {
                text += ".0";
            }
            return text;
        }
    }  // namespace

    template <typename T>
    bool AcceptedValues<T>::read(const std::string &text, T &value)
    {
        return text::readNumber(text, value);
    }

    template <typename T>
    std::string AcceptedValues<T>::write(T value)
    {
        std::array<char, 32> text{};
        char *const end = text.data() + text.size();
        if constexpr (std::is_floating_point_v<T>)
        {
            // 100000 is more readable than the shortest text, 1e+05
            const double size = std::abs(value);
            if (value == 0.0 || (size >= 1e-4 && size < 1e15))
            {
                return {text.data(), std::to_chars(text.data(), end, value, std::chars_format::fixed).ptr};
            }
        }
        return {text.data(), std::to_chars(text.data(), end, value).ptr};
    }

    template <typename T>
    std::string AcceptedValues<T>::suggestion() const
    {
        return suggested(apart_.value_or(lowest_)) + ':' + suggested(step_) + ':' + suggested(highest_);
    }

    template <typename T>
    std::string AcceptedValues<T>::description() const
    {
        return (apart_ ? write(*apart_) + ", " : "") + write(lowest_) + " to " + write(highest_);
    }

    template class AcceptedValues<unsigned int>;
    template class AcceptedValues<double>;

    AcceptedValues<std::string>::AcceptedValues(std::vector<std::string> words)
      : words_(std::move(words))
    {
    }

    bool AcceptedValues<std::string>::contains(const std::string &value) const
    {
        return std::find(words_.begin(), words_.end(), value) != words_.end();
    }

    bool AcceptedValues<std::string>::read(const std::string &text, std::string &value)
    {
        value = text;
        return true;
    }

    std::string AcceptedValues<std::string>::write(const std::string &value)
    {
        return value;
    }

    std::string AcceptedValues<std::string>::suggestion() const
    {
        return joined(words_, ",");
    }

    std::string AcceptedValues<std::string>::description() const
    {
        return joined(words_, ", ");
    }

    bool AcceptedValues<bool>::contains(bool /*value*/) const
    {
        return true;
    }

    bool AcceptedValues<bool>::read(const std::string &text, bool &value)
    {
        std::string word = text;
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        const bool on = word == "1" || word == "t" || word == "true";
        const bool off = word == "0" || word == "f" || word == "false";
        if (on || off)
        {
            value = on;
        }
        return on || off;
    }

    std::string AcceptedValues<bool>::write(bool value)
    {
        return value ? "1" : "0";
    }

    std::string AcceptedValues<bool>::suggestion() const
    {
        return "0,1";
    }

    std::string AcceptedValues<bool>::description() const
    {
        return "0, 1, false, true";
    }
}  // namespace ompl_mfa::planner
