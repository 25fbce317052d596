#ifndef OMPL_MFA_ENGINE_GUIDES_HYPERSPHEROID_CACHE_
#define OMPL_MFA_ENGINE_GUIDES_HYPERSPHEROID_CACHE_

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <ompl/util/ProlateHyperspheroid.h>

namespace ompl_mfa
{
    /** \brief Prolate hyperspheroids of pairs of foci. To make one takes a singular value decomposition, d^3 operations
        in R^d, so that those of up to some thousand pairs are kept; their memory is bounded, by some megabytes. */
    class HyperspheroidCache
    {
    public:
        /** \brief \e dimension >= 2 is the number of coordinates of a focus. */
        explicit HyperspheroidCache(Eigen::Index dimension);

        /** \brief The hyperspheroid of \e focus1 and \e focus2, whose pair has the number \e pair. One is made where
            none is kept of a pair of this number and these foci. */
        const ompl::ProlateHyperspheroidPtr &of(std::size_t pair, const Eigen::VectorXd &focus1,
                                                const Eigen::VectorXd &focus2);

        /** \brief How many are kept. */
        std::size_t size() const
        {
            return size_;
        }

        /** \brief How many are kept at the most. Pairs of consecutive numbers, no more than these, do not displace each
            other. */
        std::size_t capacity() const
        {
            return capacity_;
        }

    private:
        struct Slot
        {
            Eigen::VectorXd focus1;
            Eigen::VectorXd focus2;
            ompl::ProlateHyperspheroidPtr hyperspheroid;
        };

        std::size_t capacity_;
        std::size_t size_{0};
        std::vector<Slot> slots_;
    };
}  // namespace ompl_mfa

#endif
