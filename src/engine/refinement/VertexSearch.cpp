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

#include "engine/refinement/VertexSearch.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        constexpr double TARGET_SUCCESS = 2.0 / 11.0;
        constexpr double SUCCESS_RATE_WEIGHT = 1.0 / 12.0;
    }  // namespace

    VertexSearch::VertexSearch(Eigen::Index dimension, double sigma)
      : sigma_(sigma)
      , successRate_(TARGET_SUCCESS)
      , factor_(Eigen::MatrixXd::Identity(dimension, dimension))
      , normal_(Eigen::VectorXd::Zero(dimension))
      , direction_(Eigen::VectorXd::Zero(dimension))
      , evolutionPath_(Eigen::VectorXd::Zero(dimension))
      , constraintPath_(Eigen::VectorXd::Zero(dimension))
    {
    }

    void VertexSearch::draw(ompl::RNG &rng, Eigen::Ref<Eigen::VectorXd> step)
    {
        for (Eigen::Index i = 0; i < normal_.size(); ++i)
        {
            normal_[i] = rng.gaussian01();
        }
        direction_.noalias() = factor_ * normal_;
        step = sigma_ * direction_;
    }

    void VertexSearch::adaptSigma(bool success)
    {
        const double damping = 1.0 + 0.5 * static_cast<double>(normal_.size());
        successRate_ = (1.0 - SUCCESS_RATE_WEIGHT) * successRate_ + (success ? SUCCESS_RATE_WEIGHT : 0.0);
        sigma_ *= std::exp((successRate_ - TARGET_SUCCESS) / (1.0 - TARGET_SUCCESS) / damping);
    }

    void VertexSearch::succeeded()
    {
        adaptSigma(true);
        const auto n = static_cast<double>(normal_.size());
        const double pathWeight = 2.0 / (n + 2.0);
        const double covarianceWeight = 2.0 / (n * n + 6.0);
        evolutionPath_ = (1.0 - pathWeight) * evolutionPath_ + std::sqrt(pathWeight * (2.0 - pathWeight)) * direction_;
        // A' A'^T = (1 - c) A A^T + c s s^T
        const Eigen::VectorXd w = factor_.partialPivLu().solve(evolutionPath_);
        const double norm = w.squaredNorm();
        if (!(norm > 1e-12))
        {
            return;
        }
        const double a = std::sqrt(1.0 - covarianceWeight);
        const double b = a / norm * (std::sqrt(1.0 + covarianceWeight * norm / (1.0 - covarianceWeight)) - 1.0);
        factor_ = a * factor_ + b * evolutionPath_ * w.transpose();
    }

    void VertexSearch::failed()
    {
        adaptSigma(false);
    }

    void VertexSearch::violated()
    {
        const auto n = static_cast<double>(normal_.size());
        const double pathWeight = 1.0 / (n + 2.0);
        const double shrinking = 0.1 / (n + 2.0);
        constraintPath_ = (1.0 - pathWeight) * constraintPath_ + pathWeight * direction_;
        const Eigen::VectorXd w = factor_.partialPivLu().solve(constraintPath_);
        const double norm = w.squaredNorm();
        if (norm > 1e-12)
        {
            factor_ -= shrinking / norm * constraintPath_ * w.transpose();
        }
    }
}  // namespace ompl_mfa::engine::refinement
