#include "ompl_mfa/planner/MFA.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "ompl_mfa/planner/GoalDistance.h"
#include "ompl_mfa/planner/Streams.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa
{
    namespace
    {
        /* Bounds of a turn, in units of PathEvaluator::work(). */
        constexpr std::uint64_t SHORTEST_TURN = 400;
        constexpr std::uint64_t LONGEST_TURN = 8000;
        /* Random detours that have to keep to the objective's bounds before a path that meets them ends the search. */
        constexpr unsigned int PROBES = 64;

        /* The evaluator asks the condition of this solve() and no later one, however solve() ends. */
        class StopConditionScope
        {
        public:
            StopConditionScope(PathEvaluator &evaluator, const ob::PlannerTerminationCondition &ptc)
              : evaluator_(evaluator)
            {
                evaluator_.setStopCondition([&ptc] { return ptc(); });
            }

            ~StopConditionScope()
            {
                evaluator_.setStopCondition({});
            }

            StopConditionScope(const StopConditionScope &) = delete;
            StopConditionScope &operator=(const StopConditionScope &) = delete;

        private:
            PathEvaluator &evaluator_;
        };
    }  // namespace

    MFA::MFA(const ob::SpaceInformationPtr &si)
      : ob::Planner(si, "MFA")
      , firefly_(si->getStateSpace())
      , untaken_(si->getStateSpace())
    {
        specs_.recognizedGoal = ob::GOAL_REGION;
        specs_.approximateSolutions = true;
        specs_.optimizingPaths = true;
        specs_.directed = true;
        specs_.canReportIntermediateSolutions = true;
        addPlannerProgressProperty("best cost REAL", [this] { return ompl::toString(bestCost()); });
        addPlannerProgressProperty("iterations INTEGER", [this] { return std::to_string(iterations()); });
        addPlannerProgressProperty("evaluations INTEGER", [this] { return std::to_string(evaluations()); });
        incumbent_ = std::make_unique<Incumbent>(si->getStateSpace());
        query_ = std::make_unique<Query>(si->getStateSpace());
        declareParameters();
    }

    MFA::~MFA() = default;

    void MFA::setup()
    {
        Planner::setup();
        setup_ = false;  // where the space is refused, it is refused each time
        chart_ = std::make_shared<StateChart>(si_->getStateSpace());
        requireFiniteExtent();
        setup_ = true;
    }

    void MFA::requireFiniteExtent() const
    {
        if (!std::isfinite(si_->getStateSpace()->getMaximumExtent()))
            throw ompl::Exception(getName(), "cannot plan in the state space '" + si_->getStateSpace()->getName() +
                                                 "': its bounds are infinite, or too large for a finite distance");
    }

    void MFA::clear()
    {
        Planner::clear();
        const SearchLock::Search lock(lock_);
        forgetSearch();
    }

    void MFA::forgetSearch()
    {
        forgetParts();
        pairBounds_.reset();
        evaluator_.reset();
        query_->reset();
        incumbent_->reset(nullptr);
        publishing_.reset();
        publishedPath_.reset();
        unpublished_ = improving_ = false;
        triedGoals_.clear();
        iterations_ = 0;
        evaluations_ = 0;
    }

    void MFA::clearQuery()
    {
        // the swarm lives on slices between one start and one goal: nothing of it serves another query
        clear();
        pis_.restart();
    }

    void MFA::prepareQuery(const ob::PlannerTerminationCondition &ptc)
    {
        const std::vector<double> bounds = chart_->bounds();
        if (bounds != searchBounds_)
            requireFiniteExtent();
        if (evaluator_ && bounds == searchBounds_ && !query_->differsFrom(*pdef_) && bestPathHolds(ptc))
            return;
        if (evaluator_)
        {
            Planner::clear();
            forgetSearch();
            pis_.restart();
        }
        objective_ = pdef_->getOptimizationObjective();
        if (!objective_)
        {
            OMPL_INFORM("%s: No optimization objective specified. Defaulting to optimizing path length.",
                        getName().c_str());
            objective_ = std::make_shared<ob::PathLengthOptimizationObjective>(si_);
        }
        search_ = settings_;
        incumbent_->reset(objective_);
        evaluator_ = std::make_unique<PathEvaluator>(si_, objective_, search_.threads);
        pairBounds_ = std::make_unique<PairBounds>(evaluator_->bounds());
        evaluator_->setPartialPathEvent([this](const Waypoints &path, std::size_t motion, const ob::State *lastValid)
                                        { offerPartial(path, motion, lastValid); });
        runSeed_ = search_.seed != 0 ? search_.seed : static_cast<std::uint64_t>(rng_.uniformInt(1, 1 << 30));
        prepareParts();
        // last: where the allocator of the guide planner throws, no query has begun
        query_->reset(*pdef_);
        searchBounds_ = bounds;
    }

    ob::PlannerStatus::StatusType MFA::begin(const ob::PlannerTerminationCondition &ptc)
    {
        return query_->begin(pis_, ptc, chart_, si_, streamSeed(runSeed_, Stream::GoalSearch));
    }

    /* What an earlier solve() found may not hold any more: goals change in place, and so do the validity checker's
       answers. Where the stop condition leaves no time to check, the path is taken as it was. */
    bool MFA::bestPathHolds(const ob::PlannerTerminationCondition &ptc)
    {
        const bool exact = incumbent_->hasPath();
        const Waypoints &path = exact ? incumbent_->path() : incumbent_->partialPath();
        if (path.empty())
            return true;
        if (exact && !query_->isAnsweredBy(path))
            return false;
        if (!exact)
        {
            double distance = 0.0;
            isSatisfied(*query_->goal(), chart_->guard(), path.back(), &distance);
            incumbent_->setPartialDistance(distance);
        }
        const StopConditionScope stopCondition(*evaluator_, ptc);
        const bool holds = evaluator_->stopped() ||
                           (evaluator_->checkState(path.front()) && evaluator_->checkPath(path)) ||
                           evaluator_->interrupted();
        if (!holds)
            OMPL_INFORM("%s: The path of an earlier solve() is not valid any more; the search restarts",
                        getName().c_str());
        return holds;
    }

    ob::PlannerStatus MFA::solve(const ob::PlannerTerminationCondition &ptc)
    {
        checkValidity();
        const SearchLock::Search lock(lock_);
        // wherever the condition is evaluated, what other threads may ask for is complete
        const ob::PlannerTerminationCondition watched(
            [&]
            {
                lock_.letReadersIn();
                return ptc();
            });
        return search(watched);
    }

    ob::PlannerStatus MFA::search(const ob::PlannerTerminationCondition &ptc)
    {
        prepareQuery(ptc);
        const StopConditionScope stopCondition(*evaluator_, ptc);
        const auto status = begin(ptc);
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
            return status;
        if (incumbent_->hasPath() && !isPublished())
            publish();
        while (!finished(ptc))
            iterate(ptc);
        return report();
    }

    bool MFA::finished(const ob::PlannerTerminationCondition &ptc)
    {
        if (ptc())
            return true;
        if (!incumbent_->hasPath())
            return false;
        return objective_->isSatisfied(ob::Cost(incumbent_->cost())) || (provenOptimal() && boundsHold());
    }

    bool MFA::provenOptimal()
    {
        if (!query_->goalsComplete() || !evaluator_->bounds().admissible())
            return false;
        pairBounds_->update(query_->starts(), query_->goals());
        return pairBounds_->isBest(incumbent_->cost(), query_->starts(), query_->goals());
    }

    /* A proof is as good as the objective's heuristic. Where it is not known to be a bound, detours tell: an objective
       may charge the straight motion more than a way around. */
    bool MFA::boundsHold()
    {
        const CostBounds &bounds = evaluator_->bounds();
        if (bounds.certain())
            return true;
        ompl::RNG rng(static_cast<std::uint_fast32_t>(streamSeed(runSeed_, Stream::Detours, probes_)));
        Waypoints detour(si_->getStateSpace());
        detour.resize(3);
        for (; probes_ < PROBES && bounds.admissible(); ++probes_)
        {
            si_->copyState(detour[0], query_->starts()[probes_ % query_->starts().size()]);
            chart_->sampleUniform(rng, detour[1]);
            si_->copyState(detour[2], query_->goals()[probes_ % query_->goals().size()]);
            evaluator_->cost(detour);
            if (evaluator_->interrupted())
                return false;
        }
        return bounds.admissible();
    }

    void MFA::iterate(const ob::PlannerTerminationCondition &ptc)
    {
        query_->poll(pis_, ptc);
        tryStraightMotions();
        followStraightMotion();
        if (!untaken_.empty())
            offerTightened(std::exchange(untaken_, Waypoints(si_->getStateSpace())));
        updatePhase();
        const std::vector<bool> available = availableParts();
        if (std::find(available.begin(), available.end(), true) == available.end() || finished(ptc))
            return;
        takeNextTurn(available);
        publishIfDue();
    }

    void MFA::takeNextTurn(const std::vector<bool> &available)
    {
        const std::size_t part = sharing_.next(available);
        const double cost = incumbent_->cost();
        const TurnMeter meter(*evaluator_, search_.seed != 0 ? 1e-6 * search_.stateCheckTime : 0.0);
        // turns grow with the work done, so that no part spends its time beginning
        takeTurn(static_cast<Part>(part), std::clamp(evaluator_->work() / 20, SHORTEST_TURN, LONGEST_TURN));
        const double spent = meter.spent();
        spent_[part] += spent;
        const double gain = improving_ ? std::abs(cost - incumbent_->cost()) / std::max(std::abs(cost), 1e-12) : 0.0;
        sharing_.record(part, spent, std::min(gain, 1.0));
        updatePhase();
    }

    /* Wherever the first path of finite cost came from, the parts share the time as it suits its improvement. */
    void MFA::updatePhase()
    {
        if (improving_ || !incumbent_->hasFinitePath())
            return;
        improving_ = true;
        shareForImprovement();
    }

    void MFA::offer(const Waypoints &path, double cost)
    {
        const bool first = !incumbent_->hasPath();
        if (!incumbent_->offer(path, cost))
            return;
        if (first)
            evaluator_->setPartialPathEvent({});
        tighteningStale_ = true;
        unpublished_ = true;
        publishIfDue();
    }

    void MFA::publishIfDue()
    {
        if (unpublished_ && publishing_.due(incumbent_->cost(), evaluator_->work()))
            publish();
    }

    void MFA::publish()
    {
        const ob::Cost cost(incumbent_->cost());
        auto path = std::make_shared<og::PathGeometric>(si_);
        incumbent_->path().appendTo(*path);
        ob::PlannerSolution solution(path);
        solution.setPlannerName(getName());
        solution.setOptimized(objective_, cost, objective_->isSatisfied(cost));
        pdef_->addSolutionPath(solution);
        publishing_.published(cost.value(), evaluator_->work());
        publishedPath_ = path;
        unpublished_ = false;
        const auto callback = pdef_->getIntermediateSolutionCallback();
        if (!callback)
            return;
        // the callback may wait for a thread that asks for planner data
        const SearchLock::Release release(lock_);
        callback(this, incumbent_->path().pointers(), cost);
    }

    /* Whether the problem definition, which may be another one than before, has the best path. */
    bool MFA::isPublished() const
    {
        if (unpublished_ || !publishedPath_)
            return false;
        const auto solutions = pdef_->getSolutions();
        return std::any_of(solutions.begin(), solutions.end(),
                           [this](const ob::PlannerSolution &solution) { return solution.path_ == publishedPath_; });
    }

    void MFA::offerPartial(const Waypoints &path, std::size_t motion, const ob::State *lastValid)
    {
        double distance = 0.0;
        isSatisfied(*query_->goal(), chart_->guard(), lastValid, &distance);
        if (distance >= incumbent_->partialDistance())
            return;
        // the piece of the motion up to the last valid state is discretised anew and may not be valid by itself
        if (evaluator_->checkMotion(path[motion], lastValid))
            incumbent_->offerPartial(path, motion + 1, lastValid, distance);
    }

    ob::PlannerStatus MFA::report()
    {
        if (incumbent_->hasPath())
        {
            if (!isPublished())
                publish();
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (incumbent_->partialPath().size() < 2)
            return ob::PlannerStatus::TIMEOUT;
        auto path = std::make_shared<og::PathGeometric>(si_);
        incumbent_->partialPath().appendTo(*path);
        ob::PlannerSolution solution(path);
        solution.setPlannerName(getName());
        solution.setApproximate(incumbent_->partialDistance());
        pdef_->addSolutionPath(solution);
        return ob::PlannerStatus::APPROXIMATE_SOLUTION;
    }

    double MFA::bestCost() const
    {
        return incumbent_->cost();
    }

    std::uint64_t MFA::iterations() const
    {
        return iterations_;
    }

    std::uint64_t MFA::evaluations() const
    {
        return evaluations_;
    }
}  // namespace ompl_mfa
