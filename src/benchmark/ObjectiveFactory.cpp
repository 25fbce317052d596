#include "benchmark/ObjectiveFactory.h"

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

namespace ompl_mfa
{
    namespace
    {
        namespace ob = ompl::base;

        ob::OptimizationObjectivePtr makeTerm(const ob::SpaceInformationPtr &si, const std::string &name)
        {
            if (name == "max_min_clearance")
                return std::make_shared<ob::MaximizeMinClearanceObjective>(si);
            if (name == "mechanical_work")
                return std::make_shared<ob::MechanicalWorkOptimizationObjective>(si);
            if (name == "proximity")
                return std::make_shared<ProximityIntegralObjective>(si);
            return std::make_shared<ob::PathLengthOptimizationObjective>(si);
        }

        ob::OptimizationObjectivePtr makeWeighted(const ob::SpaceInformationPtr &si, const ProblemConfig &problem)
        {
            auto sum = std::make_shared<ob::MultiOptimizationObjective>(si);
            for (const auto &[name, weight] : problem.objectiveWeights)
                sum->addObjective(makeTerm(si, name), weight);
            sum->lock();
            return sum;
        }
    }  // namespace

    ProximityIntegralObjective::ProximityIntegralObjective(const ob::SpaceInformationPtr &si)
      : ob::StateCostIntegralObjective(si, true)
    {
        description_ = "Proximity Integral";
    }

    ob::Cost ProximityIntegralObjective::stateCost(const ob::State *state) const
    {
        return ob::Cost(1.0 / (1.0 + si_->getStateValidityChecker()->clearance(state)));
    }

    ob::OptimizationObjectivePtr makeObjective(const ob::SpaceInformationPtr &si, const ProblemConfig &problem)
    {
        if (!problem.objective)
            return nullptr;
        const bool isWeighted = problem.objective->value == "weighted";
        ob::OptimizationObjectivePtr objective =
            isWeighted ? makeWeighted(si, problem) : makeTerm(si, problem.objective->value);
        if (problem.objectiveThreshold)
            objective->setCostThreshold(ob::Cost(*problem.objectiveThreshold));
        return objective;
    }
}  // namespace ompl_mfa
