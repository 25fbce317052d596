#ifndef OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_
#define OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa
{
    /** \brief Makes ready SimpleSetups of one config. World and robot are loaded once and shared by all of them. */
    class ProblemFactory
    {
    public:
        /** \brief Loads world and robot. Makes no random number generator. Throws InputError for a file that is missing
            or cannot be used. */
        explicit ProblemFactory(BenchmarkConfig config);
        ~ProblemFactory();

        ProblemFactory(const ProblemFactory &) = delete;
        ProblemFactory &operator=(const ProblemFactory &) = delete;

        const BenchmarkConfig &config() const;

        /** \brief A new, set up problem without a planner; \e plannerContext overrides the context of the config, so
            that nothing of one planner reaches the next.

            Makes random number generators: setRandomSeed() comes before. Throws InputError when start or goal is out
            of bounds or collides, or when a context key or value is not known. */
        ompl::geometric::SimpleSetupPtr create(const std::vector<ConfigEntry> &plannerContext = {}) const;

    private:
        struct Bodies;

        BenchmarkConfig config_;
        std::unique_ptr<Bodies> bodies_;
    };

    /** \brief Seeds OMPL. Only the call made before the first random number generator of the process makes runs
        repeatable. Throws InputError for 0, which OMPL does not accept. */
    void setRandomSeed(std::uint_fast32_t seed);
}  // namespace ompl_mfa

#endif
