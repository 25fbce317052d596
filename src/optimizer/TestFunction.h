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

#ifndef OMPL_MFA_OPTIMIZER_TEST_FUNCTION_
#define OMPL_MFA_OPTIMIZER_TEST_FUNCTION_

#include <string>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/optimizer/ObjectiveFunction.h"

namespace ompl_mfa::optimizer
{
    /** \brief A function with known global optimum, over a cube in R^d. */
    class OMPL_MFA_EXPORT TestFunction : public ObjectiveFunction
    {
    public:
        /** \brief \e name is one of names(): throws InputError for any other. \e dimension is d >= 1, for rosenbrock d
            >= 2: throws InputError. With a \e shift (d x 1, or empty for none) the optimum is moved by that much, which
            reveals an optimiser that favours the centre; the cube stays. */
        TestFunction(const std::string &name, unsigned int dimension, const Eigen::VectorXd &shift = {});

        /** \brief The accepted names. sinc is eq. (19); for the others see Surjanovic and Bingham, Virtual Library of
            Simulation Experiments. */
        static const std::vector<std::string> &names();

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;

        /** \brief The value at \e x; sinc is to be maximised, the others are to be minimised. */
        double value(const Eigen::Ref<const Eigen::VectorXd> &x) const;

        /** \brief The function value that corresponds to \e brightness, whose cost is to be minimised. */
        double valueOf(const Brightness &brightness) const;

        const std::string &name() const
        {
            return name_;
        }

        /** \brief d x 1. */
        Eigen::VectorXd lower() const;
        Eigen::VectorXd upper() const;

        /** \brief The global optimum, d x 1. */
        Eigen::VectorXd optimum() const;

        /** \brief Whether \e x lies within 5 % of the cube's edge from the global optimum: 0.5 for eq. (19). */
        bool isNearOptimum(const Eigen::Ref<const Eigen::VectorXd> &x) const;

    private:
        std::string name_;
        Eigen::Index dimension_;
        double lower_;
        double upper_;

        /** \brief Every coordinate of the optimum before the shift. */
        double optimum_;
        Eigen::VectorXd shift_;
        double (*function_)(const Eigen::VectorXd &x);
        bool maximised_;
    };
}  // namespace ompl_mfa::optimizer

#endif
