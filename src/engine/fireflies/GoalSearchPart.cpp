#include "engine/fireflies/GoalSearchPart.h"

namespace ompl_mfa
{
    namespace
    {
        /* Work between two turns, for each goal state that was found. */
        constexpr std::uint64_t PAUSE = 400;
    }  // namespace

    GoalSearchPart::GoalSearchPart(const SearchContext &context)
      : SearchPart(PartKind::GoalSearch, context)
    {
    }

    Share GoalSearchPart::firstShare() const
    {
        return {0.2, 0.2};
    }

    Share GoalSearchPart::improvementShare(double /*seconds*/) const
    {
        return {0.05, 0.05};
    }

    Readiness GoalSearchPart::readiness() const
    {
        const Query &query = context().query;
        if (query.starts().empty() || query.hasEnoughGoals())
            return Readiness::Idle;
        // the more goal states there are, the less another is worth
        return query.goals().empty() || context().evaluator().work() >= due_ ? Readiness::Ready : Readiness::Idle;
    }

    /* A generation. */
    void GoalSearchPart::advance(std::uint64_t /*work*/, Findings &findings)
    {
        PathEvaluator &evaluator = context().evaluator();
        if (!search_)
            search_ = std::make_unique<GoalSearch>(context().chart, context().spaceInformation(),
                                                   context().query.goal(), context().query.starts().front(),
                                                   streamSeed(context().seed, Stream::GoalSearch));
        const std::uint64_t before = search_->evaluations();
        if (search_->advance([&] { return evaluator.stopped(); }, findings.goals))
            due_ = evaluator.work() + PAUSE * ++found_;
        evaluator.addChecks(search_->evaluations() - before);
    }
}  // namespace ompl_mfa
