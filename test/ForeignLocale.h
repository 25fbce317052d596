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

#ifndef OMPL_MFA_TEST_FOREIGN_LOCALE_
#define OMPL_MFA_TEST_FOREIGN_LOCALE_

#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

namespace ompl_mfa::test
{
    /** \brief Formats 1234.5 as 1.234,5, as in German. */
    class GermanPunctuation : public std::numpunct<char>
    {
        char do_decimal_point() const override
        {
            return ',';
        }

        char do_thousands_sep() const override
        {
            return '.';
        }

        std::string do_grouping() const override
        {
            return "\3";
        }
    };

    /** \brief Maps I to a letter of its own in lower case, as in Turkish. */
    class TurkishLetters : public std::ctype<char>
    {
        static char lower(char letter)
        {
            const char dotless = '\xFD';
            if (letter == 'I')
            {
                return dotless;
            }
            return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        }

        char do_tolower(char letter) const override
        {
            return lower(letter);
        }

        const char *do_tolower(char *first, const char *last) const override
        {
            for (; first != last; ++first)
            {
                *first = lower(*first);
            }
            return last;
        }
    };

    /** \brief While it lives, new C++ streams use German numbers and Turkish letters. No installed locale is needed. */
    class ForeignStreams
    {
    public:
        ForeignStreams()
          : before_(std::locale::global(
                std::locale(std::locale(std::locale::classic(), new GermanPunctuation), new TurkishLetters)))
        {
        }

        ~ForeignStreams()
        {
            std::locale::global(before_);
        }

        ForeignStreams(const ForeignStreams &) = delete;
        ForeignStreams &operator=(const ForeignStreams &) = delete;

    private:
        std::locale before_;
    };

    /** \brief While it lives, the C library's locale is de_DE.UTF-8, compiled for this process if the system has the
        tools but not the locale. */
    class ForeignLibrary
    {
    public:
        ForeignLibrary()
          : isThere_(std::setlocale(LC_ALL, NAME) != nullptr || compile())
        {
        }

        ~ForeignLibrary()
        {
            std::setlocale(LC_ALL, "C");
            unsetenv("LOCPATH");
            std::error_code ignored;
            std::filesystem::remove_all(folder_, ignored);
        }

        ForeignLibrary(const ForeignLibrary &) = delete;
        ForeignLibrary &operator=(const ForeignLibrary &) = delete;

        /** \brief Whether the locale is in use; tests skip otherwise. */
        bool isThere() const
        {
            return isThere_ && std::localeconv()->decimal_point[0] == ',';
        }

    private:
        static constexpr const char *NAME = "de_DE.UTF-8";

        bool compile()
        {
            std::filesystem::create_directories(folder_);
            const std::string command =
                "localedef -i de_DE -f UTF-8 '" + (folder_ / NAME).string() + "' >/dev/null 2>&1";
            // NOLINTNEXTLINE(bugprone-command-processor): the test's own command
            if (std::system(command.c_str()) != 0)
            {
                return false;
            }
            setenv("LOCPATH", folder_.c_str(), 1);
            return std::setlocale(LC_ALL, NAME) != nullptr;
        }

        std::filesystem::path folder_{std::filesystem::temp_directory_path() /
                                      ("ompl_mfa_locale_" + std::to_string(getpid()))};
        bool isThere_;
    };

    /** \brief Calls \e check("streams") under ForeignStreams, then \e check("library") under ForeignLibrary where it is
        available. */
    template <typename Check>
    void inForeignLocales(const Check &check)
    {
        {
            const ForeignStreams foreign;
            check("streams");
        }
        const ForeignLibrary foreign;
        if (foreign.isThere())
        {
            check("library");
        }
    }
}  // namespace ompl_mfa::test

#endif
