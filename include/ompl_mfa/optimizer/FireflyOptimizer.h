#ifndef OMPL_MFA_OPTIMIZER_FIREFLY_OPTIMIZER_
#define OMPL_MFA_OPTIMIZER_FIREFLY_OPTIMIZER_

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"

namespace ompl_mfa
{
    /** \brief The firefly algorithm (FA) and the Modified Firefly Algorithm (MFA) over a box in R^d. */
    class FireflyOptimizer
    {
    public:
        enum class Variant
        {
            FA,  ///< eqs. (1)-(5); alpha and beta0 constant, one evaluation a firefly and generation
            MFA  ///< adds the trial vectors of eqs. (6)-(12) and the schedules of eqs. (13)-(16)
        };

        struct Settings
        {
            Variant variant{Variant::MFA};
            unsigned int populationSize{100};
            /** \brief Mmax: the generations of one epoch, over which alpha and beta0 shrink. */
            unsigned int generations{50};
            double gamma{0.5};
            double alpha{0.2};
            double eta{1.0};

            /** \brief Throws std::invalid_argument naming the setting, its value and the accepted range. */
            void validate() const;
        };

        using StopCondition = std::function<bool()>;

        FireflyOptimizer(const Settings &settings, const Eigen::VectorXd &lower, const Eigen::VectorXd &upper,
                         std::uint_fast64_t seed);

        /** \brief Runs to the end of the current generation; the first generation is the evaluation of the initial
            population. \e stop is asked before every evaluation; when it is true, step returns false, and the next
            call goes on at that evaluation. */
        bool step(ObjectiveFunction &objective, const StopCondition &stop);
    };
}  // namespace ompl_mfa

#endif
