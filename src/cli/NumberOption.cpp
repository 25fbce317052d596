#include "cli/NumberOption.h"

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

CLI::Option *ompl_mfa::cli::addNumberOption(CLI::App &command, const std::string &name, double &value,
                                            const std::string &description, const std::string &accepted)
{
    const auto read = [&value, name, accepted](const std::string &text)
    {
        if (!readNumber(text, value))
            throw InputError(name + " " + text + ": expected " + accepted);
    };
    return command.add_option_function<std::string>(name, read, description)->type_name("NUMBER");
}
