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

#include "benchmark/MeasuredPlanner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/util/String.h>

#include "benchmark/RunRecord.h"
#include "path/CountingValidityChecker.h"
#include "text/NumberText.h"

namespace ob = ompl::base;

namespace ompl_mfa::benchmark
{
    namespace
    {
        constexpr double DENSE_TIME = 0.1;
        constexpr double DENSE_INTERVAL = 0.001;
        const char *const BEST_COST = "best cost REAL";

        /* OMPL 1.5's BIT* iterates over its samples to compute these while the planning thread changes them: polling
           them crashed 20 of 60 runs. */
        bool isUnsafe(const std::string &name)
        {
            return name == "current free states INTEGER" || name == "current graph vertices INTEGER";
        }
    }  // namespace

    MeasuredPlanner::MeasuredPlanner(ob::PlannerPtr planner, RunState &run, const Settings &settings)
      : ob::Planner(planner->getSpaceInformation(), planner->getName())
      , planner_(std::move(planner))
      , run_(run)
      , settings_(settings)
    {
        specs_ = planner_->getSpecs();
        si_->setStateValidityChecker(
            std::make_shared<path::CountingValidityChecker>(si_, si_->getStateValidityChecker(), run_.collisionChecks));
    }

    std::vector<ProgressSample> MeasuredPlanner::progress() const
    {
        return samples_;
    }

    std::vector<std::string> MeasuredPlanner::progressNames() const
    {
        return names_;
    }

    double MeasuredPlanner::time() const
    {
        return time_;
    }

    bool MeasuredPlanner::threw() const
    {
        return threw_;
    }

    std::uint64_t MeasuredPlanner::collisionChecks() const
    {
        return collisionChecks_;
    }

    std::uint64_t MeasuredPlanner::motionChecks() const
    {
        return motionChecks_;
    }

    ob::PlannerStatus MeasuredPlanner::solve(const ob::PlannerTerminationCondition &ptc)
    {
        samples_.clear();
        solved_ = false;
        names_.clear();
        properties_.clear();
        for (const auto &property : planner_->getPlannerProgressProperties())
        {
            if (!isUnsafe(property.first))
            {
                names_.push_back(logPropertyName(property.first));
                properties_.push_back(property.second);
            }
        }
        publishesCost_ = std::find(names_.begin(), names_.end(), BEST_COST) != names_.end();

        run_.collisionChecks = 0;
        campaign::startSolving(run_);
        std::thread sampler([this] { sampleUntilSolved(); });
        const auto stopSampling = [this, &sampler]
        {
            time_ = monotonicSeconds() - run_.solveStart;
            {
                const std::lock_guard<std::mutex> lock(solvedMutex_);
                solved_ = true;
            }
            solvedCondition_.notify_all();
            sampler.join();
            run_.phase = RunPhase::Finishing;
        };
        ob::PlannerStatus status;
        try
        {
            status = solveLimited(ptc);
        }
        catch (...)
        {
            threw_ = true;
            stopSampling();
            throw;
        }
        stopSampling();
        finishProgress();
        if (settings_.solved)
        {
            settings_.solved();
        }
        return status;
    }

    ob::PlannerStatus MeasuredPlanner::solveLimited(const ob::PlannerTerminationCondition &ptc)
    {
        const double end = run_.solveStart + settings_.timeLimit;
        std::atomic<std::uint64_t> evaluations{0};
        const ob::PlannerTerminationCondition limited(
            [this, &ptc, &evaluations, end]
            {
                return (settings_.iterationLimit > 0 && evaluations.fetch_add(1) >= settings_.iterationLimit) ||
                       monotonicSeconds() >= end || ptc();
            });
        const ob::PlannerStatus status = planner_->solve(limited);
        collisionChecks_ = run_.collisionChecks;
        const auto &motions = si_->getMotionValidator();
        motionChecks_ = motions->getValidMotionCount() + motions->getInvalidMotionCount();
        return status;
    }

    void MeasuredPlanner::sampleUntilSolved()
    {
        const double start = run_.solveStart;
        const double watchInterval = std::min(DENSE_INTERVAL, settings_.progressInterval);
        std::size_t index = 0;
        std::unique_lock<std::mutex> lock(solvedMutex_);
        while (!solved_)
        {
            const double now = monotonicSeconds() - start;
            const double next = std::isfinite(run_.firstSolution) ? sampleTime(index)
                                                                  : std::min(sampleTime(index), now + watchInterval);
            if (solvedCondition_.wait_for(lock, std::chrono::duration<double>(next - now), [this] { return solved_; }))
            {
                return;
            }
            lock.unlock();
            const double time = monotonicSeconds() - start;
            sample(time, time >= sampleTime(index));
            // Under load, samples are skipped.
            while (sampleTime(index) <= monotonicSeconds() - start)
            {
                ++index;
            }
            lock.lock();
        }
    }

    void MeasuredPlanner::sample(double time, bool keep)
    {
        ProgressSample sample;
        sample.time = time;
        for (std::size_t i = 0; i < properties_.size(); ++i)
        {
            if (!keep && names_[i] != BEST_COST)
            {
                continue;
            }
            sample.values.push_back(properties_[i]());
            if (names_[i] == BEST_COST)
            {
                double cost = 0.0;
                if (text::readNumber(sample.values.back(), cost) && std::isfinite(cost))
                {
                    run_.bestCost = cost;
                    run_.firstSolution = std::min(run_.firstSolution.load(), sample.time);
                }
            }
        }
        if (keep && (samples_.empty() || sample.time > samples_.back().time))
        {
            samples_.push_back(std::move(sample));
        }
    }

    double MeasuredPlanner::sampleTime(std::size_t index) const
    {
        const double dense = std::min(DENSE_INTERVAL, settings_.progressInterval);
        const auto denseCount = static_cast<std::size_t>(std::lround(DENSE_TIME / dense));
        return index < denseCount
                   ? dense * static_cast<double>(index + 1)
                   : DENSE_TIME + settings_.progressInterval * static_cast<double>(index + 1 - denseCount);
    }

    void MeasuredPlanner::finishProgress()
    {
        sample(time_, true);
        const bool exact = pdef_->hasExactSolution();
        if (exact)
        {
            run_.firstSolution = std::min(run_.firstSolution.load(), time_);
        }
        if (!publishesCost_)
        {
            names_.emplace_back(BEST_COST);
            for (ProgressSample &sample : samples_)
            {
                sample.values.emplace_back("inf");
            }
            if (exact)
            {
                const auto &objective = pdef_->getOptimizationObjective();
                const auto &path = pdef_->getSolutionPath();
                run_.bestCost = objective ? path->cost(objective).value() : path->length();
                samples_.back().values.back() = ompl::toString(run_.bestCost.load());
            }
        }
        for (std::size_t index = 0; sampleTime(index) <= settings_.timeLimit; ++index)
        {
            if (sampleTime(index) > samples_.back().time)
            {
                ProgressSample continued = samples_.back();
                continued.time = sampleTime(index);
                samples_.push_back(std::move(continued));
            }
        }
    }

    void MeasuredPlanner::setup()
    {
        ob::Planner::setup();
        planner_->setProblemDefinition(pdef_);
        if (!planner_->isSetup())
        {
            planner_->setup();
        }
        params_.include(planner_->params());
    }

    void MeasuredPlanner::getPlannerData(ob::PlannerData &graph) const
    {
        planner_->getPlannerData(graph);
    }
}  // namespace ompl_mfa::benchmark
