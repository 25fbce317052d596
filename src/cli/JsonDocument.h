#ifndef OMPL_MFA_CLI_JSON_DOCUMENT_
#define OMPL_MFA_CLI_JSON_DOCUMENT_

#include <cmath>
#include <iostream>

#include <nlohmann/json.hpp>

namespace ompl_mfa::cli
{
    /** \brief The result of a command with `--json`. File names may hold any bytes; what is not UTF-8 is replaced. */
    inline void printDocument(const nlohmann::json &document)
    {
        std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
    }

    /** \brief JSON has neither infinity nor NaN: a number that does not exist is null. */
    inline nlohmann::json finiteOrNull(double value)
    {
        return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
    }
}  // namespace ompl_mfa::cli

#endif
