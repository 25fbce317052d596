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

#ifndef OMPL_MFA_OPTIMIZER_OBJECTIVE_FUNCTION_
#define OMPL_MFA_OPTIMIZER_OBJECTIVE_FUNCTION_

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"

namespace ompl_mfa
{
    /** \brief The brightness of a point, eq. (1): only the order of two brightnesses matters.

        A point without violation is brighter than any with one. */
    struct Brightness
    {
        /** \brief By how much the constraints are violated; 0 for a feasible point, never negative or NaN. For a path:
            the length of its invalid segments, in the unit of the state space's distance. */
        double violation{std::numeric_limits<double>::infinity()};

        /** \brief The objective value, to be compared by ObjectiveFunction::isBrighter only. */
        double cost{std::numeric_limits<double>::infinity()};

        bool isFeasible() const
        {
            return violation == 0.0;
        }
    };

    /** \brief What a FireflyOptimizer optimises: a map from R^d to a brightness order. */
    class OMPL_MFA_EXPORT ObjectiveFunction
    {
    public:
        virtual ~ObjectiveFunction() = default;

        /** \brief The brightness of \e x (d x 1, within the box of the optimiser).

            If a \e rival is given, the caller needs \e x only if it is brighter: as soon as it is known not to be,
            the evaluation may stop and return a default-constructed Brightness (infinitely dim). */
        virtual Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) = 0;

        /** \brief Called before some columns of \e points (d x k), those where \e wanted (k) is true, are evaluated one
            after the other, so that an objective can compute many values at once. Fewer may be evaluated, none is if
            the optimiser is interrupted, and after an interruption the call may be repeated. */
        virtual void prepare(const Eigen::Ref<const Eigen::MatrixXd> & /*points*/, const std::vector<bool> & /*wanted*/)
        {
        }

        /** \brief Whether \e a is strictly brighter than \e b: less violation first, then lower cost. Override for
            another order, which must be a strict weak order. */
        virtual bool isBrighter(const Brightness &a, const Brightness &b) const
        {
            if (a.violation != b.violation)
            {
                return a.violation < b.violation;
            }
            return a.cost < b.cost;
        }
    };
}  // namespace ompl_mfa

#endif
