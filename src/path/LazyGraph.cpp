#include "ompl_mfa/path/LazyGraph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();
        /* Edges found invalid in one forward search, at the least, before the cost-to-go is computed anew, which has to
           be worth its price, too. */
        constexpr unsigned int STALE_AFTER = 24;
        /* Edges that a search handles for the price of one state check. */
        constexpr std::uint64_t EDGES_PER_WORK = 2;
        /* Vertices handled between two looks at the stop condition. */
        constexpr std::size_t VERTICES_BETWEEN_STOPS = 64;
        /* A motion is screened at states at least so many steps apart. */
        constexpr unsigned int SCREENING_STRIDE = 3;
        /* Times that a cost-to-go may be handed on anew in a graph where cycles may earn something. */
        constexpr unsigned int MAX_EXPANSIONS = 20;
    }  // namespace

    LazyGraph::LazyGraph(PathEvaluator &evaluator)
      : evaluator_(evaluator)
      , states_(evaluator.spaceInformation()->getStateSpace())
    {
    }

    void LazyGraph::clear()
    {
        states_.clear();
        vertices_.clear();
        edges_.clear();
        checks_.clear();
        starts_.clear();
        goals_.clear();
        acyclic_ = true;
    }

    std::size_t LazyGraph::addVertex(const ob::State *state, bool valid)
    {
        states_.append(state);
        vertices_.push_back(
            {{}, {}, 0.0, 0.0, NONE, 0, false, false, false, valid ? Validity::Valid : Validity::Unknown});
        return vertices_.size() - 1;
    }

    void LazyGraph::setStart(std::size_t vertex)
    {
        starts_.push_back(vertex);
    }

    void LazyGraph::setGoal(std::size_t vertex)
    {
        vertices_[vertex].goal = true;
        goals_.push_back(vertex);
    }

    bool LazyGraph::addEdge(std::size_t from, std::size_t to, bool bothWays)
    {
        ob::Cost cost;
        if (!evaluator_.motionCost(states_[from], states_[to], cost))
            return false;
        // an objective calls itself symmetric by default where the space is, mechanical work too
        ob::Cost reverse = cost;
        if (bothWays && !evaluator_.bounds().certain() && !evaluator_.motionCost(states_[to], states_[from], reverse))
            return false;
        acyclic_ = acyclic_ && from < to && !bothWays;
        const auto add = [&](std::size_t a, std::size_t b, ob::Cost ab)
        {
            vertices_[a].out.push_back(edges_.size());
            vertices_[b].in.push_back(edges_.size());
            edges_.push_back({a, b, checks_.size(), ab.value()});
        };
        add(from, to, cost);
        if (bothWays)
            add(to, from, reverse);
        checks_.push_back(Validity::Unknown);
        return true;
    }

    bool LazyGraph::better(double a, double b) const
    {
        return evaluator_.objective()->isCostBetterThan(ob::Cost(a), ob::Cost(b));
    }

    double LazyGraph::combine(double a, double b) const
    {
        return evaluator_.objective()->combineCosts(ob::Cost(a), ob::Cost(b)).value();
    }

    bool LazyGraph::canBeat(double cost, double bound) const
    {
        return std::isinf(bound) || better(cost, bound);
    }

    void LazyGraph::push(std::vector<QueueEntry> &queue, QueueEntry entry) const
    {
        queue.push_back(entry);
        std::push_heap(queue.begin(), queue.end(),
                       [this](const QueueEntry &a, const QueueEntry &b) { return better(b.key, a.key); });
    }

    LazyGraph::QueueEntry LazyGraph::pop(std::vector<QueueEntry> &queue) const
    {
        std::pop_heap(queue.begin(), queue.end(),
                      [this](const QueueEntry &a, const QueueEntry &b) { return better(b.key, a.key); });
        const QueueEntry entry = queue.back();
        queue.pop_back();
        return entry;
    }

    /* Cost-to-go of every vertex from which a goal can be reached by motions not known to be invalid. False if
       interrupted. */
    bool LazyGraph::backward(double bound)
    {
        for (std::size_t v = 0; v < vertices_.size(); ++v)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                return false;
            vertices_[v].reaches = false;
            vertices_[v].expansions = 0;
        }
        for (const std::size_t goal : goals_)
        {
            vertices_[goal].costToGo = evaluator_.objective()->terminalCost(states_[goal]).value();
            vertices_[goal].reaches = true;
        }
        // a bad end of a path cannot be made up for where no motion earns anything
        const bool monotone = evaluator_.bounds().monotone();
        return acyclic_ && !monotone ? backwardInOrder() : backwardBestFirst(monotone, bound);
    }

    bool LazyGraph::backwardInOrder()
    {
        for (std::size_t v = vertices_.size(); v-- > 0;)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                return false;
            if (!vertices_[v].reaches)
                continue;
            for (const std::size_t e : vertices_[v].in)
                relax(edges_[e]);
        }
        evaluator_.addWork(1 + edges_.size() / EDGES_PER_WORK);
        return true;
    }

    bool LazyGraph::backwardBestFirst(bool monotone, double bound)
    {
        // where motions earn something, a cycle might make its vertices better for ever
        const unsigned int expansions = monotone ? 1 : MAX_EXPANSIONS;
        queue_.clear();
        for (const std::size_t goal : goals_)
            push(queue_, {vertices_[goal].costToGo, goal});
        std::uint64_t handled = 0;
        std::uint64_t popped = 0;
        while (!queue_.empty())
        {
            if (++popped % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                return false;
            const QueueEntry entry = pop(queue_);
            Vertex &vertex = vertices_[entry.index];
            if (better(vertex.costToGo, entry.key) || vertex.expansions >= expansions)
                continue;
            ++vertex.expansions;
            for (const std::size_t e : vertex.in)
            {
                ++handled;
                const Edge &edge = edges_[e];
                if ((!monotone || canBeat(combine(edge.cost, vertex.costToGo), bound)) && relax(edge))
                    push(queue_, {vertices_[edge.from].costToGo, edge.from});
            }
        }
        evaluator_.addWork(1 + handled / EDGES_PER_WORK);
        return true;
    }

    /* Takes an edge for the way to the goal if it is better than what is known. */
    bool LazyGraph::relax(const Edge &edge)
    {
        Vertex &vertex = vertices_[edge.from];
        if (checks_[edge.check] == Validity::Invalid || vertex.validity == Validity::Invalid)
            return false;
        const double cost = combine(edge.cost, vertices_[edge.to].costToGo);
        if (vertex.reaches && !better(cost, vertex.costToGo))
            return false;
        vertex.reaches = true;
        vertex.costToGo = cost;
        return true;
    }

    /* Checks the state at the end of a motion first: an invalid one rules out all motions to it at once. */
    bool LazyGraph::screenEdge(const Edge &edge)
    {
        Vertex &to = vertices_[edge.to];
        if (to.validity == Validity::Unknown)
            to.validity = evaluator_.checkState(states_[edge.to]) ? Validity::Valid : Validity::Invalid;
        return to.validity == Validity::Valid &&
               evaluator_.screenMotion(states_[edge.from], states_[edge.to], SCREENING_STRIDE);
    }

    /* Checks the motions of the path to this goal; most of those that a search screens are of no path. */
    LazyGraph::Outcome LazyGraph::confirm(std::size_t goal, std::uint64_t limit)
    {
        for (std::size_t v = goal; vertices_[v].parent != NONE; v = edges_[vertices_[v].parent].from)
        {
            const Edge &edge = edges_[vertices_[v].parent];
            Validity &validity = checks_[edge.check];
            if (validity == Validity::Valid)
                continue;
            if (evaluator_.work() >= limit)
                return Outcome::Stopped;
            const bool valid = evaluator_.checkMotion(states_[edge.from], states_[edge.to]);
            if (evaluator_.interrupted())
                return Outcome::Stopped;
            validity = valid ? Validity::Valid : Validity::Invalid;
            if (!valid)
                return Outcome::Stale;
        }
        return Outcome::Found;
    }

    void LazyGraph::expand(std::size_t v, double bound)
    {
        for (const std::size_t e : vertices_[v].out)
        {
            const Edge &edge = edges_[e];
            const Vertex &to = vertices_[edge.to];
            if (to.reached || !to.reaches || to.validity == Validity::Invalid ||
                checks_[edge.check] == Validity::Invalid)
                continue;
            const double key = combine(combine(vertices_[v].costToCome, edge.cost), to.costToGo);
            if (canBeat(key, bound))
                push(queue_, {key, e});
        }
    }

    /* Takes up to \e limit of PathEvaluator::work(); from \e renewal on a new backward pass is worth its price. */
    LazyGraph::Outcome LazyGraph::forward(double bound, std::uint64_t limit, std::uint64_t renewal, std::size_t &goal)
    {
        for (std::size_t v = 0; v < vertices_.size(); ++v)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                return Outcome::Stopped;
            vertices_[v].reached = false;
        }
        queue_.clear();
        for (const std::size_t start : starts_)
        {
            Vertex &vertex = vertices_[start];
            vertex.reached = true;
            vertex.parent = NONE;
            vertex.costToCome = evaluator_.objective()->initialCost(states_[start]).value();
            expand(start, bound);
        }
        unsigned int invalid = 0;
        std::uint64_t handled = 0;
        while (!queue_.empty())
        {
            const std::size_t e = pop(queue_).index;
            const Edge &edge = edges_[e];
            if (++handled % EDGES_PER_WORK == 0)
                evaluator_.addWork(1);
            if (handled % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                return Outcome::Stopped;
            if (vertices_[edge.to].reached || vertices_[edge.to].validity == Validity::Invalid)
                continue;
            Validity &validity = checks_[edge.check];
            if (validity == Validity::Unknown)
            {
                if (evaluator_.work() >= limit)
                    return Outcome::Stopped;
                const bool valid = screenEdge(edge);
                if (evaluator_.interrupted())
                    return Outcome::Stopped;
                validity = valid ? Validity::Screened : Validity::Invalid;
                invalid += valid ? 0 : 1;
            }
            if (validity == Validity::Invalid)
            {
                if (invalid >= STALE_AFTER && evaluator_.work() >= renewal)
                    return Outcome::Stale;
                continue;
            }
            Vertex &vertex = vertices_[edge.to];
            vertex.reached = true;
            vertex.parent = e;
            vertex.costToCome = combine(vertices_[edge.from].costToCome, edge.cost);
            if (vertex.goal)
            {
                goal = edge.to;
                return confirm(goal, limit);
            }
            expand(edge.to, bound);
        }
        return Outcome::Exhausted;
    }

    void LazyGraph::extract(std::size_t goal, Waypoints &path) const
    {
        path.clear();
        std::size_t vertex = goal;
        path.append(states_[vertex]);
        while (vertices_[vertex].parent != NONE)
        {
            vertex = edges_[vertices_[vertex].parent].from;
            path.append(states_[vertex]);
        }
        path.reverse();
    }

    bool LazyGraph::search(double bound, std::uint64_t work, Waypoints &path)
    {
        const std::uint64_t limit = evaluator_.work() + work;
        exhausted_ = false;
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            const std::uint64_t before = evaluator_.work();
            if (!backward(bound))
                return false;
            const std::uint64_t now = evaluator_.work();
            std::size_t goal = NONE;
            // in a large graph the backward pass alone may use up the work: the motions still get a share of their own
            switch (forward(bound, std::max(limit, now + work / 2), now + (now - before), goal))
            {
                case Outcome::Found:
                    extract(goal, path);
                    return true;
                case Outcome::Exhausted:
                    exhausted_ = true;
                    return false;
                case Outcome::Stopped:
                    return false;
                case Outcome::Stale:
                    break;
            }
        }
        return false;
    }
}  // namespace ompl_mfa
