#include "ompl_mfa/planner/MFA.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

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

        /* Processor time of this thread, s: what other programs do must not distort the shares. */
        double threadTime()
        {
            timespec time{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        }
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
        chart_ = std::make_shared<StateChart>(si_->getStateSpace());
    }

    void MFA::clear()
    {
        Planner::clear();
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        forgetParts();
        evaluator_.reset();
        query_->reset();
        incumbent_->reset(nullptr);
        triedStarts_ = triedGoals_ = 0;
        iterations_ = 0;
        evaluations_ = 0;
    }

    void MFA::clearQuery()
    {
        // the swarm lives on slices between one start and one goal: nothing of it serves another query
        clear();
        pis_.restart();
    }

    void MFA::prepareQuery()
    {
        if (evaluator_ && !query_->differsFrom(*pdef_))
            return;
        if (evaluator_)
            clearQuery();
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
        evaluator_->setPartialPathEvent([this](const Waypoints &path, std::size_t motion, const ob::State *lastValid)
                                        { offerPartial(path, motion, lastValid); });
        runSeed_ = search_.seed != 0 ? search_.seed : static_cast<std::uint64_t>(rng_.uniformInt(1, 1 << 30));
        prepareParts();
        // last: where the allocator of the guide planner throws, no query has begun
        query_->reset(*pdef_);
    }

    ob::PlannerStatus::StatusType MFA::begin(const ob::PlannerTerminationCondition &ptc)
    {
        prepareQuery();
        published_ = false;
        evaluator_->setStopCondition([&ptc] { return ptc(); });
        return query_->begin(pis_, ptc, chart_, si_, runSeed_);
    }

    ob::PlannerStatus MFA::solve(const ob::PlannerTerminationCondition &ptc)
    {
        checkValidity();
        {
            const std::lock_guard<std::recursive_mutex> lock(mutex_);
            const auto status = begin(ptc);
            if (status != ob::PlannerStatus::EXACT_SOLUTION)
                return status;
        }
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

    bool MFA::provenOptimal() const
    {
        if (!query_->goalsComplete() || !evaluator_->bounds().admissible())
            return false;
        const ob::Cost best(incumbent_->cost());
        bool met = false;
        for (std::size_t i = 0; i < query_->starts().size(); ++i)
        {
            for (std::size_t j = 0; j < query_->goals().size(); ++j)
            {
                const ob::State *start = query_->starts()[i];
                const ob::State *goal = query_->goals()[j];
                const ob::Cost bound =
                    objective_->combineCosts(objective_->combineCosts(objective_->initialCost(start),
                                                                      objective_->motionCostHeuristic(start, goal)),
                                             objective_->terminalCost(goal));
                if (objective_->isCostBetterThan(bound, best))
                    return false;
                // bounds that are all beaten are none: OMPL's default heuristic does not know of costs below identity
                met = met || !objective_->isCostBetterThan(best, bound);
            }
        }
        return met;
    }

    /* A proof is as good as the objective's heuristic. Where it is not known to be a bound, detours tell: an objective
       may charge the straight motion more than a way around. */
    bool MFA::boundsHold()
    {
        const CostBounds &bounds = evaluator_->bounds();
        if (bounds.certain())
            return true;
        ompl::RNG rng(static_cast<std::uint_fast32_t>(runSeed_ + PROBES + probes_));
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
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        query_->poll(pis_, ptc);
        tryStraightMotions();
        followStraightMotion();
        if (!untaken_.empty())
            offerTightened(std::exchange(untaken_, Waypoints(si_->getStateSpace())));
        const std::vector<bool> available = availableParts();
        if (std::find(available.begin(), available.end(), true) == available.end() || finished(ptc))
            return;
        const std::size_t part = sharing_.next(available);
        const std::uint64_t before = evaluator_->work();
        const double began = threadTime();
        const bool hadPath = incumbent_->hasPath();
        const double cost = incumbent_->cost();
        // turns grow with the work done, so that no part spends its time beginning
        takeTurn(static_cast<Part>(part), std::clamp(before / 20, SHORTEST_TURN, LONGEST_TURN));
        double gain = 0.0;
        if (hadPath)
            gain = std::abs(cost - incumbent_->cost()) / std::max(std::abs(cost), 1e-12);
        // a seeded run must not depend on a clock; without one, the work that is not state checks is only estimated
        const double spent =
            search_.seed != 0 ? static_cast<double>(evaluator_->work() - before + 1) : threadTime() - began;
        spent_[part] += spent;
        if (!hadPath && incumbent_->hasPath())
            shareForImprovement();
        else
            sharing_.record(part, spent, std::min(gain, 1.0));
    }

    void MFA::offer(const Waypoints &path, double cost)
    {
        const bool first = !incumbent_->hasPath();
        if (!incumbent_->offer(path, cost))
            return;
        if (first)
            evaluator_->setPartialPathEvent({});
        tighteningStale_ = true;
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
        published_ = true;
        if (const auto &callback = pdef_->getIntermediateSolutionCallback())
            callback(this, incumbent_->path().pointers(), cost);
    }

    void MFA::offerPartial(const Waypoints &path, std::size_t motion, const ob::State *lastValid)
    {
        double distance = 0.0;
        query_->goal()->isSatisfied(lastValid, &distance);
        if (distance >= incumbent_->partialDistance())
            return;
        // the piece of the motion up to the last valid state is discretised anew and may not be valid by itself
        if (evaluator_->checkMotion(path[motion], lastValid))
            incumbent_->offerPartial(path, motion + 1, lastValid, distance);
    }

    ob::PlannerStatus MFA::report()
    {
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        evaluator_->setStopCondition({});
        if (incumbent_->hasPath())
        {
            if (!published_)
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
