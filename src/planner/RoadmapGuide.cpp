#include "ompl_mfa/planner/RoadmapGuide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/constants/constants.hpp>

#include <ompl/tools/config/SelfConfig.h>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* A raw path of the roadmap may be this much worse than the best tightened one and still be worth tightening.
         */
        constexpr double SLACK = 1.15;
        /* Search of the nearest neighbours, in state checks for each of them. */
        constexpr std::uint64_t NEIGHBOUR_WORK = 4;
        /* A turn is at least so much work for each edge, of which the pass that begins a search takes a small part. */
        constexpr std::uint64_t WORK_AN_EDGE = 4;
    }  // namespace

    RoadmapGuide::RoadmapGuide(const ob::Planner *planner, StateChartPtr chart, PathEvaluator &evaluator,
                               std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , sampler_(chart_, evaluator.bounds(), seed)
      , graph_(evaluator)
      , nearest_(ompl::tools::SelfConfig::getDefaultNearestNeighbors<std::size_t>(planner))
      , missing_(batch_)
      , best_(std::numeric_limits<double>::infinity())
      , sample_(chart_->space()->allocState())
    {
        nearest_->setDistanceFunction([this](std::size_t a, std::size_t b)
                                      { return chart_->space()->distance(graph_.state(a), graph_.state(b)); });
    }

    RoadmapGuide::~RoadmapGuide()
    {
        chart_->space()->freeState(sample_);
    }

    std::size_t RoadmapGuide::add(const ob::State *state)
    {
        const std::size_t vertex = graph_.addVertex(state, true);
        const auto d = static_cast<double>(chart_->space()->getDimension());
        const double factor = boost::math::constants::e<double>() * (1.0 + 1.0 / d);
        const auto k = static_cast<std::size_t>(std::ceil(factor * std::log(static_cast<double>(vertex + 2))));
        nearest_->nearestK(vertex, k, neighbours_);
        const bool bothWays = chart_->space()->hasSymmetricDistance() && chart_->space()->hasSymmetricInterpolate();
        for (const std::size_t neighbour : neighbours_)
        {
            if (!graph_.addEdge(neighbour, vertex, bothWays) ||
                (!bothWays && !graph_.addEdge(vertex, neighbour, false)))
                break;
        }
        nearest_->add(vertex);
        evaluator_.addWork(NEIGHBOUR_WORK * neighbours_.size());
        return vertex;
    }

    void RoadmapGuide::addEnds(const Query &query)
    {
        for (; starts_ < query.starts().size() && !evaluator_.stopped(); ++starts_)
            graph_.setStart(add(query.starts()[starts_]));
        for (; goals_ < query.goals().size() && !evaluator_.stopped(); ++goals_)
            graph_.setGoal(add(query.goals()[goals_]));
    }

    void RoadmapGuide::addBatch(const Query &query, double bound, std::uint64_t limit)
    {
        auto &rng = sampler_.rng();
        const auto pick = [&rng](std::size_t size)
        { return static_cast<std::size_t>(rng.uniformInt(0, static_cast<int>(size) - 1)); };
        while (missing_ > 0 && evaluator_.work() < limit && !evaluator_.stopped())
        {
            const ob::State *start = query.starts()[pick(query.starts().size())];
            const ob::State *goal = query.goals()[pick(query.goals().size())];
            evaluator_.addWork(1);
            if (!sampler_.sample(start, goal, bound, sample_) || !evaluator_.checkState(sample_))
                continue;
            add(sample_);
            --missing_;
        }
    }

    bool RoadmapGuide::advance(const Query &query, double bound, std::uint64_t work, Waypoints &path)
    {
        if (query.starts().empty() || query.goals().empty())
            return false;
        addEnds(query);
        const std::uint64_t limit = evaluator_.work() + std::max<std::uint64_t>(work, WORK_AN_EDGE * graph_.edges());
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            addBatch(query, bound, limit);
            if (missing_ > 0)
                return false;
            // a path is also worth having if it is a better one of the roadmap and not much worse than the best
            // tightened
            const double slack = evaluator_.withSlack(bound, SLACK);
            const bool beaten =
                std::isinf(best_) || evaluator_.objective()->isCostBetterThan(ob::Cost(slack), ob::Cost(best_));
            if (graph_.search(beaten ? slack : best_, limit > evaluator_.work() ? limit - evaluator_.work() : 0, path))
            {
                best_ = evaluator_.cost(path).value();
                return true;
            }
            if (graph_.exhausted())
            {
                missing_ = batch_;
                batch_ += batch_ / 4;
            }
        }
        return false;
    }
}  // namespace ompl_mfa
