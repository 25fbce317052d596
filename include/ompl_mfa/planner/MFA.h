#ifndef OMPL_MFA_PLANNER_MFA_
#define OMPL_MFA_PLANNER_MFA_

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/optimizer/RandomSource.h"
#include "ompl_mfa/path/PathEvaluator.h"
#include "ompl_mfa/path/PathTightening.h"
#include "ompl_mfa/path/SliceFrame.h"
#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/planner/Incumbent.h"
#include "ompl_mfa/planner/MFASettings.h"
#include "ompl_mfa/planner/PairBounds.h"
#include "ompl_mfa/planner/PlannerGuide.h"
#include "ompl_mfa/planner/PublishingSchedule.h"
#include "ompl_mfa/planner/Query.h"
#include "ompl_mfa/planner/RoadmapGuide.h"
#include "ompl_mfa/planner/SearchLock.h"
#include "ompl_mfa/planner/Swarm.h"
#include "ompl_mfa/planner/TreeGuide.h"
#include "ompl_mfa/planner/TurnMeter.h"
#include "ompl_mfa/planner/TurnSharing.h"
#include "ompl_mfa/planner/WindowSwarm.h"

namespace ompl_mfa
{
    /** \brief The Modified Firefly Algorithm as an anytime planner.

        A path is one point on each of a fixed number of slices across the axis from start to goal. A swarm of
        fireflies, each a path, moves through the space of these coordinates: every firefly flies to the brighter
        ones, brighter being collision-free before colliding and then of better cost, while the random part of its
        flight and the attraction shrink over an epoch of generations.

        Other parts take turns with the fireflies, by what each gains for its work: recombination splices the paths of a
        swarm into better ones, guides (restarting trees and a growing roadmap) find the homotopy classes that slices
        across a straight axis cannot express, and tightening refines what the others find. Once there is a path, swarms
        fly in windows of it, where they look for other ways. With guide = none, recombination = 0 and tightening = 0
       the planner is the algorithm of the paper. */
    class MFA : public ompl::base::Planner
    {
    public:
        /** \brief Throws ompl::Exception if \e si is null. */
        explicit MFA(const ompl::base::SpaceInformationPtr &si);
        ~MFA() override;

        /** \brief Throws ompl::Exception naming the subspace if the state space is not supported, or the space if
            its extent is not finite. A problem definition need not exist yet. */
        void setup() override;
        void clear() override;
        void clearQuery() override;
        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
        using ompl::base::Planner::solve;

        /** \brief What the search knows to be valid: the roadmap, the trees, the valid fireflies and the best path. All
            states that \e data then points to are copies of its own. May be called from other threads while solve()
            runs: it waits for the check at hand. */
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \name Parameters. What each means and accepts stands in mfaParameters(). A setter throws ompl::Exception
            naming the parameter, the value and what is accepted, if it is not; a getter returns what was set last. A
            search keeps the parameters that were set when it began: changes take effect with the first solve() after
            clear(), or with the next query.
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
        void setGuide(const std::string &guide);
        std::string getGuide() const;
        void setRecombination(bool recombination);
        bool getRecombination() const;
        void setTightening(bool tightening);
        bool getTightening() const;
        void setSeed(std::uint32_t seed);
        std::uint32_t getSeed() const;
        void setStateCheckTime(double microseconds);
        double getStateCheckTime() const;
        void setThreads(unsigned int threads);
        unsigned int getThreads() const;
        /** @} */

        /** \brief A planner that searches in turns with the other parts, beside the guides that the parameter \e guide
            names: what it solves, MFA solves, and its paths are tightened as those of the others are. A null allocator
            (the default) is none. Takes effect as the parameters do. */
        void setGuidePlanner(const ompl::base::PlannerAllocator &allocator);

        /** \brief The fireflies' paths as they are now, brightest first; empty before solve() and while a new swarm is
            being placed. */
        std::vector<ompl::geometric::PathGeometric> getSwarmPaths() const;

        /** \brief The slices of the swarm's frame as pairs of states, a pair for each lateral coordinate: where the
            slice ends on either side. */
        std::vector<ompl::geometric::PathGeometric> getSlicePaths() const;

        /** \brief Cost of the best path so far; infinite before the first. Safe to call while solve() runs. */
        double bestCost() const;

        /** \brief Firefly generations so far. Safe to call while solve() runs. */
        std::uint64_t iterations() const;

        /** \brief The share of each part in the work so far, in [0, 1]: fireflies, recombination, tightening, trees,
            roadmap and guide planner. */
        std::vector<double> shares() const;

        /** \brief Path evaluations so far. Safe to call while solve() runs. */
        std::uint64_t evaluations() const;

    private:
        /* The parts of the search, which take turns; also their numbers in sharing_. */
        enum Part : std::size_t
        {
            FIREFLIES,
            RECOMBINATION,
            TIGHTENING,
            TREES,
            ROADMAP,
            PLANNER,
            PARTS
        };

        void declareParameters();
        template <typename T>
        void set(T MFASettings::*member, const T &value);
        FireflyOptimizer::Settings swarmSettings() const;
        ompl::base::PlannerStatus search(const ompl::base::PlannerTerminationCondition &ptc);
        ompl::base::PlannerStatus::StatusType begin(const ompl::base::PlannerTerminationCondition &ptc);
        bool bestPathHolds(const ompl::base::PlannerTerminationCondition &ptc);
        void requireFiniteExtent() const;
        void prepareQuery(const ompl::base::PlannerTerminationCondition &ptc);
        void prepareParts();
        void shareForFirstPath();
        void shareForImprovement();
        void forgetParts();
        void forgetSearch();
        bool finished(const ompl::base::PlannerTerminationCondition &ptc);
        bool provenOptimal();
        bool boundsHold();
        void iterate(const ompl::base::PlannerTerminationCondition &ptc);
        void takeNextTurn(const std::vector<bool> &available);
        void updatePhase();
        std::vector<bool> availableParts() const;
        void takeTurn(Part part, std::uint64_t work);
        void tryStraightMotions();
        void followStraightMotion();
        Waypoints straightPath(const ompl::base::State *start, const ompl::base::State *goal) const;
        bool guided() const;
        bool tryStraightMotion(std::size_t start, std::size_t goal);
        void laySwarms();
        std::unique_ptr<Swarm> makeSwarm(SliceFrame frame, std::uint64_t seed);
        void takeFirefly(const Waypoints &path, double cost);
        void chooseSwarm();
        void openWindow();
        bool flyStep(std::uint64_t work);
        void pursueWindow();
        void fly(std::uint64_t work);
        void recombine(std::uint64_t work);
        void prepareTightening();
        void tighten(std::uint64_t work);
        void follow(Guide &guide, std::uint64_t work);
        void offerTightened(const Waypoints &path);
        ompl::base::Cost tightenAgainst(const Waypoints &path, ompl::base::Cost cost, ompl::base::Cost rival);
        void keepAlternative(const Waypoints &path, double cost);
        void offer(const Waypoints &path, double cost);
        void publish();
        void publishIfDue();
        bool isPublished() const;
        void offerPartial(const Waypoints &path, std::size_t motion, const ompl::base::State *lastValid);
        ompl::base::PlannerStatus report();

        StateChartPtr chart_;
        ompl::base::OptimizationObjectivePtr objective_;
        std::unique_ptr<PathEvaluator> evaluator_;
        std::unique_ptr<PairBounds> pairBounds_;
        std::unique_ptr<Query> query_;
        std::vector<double> searchBounds_;  ///< of the space when the search of the query began
        std::unique_ptr<Incumbent> incumbent_;

        std::vector<std::pair<std::size_t, std::size_t>> axes_;  ///< starts and goals whose swarms are yet to be made
        std::vector<std::unique_ptr<Swarm>> swarms_;  ///< over straight frames, one for each of the first pairs
        std::unique_ptr<WindowSwarm> window_;         ///< in a part of the best path or an alternative
        Swarm *activeSwarm_{nullptr};                 ///< the window's, or one of swarms_
        std::size_t nextSwarm_{0};
        std::size_t windows_{0};               ///< opened so far
        RandomSource windowRandom_{0};         ///< draws windows
        std::vector<Waypoints> alternatives_;  ///< tightened paths of other homotopy classes, a little worse
        std::size_t nextAlternative_{0};

        std::unique_ptr<TreeGuide> trees_;
        bool hasRoadmap_{false};                 ///< whether this search has one
        std::unique_ptr<RoadmapGuide> roadmap_;  ///< made when it first has a turn
        std::unique_ptr<PlannerGuide> plannerGuide_;
        std::unique_ptr<PathTightening> tightening_;     ///< of the best path
        std::unique_ptr<PathTightening> newTightening_;  ///< of a path that a guide or a splice came upon
        bool tighteningStale_{false};
        TurnSharing sharing_;
        std::vector<double> spent_;  ///< by each part: seconds, or work units in a seeded run

        Waypoints firefly_;  ///< the best of this turn's valid fireflies that are worse than the best path
        double fireflyCost_{0.0};
        Waypoints untaken_;                    ///< a path of which the stop condition left the cost unknown
        unsigned int probes_{0};               ///< detours held against the objective's bounds
        std::vector<std::size_t> triedGoals_;  ///< of each start: goals to which the straight motion was tried
        bool followedStraight_{false};         ///< whether the first straight motion has served as partial path
        bool paper_{false};                    ///< whether this search is the paper's algorithm and nothing else
        bool improving_{false};                ///< whether the parts share the time as they do once there is a path
        PublishingSchedule publishing_;
        bool unpublished_{false};  ///< whether the best path is better than the last one that was published
        ompl::base::PathPtr publishedPath_;
        std::uint64_t runSeed_{0};
        ompl::RNG rng_;

        MFASettings settings_;  ///< as they were set, for the next query
        MFASettings search_;    ///< those of this query
        ompl::base::PlannerAllocator guidePlanner_;

        mutable SearchLock lock_;
        std::atomic<std::uint64_t> iterations_{0};
        std::atomic<std::uint64_t> evaluations_{0};
    };
}  // namespace ompl_mfa

#endif
