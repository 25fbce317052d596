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

#include "engine/fireflies/Swarm.h"

#include <algorithm>
#include <utility>

#include "engine/Streams.h"

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Candidates per slice: points of the brightest fireflies, and as many fresh states. */
        constexpr std::size_t FIREFLY_CANDIDATES = 20;
        constexpr std::size_t FRESH_CANDIDATES = 16;
        /* Operations of the optimiser that take as long as one unit of PathEvaluator::addWork. */
        constexpr std::uint64_t OPERATIONS_A_WORK_UNIT = 8;
    }  // namespace

    Swarm::Swarm(SliceFrame frame, Coordinates coordinates, path::PathEvaluator &evaluator,
                 const FireflyOptimizer::Settings &settings, std::uint64_t seed,
                 SliceObjective::ValidPathEvent validPath)
      : frame_(std::move(frame))
      , evaluator_(evaluator)
      , modes_(coordinates == Coordinates::Modes && SliceModes::exist(frame_) ? std::make_unique<SliceModes>(frame_)
                                                                              : nullptr)
      , objective_(frame_, modes_.get(), evaluator, std::move(validPath))
      , graph_(frame_, evaluator)
      , random_(streamSeed(seed, Stream::Recombination))
      , point_(frame_.chart()->space())
      , coordinates_(frame_.dimension())
      , seed_(seed)
      , fireflies_(makeFireflies(settings, streamSeed(seed, Stream::Epoch)))
    {
    }

    std::unique_ptr<FireflyOptimizer> Swarm::makeFireflies(const FireflyOptimizer::Settings &settings,
                                                           std::uint64_t seed) const
    {
        return modes_ ? std::make_unique<FireflyOptimizer>(settings, modes_->lower(), modes_->upper(), seed)
                      : std::make_unique<FireflyOptimizer>(settings, frame_.lower(), frame_.upper(), seed);
    }

    void Swarm::setBound(double bound)
    {
        if (objective_.setBound(bound))
        {
            fireflies_->orderChanged(objective_);
        }
    }

    void Swarm::pathOf(Eigen::Index i, path::Waypoints &path) const
    {
        Eigen::VectorXd offsets = fireflies_->population().col(i);
        if (modes_)
        {
            modes_->toCoordinates(fireflies_->population().col(i), offsets);
        }
        Eigen::VectorXd scratch;
        frame_.toWaypoints(offsets, path, scratch);
    }

    void Swarm::inject(const path::Waypoints &path)
    {
        Eigen::VectorXd x(frame_.dimension());
        frame_.toCoordinates(path, x);
        if (modes_)
        {
            coordinates_ = x;
            modes_->toAmplitudes(coordinates_, x);
        }
        fireflies_->inject(x);
    }

    void Swarm::beginEpoch()
    {
        const FireflyOptimizer &old = *fireflies_;
        ++epoch_;
        auto fresh = makeFireflies(old.settings(), streamSeed(seed_, Stream::Epoch, epoch_));
        fresh->inject(old.best());
        const std::size_t elites = old.order().size() / 5;
        for (std::size_t i = 1; i < elites; ++i)
        {
            fresh->inject(old.population().col(old.order()[i]));
        }
        earlierEvaluations_ += old.evaluations();
        countedOperations_ = 0;
        fireflies_ = std::move(fresh);
    }

    /* Adds the points of the brightest fireflies and fresh states on each slice; false if interrupted. */
    bool Swarm::addCandidates()
    {
        graph_.clear();
        point_.resize(1);
        const auto &order = fireflies_->order();
        const std::size_t count = std::min(FIREFLY_CANDIDATES, order.size());
        for (std::size_t i = 0; i < count; ++i)
        {
            if (evaluator_.stopped() || !objective_.toOffsets(fireflies_->population().col(order[i]), coordinates_))
            {
                return false;
            }
            for (std::size_t k = 0; k < frame_.slices(); ++k)
            {
                frame_.toState(k, coordinates_, point_[0], scratch_);
                graph_.addCandidate(k, point_[0]);
            }
        }
        for (std::size_t k = 0; k < frame_.slices(); ++k)
        {
            if (evaluator_.stopped())
            {
                return false;
            }
            const auto [first, coordinates] = frame_.sliceRange(k);
            for (std::size_t i = 0; i < FRESH_CANDIDATES; ++i)
            {
                for (Eigen::Index j = first; j < first + coordinates; ++j)
                {
                    coordinates_[j] = frame_.lower()[j] + (frame_.upper()[j] - frame_.lower()[j]) * random_.uniform();
                }
                frame_.toState(k, coordinates_, point_[0], scratch_);
                graph_.addCandidate(k, point_[0]);
            }
        }
        return true;
    }

    bool Swarm::recombine(const path::Waypoints &path, double bound, std::uint64_t work, path::Waypoints &found)
    {
        if (!addCandidates())
        {
            return false;
        }
        if (!path.empty())
        {
            graph_.addCandidates(path);
        }
        return graph_.search(bound, work, found);
    }

    void Swarm::countOperations()
    {
        const std::uint64_t units = (fireflies_->operations() - countedOperations_) / OPERATIONS_A_WORK_UNIT;
        countedOperations_ += units * OPERATIONS_A_WORK_UNIT;
        evaluator_.addWork(units);
    }

    bool Swarm::step(const FireflyOptimizer::StopCondition &stop)
    {
        if (fireflies_->generation() >= fireflies_->settings().generations)
        {
            beginEpoch();
        }
        const bool completed = fireflies_->step(objective_,
                                                [this, &stop]
                                                {
                                                    countOperations();
                                                    return stop();
                                                });
        countOperations();
        return completed;
    }
}  // namespace ompl_mfa::engine::fireflies
