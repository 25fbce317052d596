#ifndef OMPL_MFA_BENCHMARK_FILE_NAMES_
#define OMPL_MFA_BENCHMARK_FILE_NAMES_

#include <filesystem>
#include <string>

namespace ompl_mfa
{
    /** \brief Bytes that a name may take as part of a file's name: with what logs, parts of campaigns and paths add to
        it, the whole stays within the 255 bytes that file systems accept. */
    constexpr std::size_t LONGEST_NAME = 100;

    /** \brief \e name as part of a file's name: `/`, `%` and control characters as `%` and two hexadecimal digits, so
        that no two names become the same and none is a folder. */
    std::string fileNamePart(const std::string &name);

    /** \brief Whether \e text holds a control character: a byte below 32, or 127. */
    bool hasControlCharacter(const std::string &text);

    /** \brief Whether \e name can be a file's name as it is: neither empty nor `.` nor `..`, of at most LONGEST_NAME
        bytes, without `/` and control characters. */
    bool isFileName(const std::string &name);

    /** \brief The path that a user wrote: `~` and `~/...` are in the folder that the environment variable HOME names,
        as in a shell. Throws InputError "\e origin: ..." for a control character, for `~NAME`, for a folder that is
        called `~`, and where HOME is needed and not set. */
    std::filesystem::path writtenPath(const std::string &path, const std::string &origin);
}  // namespace ompl_mfa

#endif
