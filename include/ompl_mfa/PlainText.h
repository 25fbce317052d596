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
}  // namespace ompl_mfa

#endif
