#ifndef OMPL_MFA_TEXT_NEAREST_NAME_
#define OMPL_MFA_TEXT_NEAREST_NAME_

#include <string>
#include <vector>

namespace ompl_mfa
{
    /** \brief The shortest entry of \e known that begins with \e name, or else the one with the least edit distance;
        empty where none is near: within a third of the length of \e name, and at least within one edit. */
    std::string nearestName(const std::string &name, const std::vector<std::string> &known);

    /** \brief The one line for a name that does not exist: `unknown function 'sync'; did you mean 'sinc'? accepted:
        ackley, sinc`. The guess is left out where no accepted name is close. */
    std::string describeUnknown(const std::string &kind, const std::string &name,
                                const std::vector<std::string> &accepted);

    /** \brief Throws InputError with describeUnknown() unless \e name is one of \e accepted. */
    void requireKnown(const std::string &kind, const std::string &name, const std::vector<std::string> &accepted);
}  // namespace ompl_mfa

#endif
