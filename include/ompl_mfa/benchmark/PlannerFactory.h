#ifndef OMPL_MFA_BENCHMARK_PLANNER_FACTORY_
#define OMPL_MFA_BENCHMARK_PLANNER_FACTORY_

#include <cstdint>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa
{
    /** \brief A parameter that a planner declares. */
    struct PlannerParameter
    {
        std::string name;
        /** \brief `bool`, `integer`, `unsigned`, `real` or `text`. */
        std::string type;
        /** \brief As OMPL writes ranges, "first:step:last" or "a,b,c"; empty when the planner suggests none. */
        std::string range;
        std::string defaultValue;
    };

    /** \brief Names of every geometric planner of the linked OMPL and of this project, sorted; aliases included. */
    std::vector<std::string> plannerNames();

    /** \brief Throws InputError, beginning with \e origin, unless createPlanner() makes planners of \e type. */
    void requireKnownPlanner(const std::string &type, const std::string &origin);

    /** \brief The name that a planner of a known \e type goes by in logs, such as `RRTstar`. */
    std::string plannerTitle(const std::string &type);

    /** \brief The parameters of planner \e type with ranges and defaults. Makes a planner, and with it random number
        generators: a seed is to be set before. */
    std::vector<PlannerParameter> plannerParameters(const std::string &type);

    /** \brief Makes the planner of \e spec, named and with its parameters set, on \e si.

        Makes random number generators: a seed is to be set before. Throws InputError, naming origin, key, value and
        what is accepted, for an unknown planner or parameter (with the nearest known name), for a value that is not of
        the parameter's type or out of its range, and for a planner that cannot work in the space of \e si. */
    ompl::base::PlannerPtr createPlanner(const ompl::base::SpaceInformationPtr &si, const PlannerSpec &spec);

    /** \brief Sets the planner's own `seed` parameter; does nothing to a planner that has none. */
    void seedPlanner(ompl::base::Planner &planner, std::uint_fast32_t seed);
}  // namespace ompl_mfa

#endif
