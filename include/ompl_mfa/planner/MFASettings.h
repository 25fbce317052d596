#ifndef OMPL_MFA_PLANNER_MFASETTINGS_
#define OMPL_MFA_PLANNER_MFASETTINGS_

#include <string>
#include <variant>
#include <vector>

#include "ompl_mfa/planner/AcceptedValues.h"

namespace ompl_mfa
{
    /** \brief The parameters of MFA with their defaults; mfaParameters() says what each means and accepts. */
    struct MFASettings
    {
        std::string variant{"mfa"};
        unsigned int populationSize{0};
        unsigned int slices{12};
        unsigned int generations{50};
        double gamma{0.5};
        double alpha{0.2};
        double eta{1.0};
        std::string guide{"both"};
        bool recombination{true};
        bool tightening{true};
        unsigned int seed{0};
        double stateCheckTime{0.1};
        unsigned int threads{1};

        bool usesTrees() const
        {
            return guide == "trees" || guide == "both";
        }

        bool usesRoadmap() const
        {
            return guide == "roadmap" || guide == "both";
        }

        /** \brief Whether fireflies search alone: the algorithm of the paper, as long as there is no guide planner. */
        bool isPaper() const
        {
            return !usesTrees() && !usesRoadmap() && !recombination && !tightening;
        }
    };

    /** \brief A parameter of MFA: its name in params(), where its value is kept, what it accepts and what it means. */
    template <typename T>
    struct MFAParameter
    {
        std::string name;
        T MFASettings::*member;
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
