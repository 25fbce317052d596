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
                letter = static_cast<char>(letter - 'A' + 'a');
        }
        return text;
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
