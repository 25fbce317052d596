#ifndef OMPL_MFA_TEST_BENCHMARK_INPUT_ERROR_OF_
#define OMPL_MFA_TEST_BENCHMARK_INPUT_ERROR_OF_

#include <string>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::test
{
    /** \brief The message of the InputError that \e call throws; empty when it throws none. */
    template <typename Call>
    std::string inputErrorOf(Call call)
    {
        try
        {
            call();
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "";
    }
}  // namespace ompl_mfa::test

#endif
