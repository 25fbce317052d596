#include "engine/EndPairs.h"

namespace ompl_mfa
{
    std::optional<std::pair<std::size_t, std::size_t>> EndPairs::next(const Query &query)
    {
        goals_.resize(query.starts().size(), 0);
        for (std::size_t i = 0; i < goals_.size(); ++i)
        {
            if (goals_[i] < query.goals().size())
            {
                last_ = i;
                return std::make_pair(i, goals_[i]++);
            }
        }
        return std::nullopt;
    }

    void EndPairs::putBack()
    {
        --goals_[last_];
    }
}  // namespace ompl_mfa
