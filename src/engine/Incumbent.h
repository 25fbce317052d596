/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_ENGINE_INCUMBENT_
#define OMPL_MFA_ENGINE_INCUMBENT_

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>

#include <ompl/base/OptimizationObjective.h>

#include "engine/PartKind.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief The best path known from a start to a goal; before there is one, the valid path that ends nearest to the
        goal. */
    class Incumbent
    {
    public:
        /** \brief Compares paths by \e objective and stores the cost of the best one in \e cost, which must outlive the
            object: infinity (not the objective's infinite cost) before there is one. */
        Incumbent(ompl::base::OptimizationObjectivePtr objective, const ompl::base::StateSpacePtr &space,
                  std::atomic<double> &cost);

        bool hasPath() const
        {
            return !path_.empty();
        }

        /** \brief Whether the best path has a finite cost. A path of infinite cost (through lethal cells of a cost map)
            is valid, but the search for a first path goes on. */
        bool hasFinitePath() const;

        /** \brief The cost that a path should beat: infinity (any path) before there is one; if the best path has
            infinite cost, the worst finite cost; else cost(). */
        double bound() const;

        const path::Waypoints &path() const
        {
            return path_;
        }

        /** \brief Cost of the best path; infinity (not the objective's infinite cost) before there is one. */
        double cost() const
        {
            return cost_.load(std::memory_order_relaxed);
        }

        /** \brief Whether a path of cost \e cost is better than the best one. */
        bool improvedBy(double cost) const;

        /** \brief Keeps \e path, whose motions are all valid, if it is better than the best so far. \e origin is the
            part that found it; none for a straight motion. */
        bool offer(const path::Waypoints &path, double cost, std::optional<PartKind> origin = std::nullopt);

        /** \brief The part that found the best path; none for a straight motion. */
        std::optional<PartKind> origin() const
        {
            return origin_;
        }

        /** \brief Number of improvements of the best path. */
        std::uint64_t improvements() const
        {
            return improvements_;
        }

        /** \brief The valid path that ends nearest to the goal. */
        const path::Waypoints &partialPath() const
        {
            return partial_;
        }

        /** \brief Distance from the end of partialPath() to the goal, in the goal's unit; infinity if there is no such
            path. */
        double partialDistance() const
        {
            return partialDistance_;
        }

        /** \brief Updates partialDistance() after the goal changed. */
        void setPartialDistance(double distance)
        {
            partialDistance_ = distance;
        }

        /** \brief Keeps the first \e count states of \e path followed by \e last, if \e last is nearer to the goal than
            the end of partialPath(). */
        bool offerPartial(const path::Waypoints &path, std::size_t count, const ompl::base::State *last,
                          double distance);

    private:
        ompl::base::OptimizationObjectivePtr objective_;
        path::Waypoints path_;
        path::Waypoints partial_;
        std::atomic<double> &cost_;
        std::uint64_t improvements_{0};
        std::optional<PartKind> origin_;
        double partialDistance_{std::numeric_limits<double>::infinity()};
    };
}  // namespace ompl_mfa::engine

#endif
