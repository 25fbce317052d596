#ifndef OMPL_MFA_PLANNER_INFORMED_SAMPLER_
#define OMPL_MFA_PLANNER_INFORMED_SAMPLER_

#include <memory>
#include <vector>

#include <ompl/util/ProlateHyperspheroid.h>
#include <ompl/util/RandomNumbers.h>

#include "ompl_mfa/path/CostBounds.h"
#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief Draws states through which a path better than a given cost can lead, as far as the bounds tell (the
        informed set).

        Where the objective is path length over the standard metrics, positions are drawn directly from the prolate
        hyperspheroid of one pair of start and goal; elsewhere uniform states are rejected by the heuristic. Random
        numbers come from a generator of its own, so that the same seed gives the same states. */
    class InformedSampler
    {
    public:
        /** \brief \e bounds outlives the object. */
        InformedSampler(StateChartPtr chart, const CostBounds &bounds, std::uint_fast32_t seed);

        /** \brief Draws \e state for the pair \e start, \e goal such that the heuristic cost through it is better than
            \e bound (infinite: any state). False if no such state was found in a few tries. */
        bool sample(const ompl::base::State *start, const ompl::base::State *goal, double bound,
                    ompl::base::State *state);

        ompl::RNG &rng()
        {
            return rng_;
        }

    private:
        bool samplePositions(const ompl::base::State *start, const ompl::base::State *goal, double bound,
                             ompl::base::State *state);

        StateChartPtr chart_;
        const CostBounds &bounds_;
        ompl::RNG rng_;
        bool direct_;
        Eigen::VectorXd focus1_;
        Eigen::VectorXd focus2_;
        Eigen::VectorXd values_;
        Eigen::VectorXd hyperspheroidFocus1_;
        Eigen::VectorXd hyperspheroidFocus2_;
        std::shared_ptr<ompl::ProlateHyperspheroid> hyperspheroid_;
    };
}  // namespace ompl_mfa

#endif
