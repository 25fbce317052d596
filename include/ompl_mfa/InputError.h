#ifndef OMPL_MFA_INPUT_ERROR_
#define OMPL_MFA_INPUT_ERROR_

#include <stdexcept>

namespace ompl_mfa
{
    /** \brief Something that the user handed in (a file, a key, a value, an option) cannot be used.

        The message is one line that names the file, the line, the key and the value where they exist, and says what
        is accepted instead. The `ompl_mfa` program prints it and exits with status 2. */
    class InputError : public std::runtime_error
    {
    public:
        using std::runtime_error::runtime_error;
    };
}  // namespace ompl_mfa

#endif
