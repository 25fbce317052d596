#ifndef OMPL_MFA_TEST_FOREIGN_LOCALE_
#define OMPL_MFA_TEST_FOREIGN_LOCALE_

#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

namespace ompl_mfa_test
{
    /** \brief Writes 1234.5 as 1.234,5 as German does. */
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

    /** \brief Knows no lower case of I but a letter of its own, as Turkish does. */
    class TurkishLetters : public std::ctype<char>
    {
        static char lower(char letter)
        {
            const char dotless = '\xFD';
            if (letter == 'I')
                return dotless;
            return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        }

        char do_tolower(char letter) const override
        {
            return lower(letter);
        }

        const char *do_tolower(char *first, const char *last) const override
        {
            for (; first != last; ++first)
                *first = lower(*first);
            return last;
        }
    };

    /** \brief For as long as it lives, new C++ streams have German numbers and Turkish letters. It needs no locale of
        the system. */
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

    /** \brief For as long as it lives, the C library's locale is de_DE.UTF-8, made for this process where the system
        has the tools but not the locale. */
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

        /** \brief Whether the locale is in use; a test is to be skipped where it is not. */
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
                return false;
            setenv("LOCPATH", folder_.c_str(), 1);
            return std::setlocale(LC_ALL, NAME) != nullptr;
        }

        std::filesystem::path folder_{std::filesystem::temp_directory_path() /
                                      ("ompl_mfa_locale_" + std::to_string(getpid()))};
        bool isThere_;
    };
}  // namespace ompl_mfa_test

#endif
