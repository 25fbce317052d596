#include "engine/TurnSharing.h"

#include <algorithm>
#include <limits>

namespace ompl_mfa
{
    namespace
    {
        /* What a past turn still counts for after another turn of any part. */
        constexpr double MEMORY = 0.9;
        /* What is shared out by gain; the floors come on top. */
        constexpr double PAYOFF = 0.4;
    }  // namespace

    std::size_t TurnSharing::add(const Share &share)
    {
        Part part;
        part.share = share.weight;
        part.floor = share.floor;
        part.pass = share.delay;
        parts_.push_back(part);
        return parts_.size() - 1;
    }

    std::optional<std::size_t> TurnSharing::next(const std::vector<Readiness> &readiness)
    {
        std::optional<std::size_t> best = leastWorked(readiness, Readiness::Ready);
        if (!best)
            best = leastWorked(readiness, Readiness::Waiting);
        if (!best)
            return best;
        // a part that could not take its turns does not get them all at once later
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (readiness[i] == Readiness::Idle)
                parts_[i].pass = std::max(parts_[i].pass, parts_[*best].pass);
        }
        return best;
    }

    std::optional<std::size_t> TurnSharing::leastWorked(const std::vector<Readiness> &readiness, Readiness wanted) const
    {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (readiness[i] == wanted && (!best || parts_[i].pass < parts_[*best].pass))
                best = i;
        }
        return best;
    }

    double TurnSharing::share(std::size_t part) const
    {
        double sum = 0.0;
        for (const Part &p : parts_)
            sum += p.share;
        return parts_[part].share / sum;
    }

    void TurnSharing::record(std::size_t part, double work, const std::vector<double> &gains)
    {
        parts_[part].pass += work / share(part);
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            parts_[i].gain = MEMORY * parts_[i].gain + gains[i];
            parts_[i].work *= MEMORY;
        }
        parts_[part].work += work;
        adapt();
    }

    void TurnSharing::adapt()
    {
        double sum = 0.0;
        for (const Part &p : parts_)
            sum += p.work > 0.0 ? p.gain / p.work : 0.0;
        if (sum <= 0.0)
            return;
        for (Part &p : parts_)
            p.share = p.floor + (p.work > 0.0 ? PAYOFF * p.gain / p.work : 0.0) / sum;
    }
}  // namespace ompl_mfa
