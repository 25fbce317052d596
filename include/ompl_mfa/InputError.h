#ifndef OMPL_MFA_INPUT_ERROR_
#define OMPL_MFA_INPUT_ERROR_

#include <stdexcept>
#include <string>

#include "ompl_mfa/PlainText.h"

namespace ompl_mfa
{
    /** \brief Something that the user handed in (a file, a key, a value, an option) cannot be used.

        The message is one line that names the file, the line, the key and the value where they exist, and says what
        is accepted instead. The `ompl_mfa` program prints it and exits with status 2. */
    class InputError : public std::runtime_error
    {
    public:
        /** \brief The message is oneLine() of \e message: what a file held may be in it, a NUL included, at which the
            text of an exception would end. */
        explicit InputError(const std::string &message)
          : std::runtime_error(oneLine(message))
        {
        }
    };
}  // namespace ompl_mfa

#endif
