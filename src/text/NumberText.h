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

#ifndef OMPL_MFA_TEXT_NUMBER_TEXT_
#define OMPL_MFA_TEXT_NUMBER_TEXT_

#include <array>
#include <charconv>
#include <ios>
#include <locale>
#include <string>
#include <string_view>
#include <system_error>

namespace ompl_mfa::text
{
    /** \brief Reads \e text, all of it, as a decimal number with a point, whatever the locale of the program is.

        A leading `+` is accepted; blanks, digit groups and hexadecimal numbers are not. Infinity and NaN are numbers.
        Returns false, and changes nothing, where the text is no number or does not fit into \e Number. */
    template <typename Number>
    bool readNumber(std::string_view text, Number &number)
    {
        if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        {
            text.remove_prefix(1);
        }
        Number read{};
        const auto result = std::from_chars(text.data(), text.data() + text.size(), read);
        if (result.ec != std::errc() || result.ptr != text.data() + text.size())
        {
            return false;
        }
        number = read;
        return true;
    }

    /** \brief The shortest text that readNumber() converts to the same number, independent of the locale. */
    inline std::string numberText(double value)
    {
        std::array<char, 32> text;
        return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
    }

    /** \brief \e value with at most \e digits significant digits, from 1 to 17, as printf's %g writes it in the locale
        "C". */
    inline std::string numberText(double value, int digits)
    {
        std::array<char, 32> text;
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
        return {text.data(), end.ptr};
    }

    /** \brief \e value with \e decimals digits behind the point, from 0 to 17, as printf's %f writes it in the locale
        "C". */
    inline std::string fixedText(double value, int decimals)
    {
        std::array<char, 352> text;
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
        return {text.data(), end.ptr};
    }

    /** \brief While it exists, a stream writes numbers as in the classic locale: with a point and no digit groups. */
    class PlainNumbers
    {
    public:
        explicit PlainNumbers(std::ios &stream)
          : stream_(stream)
          , before_(stream.imbue(std::locale::classic()))
        {
        }

        ~PlainNumbers()
        {
            stream_.imbue(before_);
        }

        PlainNumbers(const PlainNumbers &) = delete;
        PlainNumbers &operator=(const PlainNumbers &) = delete;

    private:
        std::ios &stream_;
        std::locale before_;
    };
}  // namespace ompl_mfa::text

#endif
