#include "engine/guides/HyperspheroidCache.h"

#include <algorithm>
#include <memory>

namespace ompl_mfa
{
    namespace
    {
        /* Numbers that all of them have together: two matrices and two foci each. */
        constexpr std::size_t NUMBERS = 1000000;
        constexpr std::size_t FEWEST = 16;
        constexpr std::size_t MOST = 4096;

        std::size_t capacityFor(Eigen::Index dimension)
        {
            const auto d = static_cast<std::size_t>(dimension);
            return std::clamp(NUMBERS / (2 * d * (d + 1)), FEWEST, MOST);
        }
    }  // namespace

    HyperspheroidCache::HyperspheroidCache(Eigen::Index dimension)
      : capacity_(capacityFor(dimension))
    {
    }

    const ompl::ProlateHyperspheroidPtr &HyperspheroidCache::of(std::size_t pair, const Eigen::VectorXd &focus1,
                                                                const Eigen::VectorXd &focus2)
    {
        const std::size_t index = pair % capacity_;
        if (index >= slots_.size())
            slots_.resize(index + 1);
        Slot &slot = slots_[index];
        if (slot.hyperspheroid && slot.focus1 == focus1 && slot.focus2 == focus2)
            return slot.hyperspheroid;
        size_ += slot.hyperspheroid ? 0 : 1;
        slot.focus1 = focus1;
        slot.focus2 = focus2;
        slot.hyperspheroid = std::make_shared<ompl::ProlateHyperspheroid>(static_cast<unsigned int>(focus1.size()),
                                                                          focus1.data(), focus2.data());
        return slot.hyperspheroid;
    }
}  // namespace ompl_mfa
