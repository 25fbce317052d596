#include "engine/StraightMotions.h"

#include <cmath>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* How far beside a motion that OMPL cannot compute a state lies, in parts of its length. */
        constexpr double ASIDE = 1e-4;
        /* Work of the guides before the first straight motion is followed for a partial path. */
        constexpr std::uint64_t FIRST_WORK = 14000;
    }  // namespace

    StraightMotions::StraightMotions(const SearchContext &context, bool guided)
      : context_(context)
      , guided_(guided)
    {
    }

    void StraightMotions::advance(Findings &findings)
    {
        PathEvaluator &evaluator = context_.evaluator();
        while (const auto pair = pairs_.next(context_.query))
        {
            if (evaluator.stopped())
            {
                pairs_.putBack();
                return;
            }
            Waypoints straight = path(context_.query.starts()[pair->first], context_.query.goals()[pair->second]);
            const ob::Cost cost = evaluator.cost(straight);
            const bool valid = evaluator.checkPath(straight);
            if (evaluator.interrupted())
            {
                pairs_.putBack();
                return;
            }
            ++context_.progress.evaluations;
            if (!valid && !guided_)
                evaluator.evaluate(straight, nullptr);  // for the partial path
            if (valid)
            {
                findings.paths.push_back({std::move(straight), cost, Proposal::Stage::Straight, std::nullopt});
                return;
            }
        }
        followFirst();
    }

    void StraightMotions::followFirst()
    {
        if (followed_ || !guided_ || context_.incumbent.hasPath() || context_.evaluator().work() < FIRST_WORK ||
            context_.query.goals().empty())
            return;
        context_.evaluator().evaluate(path(context_.query.starts().front(), context_.query.goals().front()), nullptr);
        followed_ = true;
    }

    /* The motion from start to goal; where OMPL cannot compute that, two motions over a state a little beside it. */
    Waypoints StraightMotions::path(const ob::State *start, const ob::State *goal) const
    {
        const StateChart &chart = *context_.chart;
        const auto &space = chart.space();
        Waypoints path(space);
        path.append(start);
        path.append(goal);
        const DubinsGuard &guard = chart.guard();
        const double aside = ASIDE * chart.distance(start, goal);
        if (guard.allows(start, goal) || !std::isfinite(aside))
            return path;
        path.insert(1, start);
        for (Eigen::Index i = 0; i < 2 * chart.positionDimension(); ++i)
        {
            chart.interpolate(start, goal, 0.5, path[1]);
            space->enforceBounds(path[1]);
            const Eigen::VectorXd step = Eigen::VectorXd::Unit(chart.dimension(), i / 2);
            chart.displace(path[1], (i % 2 == 0 ? aside : -aside) * step, path[1]);
            if (guard.allows(start, path[1]) && guard.allows(path[1], goal))
                break;
        }
        return path;
    }
}  // namespace ompl_mfa
