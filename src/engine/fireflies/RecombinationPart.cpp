#include "engine/fireflies/RecombinationPart.h"

#include <utility>

#include "engine/fireflies/FireflyPart.h"

namespace ompl_mfa
{
    namespace
    {
        /* A splice may be this many times worse than the best path and still be worth tightening. */
        constexpr double SLACK = 1.1;
    }  // namespace

    RecombinationPart::RecombinationPart(const SearchContext &context, std::shared_ptr<Swarms> swarms, bool guided)
      : SearchPart(PartKind::Recombination, context)
      , swarms_(std::move(swarms))
      , guided_(guided)
    {
    }

    Share RecombinationPart::firstShare() const
    {
        return {0.03, 0.03};
    }

    Share RecombinationPart::improvementShare(double seconds) const
    {
        return {0.04, 0.04, FIREFLIES_DELAY * seconds};
    }

    Readiness RecombinationPart::readiness() const
    {
        const Swarm *swarm = swarms_->current();
        if (swarm == nullptr || swarms_->mustChoose() || swarm->frame().slices() == 0 ||
            swarm->fireflies().evaluations() == 0)
            return Readiness::Idle;
        return guided_ && guidesFirst(context()) ? Readiness::Waiting : Readiness::Ready;
    }

    void RecombinationPart::advance(std::uint64_t work, Findings &findings)
    {
        Swarm *swarm = swarms_->active();
        if (swarm == nullptr)
            return;
        if (WindowSwarm *window = swarms_->window())
        {
            if (window->recombine(work))
                swarms_->endGeneration(findings);
            return;
        }
        const Incumbent &incumbent = context().incumbent;
        Waypoints onSlices(context().chart->space());
        Waypoints spliced(context().chart->space());
        if (!incumbent.hasPath() || !swarm->frame().crossings(incumbent.path(), onSlices))
            onSlices.clear();
        const double bound =
            context().evaluator().withSlack(incumbent.bound(), context().settings.tightening ? SLACK : 1.0);
        if (swarm->recombine(onSlices, bound, work, spliced))
            propose(std::move(spliced), findings);
    }
}  // namespace ompl_mfa
