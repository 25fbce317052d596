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

#ifndef OMPL_MFA_PLAIN_TEXT_
#define OMPL_MFA_PLAIN_TEXT_

#include <string>

namespace ompl_mfa
{
    /** \brief \e text with the letters A to Z in lower case, in any locale. */
    inline std::string lowerCase(std::string text)
    {
        for (char &letter : text)
        {
            if (letter >= 'A' && letter <= 'Z')
            {
                letter = static_cast<char>(letter - 'A' + 'a');
            }
        }
        return text;
    }

    /** \brief \e text as one line that leaves a terminal as it is: line ends and tabs become blanks, other control
        characters (NUL, escapes, U+0080 to U+009F) `\\x` and two hexadecimal digits. */
    inline std::string oneLine(const std::string &text)
    {
        const char *const digits = "0123456789abcdef";
        std::string line;
        for (std::size_t i = 0; i < text.size(); ++i)
        {
            auto byte = static_cast<unsigned char>(text[i]);
            const bool isBlank = byte >= '\t' && byte <= '\r';
            const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
            const bool isC1 = byte == 0xC2 && next >= 0x80 && next < 0xA0;
            if (isC1)
            {
                byte = next;
                ++i;
            }
            if (isBlank)
            {
                line += ' ';
            }
            else if (isC1 || byte < 32 || byte == 127)
            {
                line += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
            }
            else
            {
                line += static_cast<char>(byte);
            }
        }
        return line;
    }

    /** \brief \e text without the blanks, tabs and line ends around it, in any locale. */
    inline std::string trimmed(const std::string &text)
    {
        const char *const blanks = " \t\n\v\f\r";
        const std::size_t first = text.find_first_not_of(blanks);
        return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
    }
}  // namespace ompl_mfa

#endif
