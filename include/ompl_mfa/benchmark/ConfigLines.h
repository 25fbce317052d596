#ifndef OMPL_MFA_BENCHMARK_CONFIG_LINES_
#define OMPL_MFA_BENCHMARK_CONFIG_LINES_

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace ompl_mfa
{
    /** \brief One `key = value` as it was written, with the place that an error about it has to name. */
    struct ConfigEntry
    {
        std::string key;
        std::string value;
        /** \brief "FILE:LINE", or the command line option that it came from. */
        std::string origin;
    };

    /** \brief Reads an INI-like text: `[section]`, `key = value`, `#` to the end of the line is a comment. A byte-order
        mark and CRLF line ends are accepted. Keys are returned in lower case as `section.key`, in the order of the
        text, repeated ones included. Throws InputError, naming \e file and line, for any other line.

        Boost.Program_options reads the same syntax, but its errors have no line numbers. */
    std::vector<ConfigEntry> readConfigLines(std::istream &in, const std::string &file);

    /** \brief The value as a finite number; throws InputError where it is not one. */
    double realValue(const ConfigEntry &entry);

    /** \brief As realValue(), and above 0. */
    double positiveValue(const ConfigEntry &entry);

    /** \brief The value as a whole number in [\e first, \e last]; throws InputError where it is not one. */
    std::uint_fast64_t wholeValue(const ConfigEntry &entry, std::uint_fast64_t first, std::uint_fast64_t last);

    /** \brief 0, 1, true, false, yes, no, on or off; throws InputError for anything else. */
    bool switchValue(const ConfigEntry &entry);

    /** \brief The index of the value in \e accepted; throws InputError, listing \e accepted, where it is not there. */
    std::size_t choiceValue(const ConfigEntry &entry, const std::vector<std::string> &accepted);

    /** \brief Throws InputError: "ORIGIN: \e message". */
    [[noreturn]] void failAt(const std::string &origin, const std::string &message);

    /** \brief Throws InputError: "ORIGIN: KEY = VALUE: \e message". */
    [[noreturn]] void failAt(const ConfigEntry &entry, const std::string &message);

    /** \brief `; did you mean 'X'?` with the nearest of \e known, or, when none is near, `; known are A, B, ...`. */
    std::string suggestion(const std::string &name, const std::vector<std::string> &known);
}  // namespace ompl_mfa

#endif
