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

#include "ompl_mfa/planner/MFA.h"

#include <cmath>

#include <ompl/base/PlannerData.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "engine/fireflies/Swarms.h"
#include "planner/HintPath.h"
#include "planner/MFAImplementation.h"
#include "planner/MFAParameters.h"
#include "planner/PlannerDataExport.h"
#include "planner/RangedParam.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa
{
    namespace
    {
        void requireFiniteExtent(const ob::Planner &planner)
        {
            const auto &space = planner.getSpaceInformation()->getStateSpace();
            if (std::isfinite(space->getMaximumExtent()))
            {
                return;
            }
            throw ompl::Exception(planner.getName(), "cannot plan in the state space '" + space->getName() +
                                                         "': its bounds are infinite, or too large for a finite "
                                                         "distance");
        }
    }  // namespace

    MFA::MFA(const ob::SpaceInformationPtr &si)
      : ob::Planner(si, "MFA")
      , implementation_(std::make_unique<Implementation>())
    {
        specs_.recognizedGoal = ob::GOAL_REGION;
        specs_.approximateSolutions = true;
        specs_.optimizingPaths = true;
        specs_.directed = true;
        specs_.canReportIntermediateSolutions = true;
        declareProgress();
        declareParameters();
    }

    MFA::~MFA() = default;

    void MFA::declareProgress()
    {
        addPlannerProgressProperty("best cost REAL", [this] { return ompl::toString(bestCost()); });
        addPlannerProgressProperty("iterations INTEGER", [this] { return std::to_string(iterations()); });
        addPlannerProgressProperty("evaluations INTEGER", [this] { return std::to_string(evaluations()); });
        for (std::size_t i = 0; i < engine::PART_NAMES.size(); ++i)
        {
            addPlannerProgressProperty(
                "share of " + std::string(engine::PART_NAMES[i]) + " REAL",
                [this, i] { return ompl::toString(implementation_->progress.share(engine::PartKind(i))); });
        }
    }

    void MFA::declareParameters()
    {
        const auto declare = [this](const auto &parameter)
        {
            engine::SearchSettings &settings = implementation_->settings;
            const auto member = parameter.member;
            using T = std::decay_t<decltype(settings.*member)>;
            params_.add(std::make_shared<planner::RangedParam<T>>(
                parameter.name, parameter.accepted, [&settings, member](const T &value) { settings.*member = value; },
                [&settings, member] { return settings.*member; }));
        };
        for (const auto &parameter : planner::mfaParameters())
        {
            std::visit(declare, parameter);
        }
    }

    void MFA::setup()
    {
        Planner::setup();
        setup_ = false;  // if the space is refused, each further call has to refuse it
        implementation_->chart = std::make_shared<path::StateChart>(si_->getStateSpace());
        requireFiniteExtent(*this);
        setup_ = true;
    }

    void MFA::clear()
    {
        Planner::clear();
        const planner::SearchLock::Search lock(implementation_->lock);
        forgetSearch();
        implementation_->hints.clear();
    }

    void MFA::forgetSearch()
    {
        implementation_->engine.reset();
        implementation_->predecessor.reset();
        implementation_->sameValidity = true;
        implementation_->publisher = planner::SolutionPublisher();
        implementation_->progress.reset();
    }

    void MFA::clearQuery()
    {
        const planner::SearchLock::Search lock(implementation_->lock);
        endSearch();
    }

    /* The next search inherits from the present one. */
    void MFA::endSearch()
    {
        Implementation &search = *implementation_;
        if (search.engine)
        {
            search.predecessor = std::move(search.engine);
        }
        search.publisher = planner::SolutionPublisher();
        search.progress.reset();
        pis_.restart();
    }

    void MFA::validityChanged()
    {
        const planner::SearchLock::Search lock(implementation_->lock);
        endSearch();
        implementation_->sameValidity = false;
    }

    void MFA::addPathHint(const og::PathGeometric &path)
    {
        path::Waypoints hint = planner::hintOf(path, si_->getStateSpace(), getName());
        const planner::SearchLock::Search lock(implementation_->lock);
        implementation_->hints.push_back(std::move(hint));
    }

    void MFA::addPathHint(const ob::PathPtr &path)
    {
        const auto *geometric = dynamic_cast<const og::PathGeometric *>(path.get());
        if (geometric == nullptr)
        {
            throw ompl::Exception(getName(), "a path hint must be an ompl::geometric::PathGeometric");
        }
        addPathHint(*geometric);
    }

    ob::PlannerStatus MFA::solve(const ob::PlannerTerminationCondition &ptc)
    {
        checkValidity();
        Implementation &search = *implementation_;
        const planner::SearchLock::Search lock(search.lock);
        // whenever the condition is evaluated, the data that other threads may read is complete
        const ob::PlannerTerminationCondition watched(
            [&]
            {
                search.lock.letReadersIn();
                return ptc();
            });
        prepareQuery(watched);
        const engine::SearchContext &context = search.engine->context();
        search.publisher.begin(pdef_);
        const auto status =
            search.engine->search(pis_, watched, [&] { search.publisher.publishIfDue(context, *this, search.lock); });
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
        {
            return status;
        }
        return search.publisher.finish(context, *this, search.lock);
    }

    void MFA::prepareQuery(const ob::PlannerTerminationCondition &ptc)
    {
        Implementation &search = *implementation_;
        if (!search.engine || !search.engine->canContinue(*pdef_, ptc))
        {
            beginSearch();
        }
        for (path::Waypoints &hint : search.hints)
        {
            search.engine->addHint(std::move(hint));
        }
        search.hints.clear();
    }

    void MFA::beginSearch()
    {
        Implementation &search = *implementation_;
        requireFiniteExtent(*this);
        if (search.engine)
        {
            Planner::clear();
            forgetSearch();
            pis_.restart();
        }
        search.engine = std::make_unique<engine::Engine>(*this, search.chart, search.settings, seedOfSearch(),
                                                         search.guidePlanner, search.progress);
        if (search.predecessor)
        {
            search.engine->inherit(*search.predecessor, search.sameValidity);
            search.predecessor.reset();
        }
        search.sameValidity = true;
    }

    /* A search that inherits a roadmap must not draw its states again. */
    std::uint64_t MFA::seedOfSearch()
    {
        Implementation &search = *implementation_;
        if (search.settings.seed == 0)
        {
            return static_cast<std::uint64_t>(search.rng.uniformInt(1, 1 << 30));
        }
        search.successors = search.predecessor ? search.successors + 1 : 0;
        return search.successors == 0
                   ? search.settings.seed
                   : engine::streamSeed(search.settings.seed, engine::Stream::Successor, search.successors);
    }

    void MFA::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        const planner::SearchLock::Reader lock(implementation_->lock);
        engine::SearchGraph graph(si_->getStateSpace());
        if (implementation_->engine)
        {
            implementation_->engine->explain(graph);
        }
        planner::exportTo(data, graph);
    }

    std::vector<og::PathGeometric> MFA::getSwarmPaths() const
    {
        const planner::SearchLock::Reader lock(implementation_->lock);
        std::vector<og::PathGeometric> paths;
        if (!implementation_->engine || implementation_->engine->swarms() == nullptr)
        {
            return paths;
        }
        for (const path::Waypoints &path : implementation_->engine->swarms()->currentPaths())
        {
            paths.emplace_back(si_);
            path.appendTo(paths.back());
        }
        return paths;
    }

    std::vector<og::PathGeometric> MFA::getSlicePaths() const
    {
        const planner::SearchLock::Reader lock(implementation_->lock);
        std::vector<og::PathGeometric> paths;
        const engine::fireflies::Swarms *swarms = implementation_->engine ? implementation_->engine->swarms() : nullptr;
        if (swarms == nullptr || swarms->current() == nullptr)
        {
            return paths;
        }
        for (const path::Waypoints &ends : swarms->current()->frame().sliceEnds())
        {
            paths.emplace_back(si_, ends[0], ends[1]);
        }
        return paths;
    }

    double MFA::bestCost() const
    {
        return implementation_->progress.bestCost;
    }

    std::uint64_t MFA::iterations() const
    {
        return implementation_->progress.iterations;
    }

    std::uint64_t MFA::evaluations() const
    {
        return implementation_->progress.evaluations;
    }

    std::map<std::string, double> MFA::shares() const
    {
        std::map<std::string, double> shares;
        for (std::size_t i = 0; i < engine::PART_NAMES.size(); ++i)
        {
            shares[engine::PART_NAMES[i]] = implementation_->progress.share(engine::PartKind(i));
        }
        return shares;
    }
}  // namespace ompl_mfa
