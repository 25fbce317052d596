#ifndef OMPL_MFA_PLANNER_MFA_
#define OMPL_MFA_PLANNER_MFA_

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/path/PathEvaluator.h"
#include "ompl_mfa/path/SliceFrame.h"
#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/planner/Incumbent.h"
#include "ompl_mfa/planner/Query.h"
#include "ompl_mfa/planner/Swarm.h"

namespace ompl_mfa
{
    /** \brief The Modified Firefly Algorithm as an anytime planner.

        A path is one point on each of a fixed number of slices across the axis from start to goal. A swarm of
        fireflies, each a path, moves through the space of these coordinates: every firefly flies to the brighter
        ones, brighter being collision-free before colliding and then of better cost, while the random part of its
        flight and the attraction shrink over an epoch of generations. */
    class MFA : public ompl::base::Planner
    {
    public:
        /** \brief Throws ompl::Exception if \e si is null. */
        explicit MFA(const ompl::base::SpaceInformationPtr &si);
        ~MFA() override;

        /** \brief Throws ompl::Exception naming the subspace if the state space is not supported. A problem
            definition need not exist yet. */
        void setup() override;
        void clear() override;
        void clearQuery() override;
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
        using ompl::base::Planner::solve;
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \name Parameters. A setter throws ompl::Exception naming the parameter, the value and what is accepted.
            Changes take effect with the next solve() after clear().
            @{ */
        void setVariant(const std::string &variant);
        std::string getVariant() const;
        void setPopulationSize(unsigned int size);
        unsigned int getPopulationSize() const;
        void setSlices(unsigned int slices);
        unsigned int getSlices() const;
        void setGenerations(unsigned int generations);
        unsigned int getGenerations() const;
        void setGamma(double gamma);
        double getGamma() const;
        void setAlpha(double alpha);
        double getAlpha() const;
        void setEta(double eta);
        double getEta() const;
        void setSeed(std::uint32_t seed);
        std::uint32_t getSeed() const;
        /** @} */

        /** \brief The fireflies' paths as they are now, brightest first; empty before solve(). */
        std::vector<ompl::geometric::PathGeometric> getSwarmPaths() const;

        /** \brief The slices of the swarm's frame as pairs of states, a pair for each lateral coordinate: where the
            slice ends on either side. */
        std::vector<ompl::geometric::PathGeometric> getSlicePaths() const;

        /** \brief Cost of the best path so far; infinite before the first. Safe to call while solve() runs. */
        double bestCost() const;

        /** \brief Firefly generations so far. Safe to call while solve() runs. */
        std::uint64_t iterations() const;

        /** \brief Path evaluations so far. Safe to call while solve() runs. */
        std::uint64_t evaluations() const;

    private:
        void declareParameters();
        ompl::base::PlannerStatus::StatusType begin(const ompl::base::PlannerTerminationCondition &ptc);
        void prepareQuery();
        bool finished(const ompl::base::PlannerTerminationCondition &ptc) const;
        bool provenOptimal() const;
        void iterate(const ompl::base::PlannerTerminationCondition &ptc);
        void tryStraightMotions();
        void tryStraightMotion(const ompl::base::State *start, const ompl::base::State *goal);
        void fly(const ompl::base::PlannerTerminationCondition &ptc);
        void offer(const Waypoints &path, double cost);
        void publish();
        void offerPartial(const Waypoints &path, std::size_t motion, const ompl::base::State *lastValid);
        ompl::base::PlannerStatus report();

        StateChartPtr chart_;
        ompl::base::OptimizationObjectivePtr objective_;
        std::unique_ptr<PathEvaluator> evaluator_;
        std::unique_ptr<Query> query_;
        std::unique_ptr<Incumbent> incumbent_;
        std::vector<std::unique_ptr<Swarm>> swarms_;
        std::size_t activeSwarm_{0};
        std::size_t triedStarts_{0};  ///< starts whose straight motions to all goals were tried
        std::size_t triedGoals_{0};   ///< goals whose straight motions from all starts were tried
        bool published_{false};       ///< whether this solve() has handed the best path to the problem definition
        std::uint64_t runSeed_{0};
        ompl::RNG rng_;
        mutable std::vector<Waypoints> plannerDataPaths_;

        FireflyOptimizer::Settings settings_;
        unsigned int slices_{12};
        std::uint32_t seed_{0};

        mutable std::recursive_mutex mutex_;  ///< held while the search changes; its callbacks may ask for planner data
        std::atomic<std::uint64_t> iterations_{0};
        std::atomic<std::uint64_t> evaluations_{0};
    };
}  // namespace ompl_mfa

#endif
