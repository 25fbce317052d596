#ifndef OMPL_MFA_PLANNER_MFAPARAMETERS_
#define OMPL_MFA_PLANNER_MFAPARAMETERS_

#include <string>
#include <variant>
#include <vector>

#include "engine/SearchSettings.h"
#include "planner/AcceptedValues.h"

namespace ompl_mfa
{
    /** \brief A parameter of MFA: its name in params(), where its value is kept, what it accepts and what it means. */
    template <typename T>
    struct MFAParameter
    {
        std::string name;
        T SearchSettings::*member;
        AcceptedValues<T> accepted;
        std::string meaning;
    };

    using AnyMFAParameter =
        std::variant<MFAParameter<std::string>, MFAParameter<unsigned int>, MFAParameter<double>, MFAParameter<bool>>;

    /** \brief All parameters, in the order of the documentation. Each value is accepted or refused by itself, so that
        the order in which parameters are set does not matter. */
    const std::vector<AnyMFAParameter> &mfaParameters();
}  // namespace ompl_mfa

#endif
