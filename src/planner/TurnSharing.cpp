#include "ompl_mfa/planner/TurnSharing.h"

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

    std::size_t TurnSharing::add(double share, double floor, double delay)
    {
        Part part;
        part.share = share;
        part.floor = floor;
        part.pass = delay;
        parts_.push_back(part);
        return parts_.size() - 1;
    }

    std::size_t TurnSharing::next(const std::vector<bool> &available)
    {
        std::size_t best = parts_.size();
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (available[i] && (best == parts_.size() || parts_[i].pass < parts_[best].pass))
                best = i;
        }
        // a part that could not take its turns does not get them all at once later
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (!available[i])
                parts_[i].pass = std::max(parts_[i].pass, parts_[best].pass);
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

    void TurnSharing::record(std::size_t part, double work, double gain)
    {
        parts_[part].pass += work / share(part);
        for (Part &p : parts_)
        {
            p.gain *= MEMORY;
            p.work *= MEMORY;
        }
        parts_[part].gain += gain;
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
