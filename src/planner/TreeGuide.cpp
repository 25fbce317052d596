#include "ompl_mfa/planner/TreeGuide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/tools/config/SelfConfig.h>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* Longest motion of a tree, in parts of the space's extent; OMPL's own default. */
        constexpr double RANGE = 0.2;
        /* Search of a nearest neighbour, in state checks. */
        constexpr std::uint64_t NEIGHBOUR_WORK = 8;
    }  // namespace

    TreeGuide::TreeGuide(const ob::Planner *planner, StateChartPtr chart, PathEvaluator &evaluator,
                         std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , sampler_(chart_, evaluator.bounds(), seed)
      , range_(RANGE * chart_->space()->getMaximumExtent())
      , sample_(chart_->space()->allocState())
      , step_(chart_->space()->allocState())
      , probe_{nullptr, nullptr}
    {
        for (Tree *tree : {&startTree_, &goalTree_})
            tree->nearest.reset(ompl::tools::SelfConfig::getDefaultNearestNeighbors<Vertex *>(planner));
        // distances are taken along the motions of each tree, away from the start or toward the goal
        startTree_.nearest->setDistanceFunction([this](const Vertex *a, const Vertex *b)
                                                { return chart_->space()->distance(a->state, b->state); });
        goalTree_.nearest->setDistanceFunction([this](const Vertex *a, const Vertex *b)
                                               { return chart_->space()->distance(b->state, a->state); });
    }

    TreeGuide::~TreeGuide()
    {
        freeVertices(startTree_);
        freeVertices(goalTree_);
        chart_->space()->freeState(sample_);
        chart_->space()->freeState(step_);
    }

    void TreeGuide::freeVertices(Tree &tree)
    {
        tree.nearest->clear();
        for (const auto &vertex : tree.vertices)
            chart_->space()->freeState(vertex->state);
        tree.vertices.clear();
        tree.roots = 0;
    }

    void TreeGuide::restart()
    {
        freeVertices(startTree_);
        freeVertices(goalTree_);
        startsTurn_ = true;
    }

    TreeGuide::Vertex *TreeGuide::addVertex(Tree &tree, const ob::State *state, const Vertex *parent)
    {
        tree.vertices.push_back(std::make_unique<Vertex>(Vertex{chart_->space()->cloneState(state), parent}));
        tree.nearest->add(tree.vertices.back().get());
        return tree.vertices.back().get();
    }

    void TreeGuide::addRoots(const Query &query)
    {
        for (; startTree_.roots < query.starts().size(); ++startTree_.roots)
            addVertex(startTree_, query.starts()[startTree_.roots], nullptr);
        for (; goalTree_.roots < query.goals().size(); ++goalTree_.roots)
            addVertex(goalTree_, query.goals()[goalTree_.roots], nullptr);
    }

    TreeGuide::Vertex *TreeGuide::nearest(Tree &tree, const ob::State *state, bool fromStart)
    {
        evaluator_.addWork(NEIGHBOUR_WORK);
        if (chart_->space()->hasSymmetricDistance())
        {
            probe_.state = const_cast<ob::State *>(state);  // the probe is only read
            return tree.nearest->nearest(&probe_);
        }
        // nearest-neighbour structures take distances to be symmetric
        const auto distance = [&](const std::unique_ptr<Vertex> &vertex)
        {
            return fromStart ? chart_->space()->distance(vertex->state, state)
                             : chart_->space()->distance(state, vertex->state);
        };
        evaluator_.addWork(tree.vertices.size());
        std::size_t best = 0;
        double bestDistance = distance(tree.vertices[0]);
        for (std::size_t i = 1; i < tree.vertices.size(); ++i)
        {
            const double d = distance(tree.vertices[i]);
            if (d < bestDistance)
            {
                bestDistance = d;
                best = i;
            }
        }
        return tree.vertices[best].get();
    }

    TreeGuide::Extension TreeGuide::extend(Tree &tree, bool fromStart, const ob::State *target, Vertex *&added)
    {
        const auto &space = chart_->space();
        Vertex *near = nearest(tree, target, fromStart);
        const ob::State *from = fromStart ? near->state : target;
        const ob::State *to = fromStart ? target : near->state;
        const double distance = space->distance(from, to);
        const bool reach = distance <= range_;
        if (reach)
            space->copyState(step_, target);
        else
        {
            space->interpolate(from, to, fromStart ? range_ / distance : 1.0 - range_ / distance, step_);
            space->enforceBounds(step_);
        }
        const bool valid = fromStart ? evaluator_.checkMotion(near->state, step_)
                                     : evaluator_.checkState(step_) && evaluator_.checkMotion(step_, near->state);
        if (!valid)
            return Extension::Trapped;
        added = addVertex(tree, step_, near);
        return reach ? Extension::Reached : Extension::Advanced;
    }

    void TreeGuide::join(const Vertex *fromStart, const Vertex *fromGoal, Waypoints &path) const
    {
        path.clear();
        for (; fromStart != nullptr; fromStart = fromStart->parent)
            path.append(fromStart->state);
        path.reverse();
        // both trees hold the state at which they met
        for (fromGoal = fromGoal->parent; fromGoal != nullptr; fromGoal = fromGoal->parent)
            path.append(fromGoal->state);
    }

    bool TreeGuide::iterate(const Query &query, double bound, Waypoints &path)
    {
        const bool fromStart = startsTurn_;
        startsTurn_ = !startsTurn_;
        auto &rng = sampler_.rng();
        const auto pick = [&rng](std::size_t size)
        { return static_cast<std::size_t>(rng.uniformInt(0, static_cast<int>(size) - 1)); };
        const ob::State *start = query.starts()[pick(query.starts().size())];
        const ob::State *goal = query.goals()[pick(query.goals().size())];
        evaluator_.addWork(1);
        if (!sampler_.sample(start, goal, bound, sample_))
            return false;
        Tree &tree = fromStart ? startTree_ : goalTree_;
        Tree &other = fromStart ? goalTree_ : startTree_;
        Vertex *added = nullptr;
        if (extend(tree, fromStart, sample_, added) == Extension::Trapped)
            return false;
        Vertex *met = nullptr;
        Extension extension = Extension::Advanced;
        while (extension == Extension::Advanced && !evaluator_.interrupted())
            extension = extend(other, !fromStart, added->state, met);
        if (extension != Extension::Reached)
            return false;
        join(fromStart ? added : met, fromStart ? met : added, path);
        return path.size() >= 2;
    }

    bool TreeGuide::advance(const Query &query, double bound, std::uint64_t work, Waypoints &path)
    {
        if (query.starts().empty() || query.goals().empty())
            return false;
        addRoots(query);
        const std::uint64_t limit = evaluator_.work() + work;
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            if (iterate(query, bound, path))
            {
                restart();
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa
