#ifndef OMPL_MFA_BENCHMARK_OBJECTIVE_FACTORY_
#define OMPL_MFA_BENCHMARK_OBJECTIVE_FACTORY_

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa
{
    /** \brief The integral of 1/(1 + clearance) along the path, clearance in world units: it is finite on contact, at
        most the path's length, and the less the further a path keeps from obstacles. */
    class ProximityIntegralObjective : public ompl::base::StateCostIntegralObjective
    {
    public:
        explicit ProximityIntegralObjective(const ompl::base::SpaceInformationPtr &si);

        ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    };

    /** \brief The objective that \e problem names, its threshold set; null where it names none. */
    ompl::base::OptimizationObjectivePtr makeObjective(const ompl::base::SpaceInformationPtr &si,
                                                       const ProblemConfig &problem);
}  // namespace ompl_mfa

#endif
