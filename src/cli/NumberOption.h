#ifndef OMPL_MFA_CLI_NUMBER_OPTION_
#define OMPL_MFA_CLI_NUMBER_OPTION_

#include <string>

#include <CLI/CLI.hpp>

namespace ompl_mfa::cli
{
    /** \brief An option that takes a number, with a point in every locale, into \e value, which has to outlive \e
        command. Any other text is an InputError that names the option, the text and \e accepted. */
    CLI::Option *addNumberOption(CLI::App &command, const std::string &name, double &value,
                                 const std::string &description, const std::string &accepted = "a number");
}  // namespace ompl_mfa::cli

#endif
