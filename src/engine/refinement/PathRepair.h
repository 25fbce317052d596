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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_PATH_REPAIR_
#define OMPL_MFA_ENGINE_REFINEMENT_PATH_REPAIR_

#include <cstdint>
#include <functional>

#include <Eigen/Core>

#include <ompl/util/RandomNumbers.h>

#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Makes a draft, a path that was only checked at a coarse resolution, valid at the resolution at which the
        evaluator checks: leads it around each run of invalid states over a random state beside it. */
    class PathRepair
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        PathRepair(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed);
        ~PathRepair();
        PathRepair(const PathRepair &) = delete;
        PathRepair &operator=(const PathRepair &) = delete;

        /** \brief What is known of a motion before it is checked. */
        enum class Knowledge : unsigned char
        {
            Nothing,
            Valid,       ///< at OMPL's resolution
            FinelyValid  ///< at the evaluator's fineness
        };
        using Known = std::function<Knowledge(const ompl::base::State *from, const ompl::base::State *to)>;

        /** \brief Repairs \e path in place; its vertices are assumed to be valid, as is its last state. False if that
            failed or was interrupted; \e path is then unspecified. Motions that are \e known are not checked again. */
        bool repair(path::Waypoints &path, const Known &known = {});

    private:
        /* A run of invalid states on a motion, by the states around it. */
        struct Gap
        {
            unsigned int before;  ///< number of the last state before the run that the detour leaves
            unsigned int after;   ///< number of the state behind the run that the detour reaches
            unsigned int length;  ///< number of states of the run, at least 1
        };

        bool check(const ompl::base::State *from, const ompl::base::State *to, Knowledge knowledge);
        bool findGap(const path::Waypoints &path, std::size_t motion, unsigned int segments, Gap &gap);
        bool isValidOn(const path::Waypoints &path, std::size_t motion, unsigned int segments, unsigned int number);
        bool bridge(path::Waypoints &path, std::size_t motion);
        bool findVia(double spread);
        bool leadsOver(const ompl::base::State *via);
        void shortenDetour();
        bool shiftVertices(path::Waypoints &path, std::size_t motion, double spread, double middle);
        static bool isMovable(const path::Waypoints &path, std::size_t vertex);
        double lengthAround(const path::Waypoints &path, std::size_t motion, std::size_t first);
        bool isShiftValid(const path::Waypoints &path, std::size_t motion, std::size_t first, double middle);
        void shortenShift(const path::Waypoints &path, std::size_t motion, double middle);
        void stateOn(const path::Waypoints &path, std::size_t motion, unsigned int segments, unsigned int number,
                     ompl::base::State *state) const;

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        ompl::RNG rng_;
        path::Waypoints states_;
        Eigen::VectorXd step_;
        double longest_{0.0};  ///< allowed length of a detour
    };
}  // namespace ompl_mfa::engine::refinement

#endif
