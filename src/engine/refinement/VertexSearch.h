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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_VERTEX_SEARCH_
#define OMPL_MFA_ENGINE_REFINEMENT_VERTEX_SEARCH_

#include <Eigen/Core>

#include <ompl/util/RandomNumbers.h>

namespace ompl_mfa::engine::refinement
{
    /** \brief Random steps of one vertex of a path with a distribution that adapts to their success: a (1+1)-CMA-ES
        that shrinks its steps across the constraints it runs into.

        D. V. Arnold and N. Hansen, A (1+1)-CMA-ES for constrained optimisation, GECCO 2012; its equations and
        constants. */
    class VertexSearch
    {
    public:
        /** \brief Steps in R^d, d >= 1, with initial standard deviation \e sigma > 0. */
        VertexSearch(Eigen::Index dimension, double sigma);

        double sigma() const
        {
            return sigma_;
        }

        /** \brief Draws a step (d). One of the three functions below has to report its result. */
        void draw(ompl::RNG &rng, Eigen::Ref<Eigen::VectorXd> step);

        /** \brief The last step was valid and better, and was made. */
        void succeeded();

        /** \brief The last step was no better. */
        void failed();

        /** \brief The last step was better but not valid. */
        void violated();

    private:
        void adaptSigma(bool success);

        double sigma_;
        double successRate_;
        Eigen::MatrixXd factor_;          ///< A with covariance A A^T, d x d
        Eigen::VectorXd normal_;          ///< z, the last standard normal vector
        Eigen::VectorXd direction_;       ///< A z
        Eigen::VectorXd evolutionPath_;   ///< s
        Eigen::VectorXd constraintPath_;  ///< v
    };
}  // namespace ompl_mfa::engine::refinement

#endif
