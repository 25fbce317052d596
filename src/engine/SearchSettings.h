#ifndef OMPL_MFA_ENGINE_SEARCH_SETTINGS_
#define OMPL_MFA_ENGINE_SEARCH_SETTINGS_

#include <string>

namespace ompl_mfa
{
    /** \brief The parameters of a search with their defaults; mfaParameters() says what each means and accepts. A
       search works on a copy that does not change. */
    struct SearchSettings
    {
        std::string variant{"mfa"};
        bool fireflies{true};
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
            return fireflies && !usesTrees() && !usesRoadmap() && !recombination && !tightening;
        }
    };
}  // namespace ompl_mfa

#endif
