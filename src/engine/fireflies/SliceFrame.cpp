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

#include "engine/fireflies/SliceFrame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* An orthonormal basis (n x (n-1)) of the complement of the unit vector t, by the Householder reflection that
           maps t to the first unit vector. */
        Eigen::MatrixXd lateralBasis(const Eigen::VectorXd &t)
        {
            const Eigen::Index n = t.size();
            Eigen::VectorXd v = t;
            v[0] += v[0] < 0.0 ? -1.0 : 1.0;
            const Eigen::MatrixXd reflection =
                Eigen::MatrixXd::Identity(n, n) - (2.0 / v.squaredNorm()) * v * v.transpose();
            return reflection.rightCols(n - 1);
        }

        /* Rotates a basis of the complement of the unit vector from into one of that of to, by the smallest rotation
           that maps from to to. With such bases on neighbouring slices, equal coordinates make a smooth path. */
        Eigen::MatrixXd turnedBasis(const Eigen::MatrixXd &basis, const Eigen::VectorXd &from,
                                    const Eigen::VectorXd &to)
        {
            const double denominator = 1.0 + from.dot(to);
            if (denominator < 1e-6)
            {
                return lateralBasis(to);
            }
            const Eigen::VectorXd sum = from + to;
            // the basis has no component along from
            return basis - sum * (to.transpose() * basis) / denominator;
        }
    }  // namespace

    SliceFrame SliceFrame::straight(const path::StateChartPtr &chart, const ob::State *start, const ob::State *goal,
                                    unsigned int segments)
    {
        Eigen::VectorXd delta(chart->dimension());
        chart->difference(start, goal, delta);
        path::Waypoints axis(chart->space());
        axis.resize(segments + 1);
        for (unsigned int k = 1; k < segments; ++k)
        {
            chart->displace(start, delta * (static_cast<double>(k) / segments), axis[k]);
        }
        chart->space()->copyState(axis[0], start);
        chart->space()->copyState(axis[segments], goal);
        return {chart, std::move(axis)};
    }

    SliceFrame::SliceFrame(path::StateChartPtr chart, path::Waypoints axis)
      : chart_(std::move(chart))
      , axis_(std::move(axis))
    {
        if (axis_.size() < 2)
        {
            throw std::invalid_argument("SliceFrame: an axis has at least two states, not " +
                                        std::to_string(axis_.size()));
        }
        Eigen::Index dimension = 0;
        for (std::size_t k = 0; k + 2 < axis_.size(); ++k)
        {
            slices_.push_back(makeSlice(k, dimension));
            dimension += slices_.back().dimension;
        }
        lower_.resize(dimension);
        upper_.resize(dimension);
        for (std::size_t k = 0; k < slices_.size(); ++k)
        {
            setBounds(k);
        }
    }

    SliceFrame::Slice SliceFrame::makeSlice(std::size_t k, Eigen::Index offset) const
    {
        const Eigen::Index n = chart_->positionDimension();
        Eigen::VectorXd delta(chart_->dimension());
        chart_->difference(axis_[k], axis_[k + 2], delta);
        const double length = delta.head(n).norm();
        Slice slice{offset, 0, Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd::Zero(n)};
        if (length > 1e-9)
        {
            slice.along = delta.head(n) / length;
            const bool turns = !slices_.empty() && !slices_.back().along.isZero();
            slice.basis = turns ? turnedBasis(slices_.back().basis, slices_.back().along, slice.along)
                                : lateralBasis(slice.along);
        }
        slice.dimension = slice.basis.cols() + chart_->rotationDimension();
        return slice;
    }

    void SliceFrame::setBounds(std::size_t k)
    {
        const Slice &slice = slices_[k];
        const Eigen::Index lateral = slice.basis.cols();
        // for positions without bounds, the length of the axis determines how far they are searched
        const double unbounded = 4.0 * std::max(1.0, chart_->distance(axis_.front(), axis_.back()));
        for (Eigen::Index i = 0; i < lateral; ++i)
        {
            const double up = chart_->reach(axis_[k + 1], slice.basis.col(i));
            const double down = chart_->reach(axis_[k + 1], -slice.basis.col(i));
            upper_[slice.offset + i] = std::isfinite(up) ? up : unbounded;
            lower_[slice.offset + i] = -(std::isfinite(down) ? down : unbounded);
        }
        const Eigen::VectorXd &rotation = chart_->rotationReach();
        upper_.segment(slice.offset + lateral, rotation.size()) = rotation;
        lower_.segment(slice.offset + lateral, rotation.size()) = -rotation;
    }

    void SliceFrame::toState(std::size_t k, const Eigen::Ref<const Eigen::VectorXd> &x, ob::State *state,
                             Eigen::VectorXd &scratch) const
    {
        const Slice &slice = slices_[k];
        const Eigen::Index lateral = slice.basis.cols();
        scratch.resize(chart_->dimension());
        scratch.head(chart_->positionDimension()).noalias() = slice.basis * x.segment(slice.offset, lateral);
        scratch.tail(chart_->rotationDimension()) = x.segment(slice.offset + lateral, chart_->rotationDimension());
        chart_->displace(axis_[k + 1], scratch, state);
    }

    void SliceFrame::toWaypoints(const Eigen::Ref<const Eigen::VectorXd> &x, path::Waypoints &path,
                                 Eigen::VectorXd &scratch) const
    {
        path.resize(axis_.size());
        chart_->space()->copyState(path[0], axis_.front());
        for (std::size_t k = 0; k < slices_.size(); ++k)
        {
            toState(k, x, path[k + 1], scratch);
        }
        chart_->space()->copyState(path[slices_.size() + 1], axis_.back());
    }

    void SliceFrame::toCoordinates(const path::Waypoints &path, Eigen::Ref<Eigen::VectorXd> x) const
    {
        const Eigen::Index rotations = chart_->rotationDimension();
        Eigen::VectorXd delta(chart_->dimension());
        for (std::size_t k = 0; k < slices_.size(); ++k)
        {
            const Slice &slice = slices_[k];
            const Eigen::Index lateral = slice.basis.cols();
            chart_->difference(axis_[k + 1], path[k + 1], delta);
            x.segment(slice.offset, lateral).noalias() =
                slice.basis.transpose() * delta.head(chart_->positionDimension());
            x.segment(slice.offset + lateral, rotations) = delta.tail(rotations);
        }
    }

    bool SliceFrame::crossings(const path::Waypoints &path, path::Waypoints &onSlices) const
    {
        const auto &space = chart_->space();
        const Eigen::Index n = chart_->positionDimension();
        Eigen::VectorXd delta(chart_->dimension());
        onSlices.resize(axis_.size());
        space->copyState(onSlices[0], axis_.front());
        space->copyState(onSlices[slices_.size() + 1], axis_.back());
        std::size_t j = 0;
        for (std::size_t k = 0; k < slices_.size(); ++k)
        {
            if (slices_[k].along.isZero())
            {
                return false;
            }
            const auto abscissa = [&](const ob::State *state)
            {
                chart_->difference(axis_[k + 1], state, delta);
                return slices_[k].along.dot(delta.head(n));
            };
            while (j + 1 < path.size() && abscissa(path[j + 1]) < 0.0)
            {
                ++j;
            }
            if (j + 1 >= path.size())
            {
                return false;
            }
            const double before = abscissa(path[j]);
            const double after = abscissa(path[j + 1]);
            const double fraction = before < 0.0 ? before / (before - after) : 0.0;
            chart_->interpolate(path[j], path[j + 1], fraction, onSlices[k + 1]);
            space->enforceBounds(onSlices[k + 1]);
        }
        return true;
    }

    std::vector<path::Waypoints> SliceFrame::sliceEnds() const
    {
        std::vector<path::Waypoints> result;
        path::Waypoints ends(chart()->space());
        ends.resize(2);
        Eigen::VectorXd scratch;
        for (std::size_t k = 0; k < slices(); ++k)
        {
            const auto [first, count] = sliceRange(k);
            for (Eigen::Index i = first; i < first + count; ++i)
            {
                Eigen::VectorXd x = Eigen::VectorXd::Zero(dimension());
                x[i] = lower()[i];
                toState(k, x, ends[0], scratch);
                x[i] = upper()[i];
                toState(k, x, ends[1], scratch);
                result.push_back(ends);
            }
        }
        return result;
    }
}  // namespace ompl_mfa::engine::fireflies
