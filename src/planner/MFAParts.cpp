/* The parts of the search that MFA gives turns to. */

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ompl_mfa/path/PathDeformation.h"
#include "ompl_mfa/planner/MFA.h"
#include "ompl_mfa/planner/Streams.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* Pairs of start and goal beyond these get no swarm of their own. */
        constexpr std::size_t MAX_SWARMS = 8;
        /* Paths of other homotopy classes that are kept as axes of windows. */
        constexpr std::size_t MAX_ALTERNATIVES = 3;
        /* A path is an alternative if its tightened cost is at most this many times the best. */
        constexpr double ALTERNATIVE = 1.1;
        /* A splice may be this much worse than the best path and still be worth tightening. */
        constexpr double SPLICE_SLACK = 1.1;
        /* The same for a firefly. */
        constexpr double FIREFLY_SLACK = 1.2;
        /* Generations in a window. */
        constexpr unsigned int WINDOW_GENERATIONS = 15;
        /* One window in so many has its slices across the path, not across the straight motion. */
        constexpr std::size_t CURVED_WINDOWS = 3;
        /* Rounds of tightening that a new path gets at the most, and the work of each, in parts of the work of checking
           the path once. */
        constexpr unsigned int TIGHTENING_ROUNDS = 8;
        constexpr std::uint64_t TIGHTENING_FACTOR = 3;
        /* How far beside a motion that OMPL cannot compute a state lies, in parts of its length. */
        constexpr double ASIDE = 1e-4;
        /* Motions between a firefly and the path that tell whether they are of one homotopy class. */
        constexpr unsigned int RUNGS = 7;
        /* A new path is given up once so many more rounds like the last would not make it the best. */
        constexpr double PATIENCE = 4.0;
        /* Where there is no path yet: work and time (s) of the trees before the roadmap begins, and state checks of
           both before fireflies and recombination do, whose first turns take thousands of them. */
        constexpr std::uint64_t FIRST_TREES = 14000;
        constexpr double FIRST_TREES_TIME = 0.01;
        constexpr double ROADMAP_LEAD = 2.0;
        constexpr std::uint64_t FIRST_GUIDES = 50000;
        /* Dimensions beyond which the roadmap has less of the time, and below which more, but no more than so many
           times as much. */
        constexpr double ROADMAP_DIMENSIONS = 3.0;
        constexpr double MOST_ROADMAP = 1.5;
        /* Fireflies and trees begin to improve a path after these multiples of the time that it took: where a first
           path is hard to find, another is too. */
        constexpr double FIREFLIES_DELAY = 10.0;
        constexpr double TREES_DELAY = 6.7;
    }  // namespace

    void MFA::prepareParts()
    {
        spent_.assign(PARTS, 0.0);
        if (guidePlanner_)
            plannerGuide_ = std::make_unique<PlannerGuide>(guidePlanner_, pdef_->getGoal(), *evaluator_);
        paper_ = search_.isPaper() && !plannerGuide_;
        shareForFirstPath();
        if (search_.usesTrees())
            trees_ = std::make_unique<TreeGuide>(this, chart_, *evaluator_, streamSeed(runSeed_, Stream::Trees));
        hasRoadmap_ = search_.usesRoadmap();
        windowRandom_ = RandomSource(streamSeed(runSeed_, Stream::Windows));
        probes_ = 0;
        followedStraight_ = false;
    }

    /* Before there is a path, nearly all goes to the guides that find one soonest. */
    void MFA::shareForFirstPath()
    {
        sharing_ = TurnSharing();
        sharing_.add(0.05, 0.05, 0.0);  // FIREFLIES
        sharing_.add(0.03, 0.03, 0.0);  // RECOMBINATION
        sharing_.add(0.01, 0.01, 0.0);  // TIGHTENING
        sharing_.add(0.30, 0.30, 0.0);  // TREES
        sharing_.add(0.61, 0.61, 0.0);  // ROADMAP
        if (plannerGuide_)
            sharing_.add(0.30, 0.30, 0.0);  // PLANNER
    }

    void MFA::shareForImprovement()
    {
        const double soFar = std::accumulate(spent_.begin(), spent_.end(), 0.0);
        // a roadmap of n states leaves gaps of n^(-1/d): the more dimensions, the less it finds
        const double roadmap = std::min(MOST_ROADMAP, ROADMAP_DIMENSIONS / static_cast<double>(chart_->dimension()));
        const double others = 1.0 - roadmap;
        const double fireflies = 0.08 + 0.14 * std::max(0.0, others);
        sharing_ = TurnSharing();
        sharing_.add(fireflies, fireflies, FIREFLIES_DELAY * soFar);    // FIREFLIES
        sharing_.add(0.04, 0.04, FIREFLIES_DELAY * soFar);              // RECOMBINATION
        sharing_.add(0.30, 0.12, 0.0);                                  // TIGHTENING
        sharing_.add(0.15, 0.08 + 0.10 * others, TREES_DELAY * soFar);  // TREES
        sharing_.add(0.20 * roadmap, 0.32 * roadmap, 0.0);              // ROADMAP
        if (plannerGuide_)
            sharing_.add(0.20, 0.20, 0.0);  // PLANNER
    }

    void MFA::forgetParts()
    {
        activeSwarm_ = nullptr;
        swarms_.clear();
        axes_.clear();
        window_.reset();
        alternatives_.clear();
        nextSwarm_ = windows_ = nextAlternative_ = 0;
        trees_.reset();
        roadmap_.reset();
        hasRoadmap_ = false;
        plannerGuide_.reset();
        tightening_.reset();
        newTightening_.reset();
        tighteningStale_ = false;
        untaken_.clear();
        firefly_.clear();
    }

    std::vector<bool> MFA::availableParts() const
    {
        std::vector<bool> available(PARTS, false);
        const bool ends = !query_->starts().empty() && !query_->goals().empty();
        const bool guidePlanner = ends && plannerGuide_ && plannerGuide_->accepts(*query_);
        const bool guided = guidePlanner || (ends && (trees_ || hasRoadmap_));
        const bool waiting = guided && !improving_ && evaluator_->checks() < FIRST_GUIDES;
        available[FIREFLIES] = !waiting && (!axes_.empty() || !swarms_.empty() || window_);
        available[RECOMBINATION] = !waiting && search_.recombination && activeSwarm_ != nullptr &&
                                   activeSwarm_->frame().slices() > 0 && activeSwarm_->fireflies().evaluations() > 0;
        // a single motion can be made no better, but around what makes its cost infinite
        available[TIGHTENING] = search_.tightening && incumbent_->hasPath() &&
                                (incumbent_->path().size() > 2 || !incumbent_->hasFinitePath());
        // where checks are cheap, their number says little
        const bool early =
            trees_ && !improving_ && (evaluator_->work() < FIRST_TREES || spent_[TREES] < FIRST_TREES_TIME);
        available[ROADMAP] = hasRoadmap_ && ends && !early;
        // what the trees had before it began the roadmap has, twice over, before they go on
        const bool roadmapFirst = available[ROADMAP] && !improving_ && spent_[ROADMAP] < ROADMAP_LEAD * spent_[TREES];
        available[TREES] = trees_ && ends && !roadmapFirst;
        available[PLANNER] = guidePlanner;
        return available;
    }

    void MFA::takeTurn(Part part, std::uint64_t work)
    {
        switch (part)
        {
            case FIREFLIES:
                return fly(work);
            case RECOMBINATION:
                return recombine(work);
            case TIGHTENING:
                return tighten(work);
            case TREES:
                return follow(*trees_, work);
            case ROADMAP:
                if (!roadmap_)
                    roadmap_ = std::make_unique<RoadmapGuide>(this, chart_, *evaluator_,
                                                              streamSeed(runSeed_, Stream::Roadmap));
                return follow(*roadmap_, work);
            default:
                return follow(*plannerGuide_, work);
        }
    }

    void MFA::tryStraightMotions()
    {
        const Waypoints &starts = query_->starts();
        const Waypoints &goals = query_->goals();
        triedGoals_.resize(starts.size(), 0);
        for (std::size_t i = 0; i < starts.size(); ++i)
        {
            for (std::size_t &j = triedGoals_[i]; j < goals.size(); ++j)
            {
                // one that the stop condition cut short has its turn in the next solve()
                if (evaluator_->stopped() || !tryStraightMotion(i, j))
                    return;
            }
        }
    }

    /* Where guides search, how far the straight motion leads is only asked once they have not found a path soon. */
    void MFA::followStraightMotion()
    {
        if (followedStraight_ || !guided() || incumbent_->hasPath() || evaluator_->work() < FIRST_TREES ||
            query_->goals().empty())
            return;
        evaluator_->evaluate(straightPath(query_->starts().front(), query_->goals().front()), nullptr);
        followedStraight_ = true;
    }

    /* The motion from start to goal; where OMPL cannot compute that, two motions over a state a little beside it. */
    Waypoints MFA::straightPath(const ob::State *start, const ob::State *goal) const
    {
        Waypoints path(si_->getStateSpace());
        path.append(start);
        path.append(goal);
        const DubinsGuard &guard = chart_->guard();
        const double aside = ASIDE * chart_->distance(start, goal);
        if (guard.allows(start, goal) || !std::isfinite(aside))
            return path;
        path.insert(1, start);
        for (Eigen::Index i = 0; i < 2 * chart_->positionDimension(); ++i)
        {
            chart_->interpolate(start, goal, 0.5, path[1]);
            si_->enforceBounds(path[1]);
            const Eigen::VectorXd step = Eigen::VectorXd::Unit(chart_->dimension(), i / 2);
            chart_->displace(path[1], (i % 2 == 0 ? aside : -aside) * step, path[1]);
            if (guard.allows(start, path[1]) && guard.allows(path[1], goal))
                break;
        }
        return path;
    }

    bool MFA::guided() const
    {
        return trees_ || hasRoadmap_ || plannerGuide_;
    }

    /* False if the stop condition cut the check short. */
    bool MFA::tryStraightMotion(std::size_t start, std::size_t goal)
    {
        const Waypoints path = straightPath(query_->starts()[start], query_->goals()[goal]);
        const double cost = evaluator_->cost(path).value();
        const bool valid = evaluator_->checkPath(path);
        if (evaluator_->interrupted())
            return false;
        if (valid)
            offer(path, cost);
        else if (!guided())
            evaluator_->evaluate(path, nullptr);  // for the partial path
        ++evaluations_;
        if (swarms_.size() + axes_.size() < MAX_SWARMS)
            axes_.emplace_back(start, goal);
        return true;
    }

    /* Swarms on straight axes are made when the first of them is to fly: as a rule a guide has found a path before. */
    void MFA::laySwarms()
    {
        for (; !axes_.empty() && !evaluator_->stopped(); axes_.erase(axes_.begin()))
        {
            const auto [start, goal] = axes_.front();
            SliceFrame frame =
                SliceFrame::straight(chart_, query_->starts()[start], query_->goals()[goal], search_.slices + 1);
            if (frame.dimension() > 0)
                swarms_.push_back(makeSwarm(std::move(frame), streamSeed(runSeed_, Stream::Swarm, swarms_.size())));
        }
    }

    /* The paper's fireflies are points on the slices, those of the whole engine smooth paths. */
    std::unique_ptr<Swarm> MFA::makeSwarm(SliceFrame frame, std::uint64_t seed)
    {
        return std::make_unique<Swarm>(
            std::move(frame), paper_ ? Swarm::Coordinates::Offsets : Swarm::Coordinates::Modes, *evaluator_,
            swarmSettings(), seed,
            [this](const Waypoints &valid, const Brightness &brightness) { takeFirefly(valid, brightness.cost); });
    }

    /* A valid firefly is compared with the best path at once; the best of a turn that is none yet may become so. */
    void MFA::takeFirefly(const Waypoints &path, double cost)
    {
        offer(path, cost);
        const bool fresh = objective_->isCostBetterThan(ob::Cost(incumbent_->cost()), ob::Cost(cost));
        if (!search_.tightening || !fresh ||
            (!firefly_.empty() && !objective_->isCostBetterThan(ob::Cost(cost), ob::Cost(fireflyCost_))))
            return;
        firefly_ = path;
        fireflyCost_ = cost;
    }

    /* A part of the best path, any as likely as any other; where the slices are laid across the path, the alternatives
       have their turns too. */
    void MFA::openWindow()
    {
        const bool curved = windows_ % CURVED_WINDOWS == CURVED_WINDOWS - 1;
        const std::size_t axis = curved ? windows_ / CURVED_WINDOWS % (alternatives_.size() + 1) : 0;
        WindowSwarm::Window window{axis == 0 ? incumbent_->path() : alternatives_[axis - 1], 0, 0, incumbent_->cost()};
        const auto vertices = static_cast<unsigned int>(window.path.size());
        // a single motion can only be replaced where it is all there is
        window.first = vertices > 2 ? windowRandom_.index(vertices - 2) : 0;
        const auto nearest = std::min<std::size_t>(window.first + 2, vertices - 1);
        window.last = nearest + windowRandom_.index(static_cast<unsigned int>(vertices - nearest));
        auto settings = swarmSettings();
        settings.generations = std::min(settings.generations, WINDOW_GENERATIONS);
        ++windows_;
        window_ =
            WindowSwarm::open(std::move(window), curved ? WindowSwarm::Frame::Curved : WindowSwarm::Frame::Straight,
                              (search_.slices + 1) / 2, chart_, *evaluator_, settings,
                              streamSeed(runSeed_, Stream::WindowSwarm, windows_));
    }

    /* The swarms on the straight axes take turns by generations. Once there is a path, those in windows of it have
       every other turn, or all of them where there is only one axis: the whole path is a window too. */
    void MFA::chooseSwarm()
    {
        activeSwarm_ = nullptr;
        laySwarms();
        const bool windows = incumbent_->hasPath() && !paper_;
        if (windows && (swarms_.size() < 2 || nextSwarm_++ % 2 == 0))
        {
            if (!window_ || window_->exhausted())
                openWindow();
            if (window_)
                activeSwarm_ = &window_->swarm();
        }
        if (activeSwarm_ == nullptr && !swarms_.empty())
            activeSwarm_ = swarms_[iterations_ / (2UL * search_.generations) % swarms_.size()].get();
    }

    /* A generation, or a part of one if the work is done; true if it was completed. */
    bool MFA::flyStep(std::uint64_t work)
    {
        const std::uint64_t limit = evaluator_->work() + work;
        const std::uint64_t before = activeSwarm_->evaluations();
        const bool completed = activeSwarm_->step([&] { return evaluator_->work() >= limit || evaluator_->stopped(); });
        evaluations_ += activeSwarm_->evaluations() - before;
        if (completed && activeSwarm_->fireflies().generation() > 0)
            ++iterations_;
        return completed;
    }

    void MFA::fly(std::uint64_t work)
    {
        if (activeSwarm_ == nullptr)
            chooseSwarm();
        if (activeSwarm_ == nullptr)
            return;
        if (window_ && activeSwarm_ == &window_->swarm())
        {
            if (flyStep(work))
            {
                pursueWindow();
                chooseSwarm();
            }
            return;
        }
        // a path that tightening cannot make the best is of no use; the paper's fireflies know no such bound
        if (!paper_)
            activeSwarm_->setBound(
                evaluator_->withSlack(incumbent_->bound(), search_.tightening ? FIREFLY_SLACK : 1.0));
        if (flyStep(work))
            chooseSwarm();
        // one that can be deformed into the best path would only be tightened to that
        if (!firefly_.empty() && !seemDeformable(*evaluator_, firefly_, incumbent_->path(), RUNGS))
            offerTightened(firefly_);
        firefly_.clear();
    }

    /* The way that the fireflies of a window found is compared with the one that is there, after tightening; then the
       window has served. */
    void MFA::pursueWindow()
    {
        if (window_->found().empty() || evaluator_->stopped())
            return;
        activeSwarm_ = nullptr;
        const std::unique_ptr<WindowSwarm> window = std::move(window_);
        ob::Cost cost = evaluator_->cost(window->found());
        if (!search_.tightening)
        {
            if (objective_->isCostBetterThan(cost, window->cost()))
                offerTightened(window->withWay(window->found()));
            return;
        }
        if (seemDeformable(*evaluator_, window->found(), window->part(), RUNGS))
            return;
        cost = tightenAgainst(window->found(), cost, window->cost());
        if (objective_->isCostBetterThan(cost, window->cost()))
            offerTightened(window->withWay(newTightening_->path()));
    }

    void MFA::recombine(std::uint64_t work)
    {
        if (window_ && activeSwarm_ == &window_->swarm())
        {
            if (window_->recombine(work))
            {
                pursueWindow();
                chooseSwarm();
            }
            return;
        }
        Waypoints onSlices(si_->getStateSpace());
        Waypoints spliced(si_->getStateSpace());
        if (!incumbent_->hasPath() || !activeSwarm_->frame().crossings(incumbent_->path(), onSlices))
            onSlices.clear();
        const double bound = evaluator_->withSlack(incumbent_->bound(), search_.tightening ? SPLICE_SLACK : 1.0);
        if (activeSwarm_->recombine(onSlices, bound, work, spliced))
            offerTightened(spliced);
    }

    void MFA::tighten(std::uint64_t work)
    {
        prepareTightening();
        if (tighteningStale_)
            tightening_->begin(incumbent_->path());
        tighteningStale_ = false;
        if (!tightening_->advance(work))
            return;
        offer(tightening_->path(), tightening_->cost().value());
        tighteningStale_ = false;
    }

    void MFA::prepareTightening()
    {
        if (tightening_)
            return;
        tightening_ = std::make_unique<PathTightening>(chart_, *evaluator_, streamSeed(runSeed_, Stream::Tightening));
        newTightening_ =
            std::make_unique<PathTightening>(chart_, *evaluator_, streamSeed(runSeed_, Stream::NewTightening));
    }

    void MFA::follow(Guide &guide, std::uint64_t work)
    {
        Waypoints path(si_->getStateSpace());
        if (guide.advance(*query_, incumbent_->bound(), work, path))
            offerTightened(path);
    }

    /* A path from a guide or a splice is far from the best of its homotopy class: it is compared after tightening. */
    void MFA::offerTightened(const Waypoints &path)
    {
        ob::Cost cost = evaluator_->cost(path);
        if (evaluator_->interrupted())
        {
            untaken_ = path;
            return;
        }
        ++evaluations_;
        offer(path, cost.value());
        if (!search_.tightening)
            return;
        cost = tightenAgainst(path, cost, ob::Cost(incumbent_->bound()));
        if (!incumbent_->improvedBy(cost.value()))
            return keepAlternative(newTightening_->path(), cost.value());
        // the best path's own tightening goes on from here
        offer(newTightening_->path(), cost.value());
        std::swap(tightening_, newTightening_);
        tighteningStale_ = false;
    }

    /* Tightens a path of this cost until it is better than the rival, or for as long as what the last rounds gained
       promises that it will be. Returns the cost of what newTightening_ then has. */
    ob::Cost MFA::tightenAgainst(const Waypoints &path, ob::Cost cost, ob::Cost rival)
    {
        std::uint64_t check = path.size();
        for (std::size_t i = 1; i < path.size(); ++i)
            check += si_->getStateSpace()->validSegmentCount(path[i - 1], path[i]);
        prepareTightening();
        newTightening_->begin(path);
        for (unsigned int k = 0; k < TIGHTENING_ROUNDS && !newTightening_->converged() && !evaluator_->stopped(); ++k)
        {
            newTightening_->advance(TIGHTENING_FACTOR * check);
            const double before = cost.value();
            cost = newTightening_->cost();
            if (objective_->isCostBetterThan(cost, rival))
                break;
            // what a cost that is still infinite promises is unknown
            const ob::Cost promised(cost.value() - PATIENCE * (before - cost.value()));
            if (k > 0 && std::isfinite(cost.value()) && !objective_->isCostBetterThan(promised, rival))
                break;
        }
        return cost;
    }

    void MFA::keepAlternative(const Waypoints &path, double cost)
    {
        if (objective_->isCostBetterThan(ob::Cost(evaluator_->withSlack(incumbent_->cost(), ALTERNATIVE)),
                                         ob::Cost(cost)))
            return;
        if (alternatives_.size() < MAX_ALTERNATIVES)
            alternatives_.push_back(path);
        else
            alternatives_[nextAlternative_++ % MAX_ALTERNATIVES] = path;
    }
}  // namespace ompl_mfa
