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

#include "benchmark/RestartSimplify.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathSimplifier.h>

#include "benchmark/NoWarnings.h"
#include "text/NumberText.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::benchmark
{
    RestartSimplify::RestartSimplify(const ob::SpaceInformationPtr &si)
      : Planner(si, "RestartSimplify")
      , trees_(std::make_shared<og::RRTConnect>(si))
      , bestCost_(std::numeric_limits<double>::infinity())
    {
        specs_ = trees_->getSpecs();
        specs_.approximateSolutions = true;
        specs_.optimizingPaths = true;
        specs_.canReportIntermediateSolutions = true;
        declareParam<double>("range", this, &RestartSimplify::setRange, &RestartSimplify::getRange, "0.:1.:10000.");
        addPlannerProgressProperty("best cost REAL", [this] { return text::numberText(bestCost()); });
        addPlannerProgressProperty("iterations INTEGER", [this] { return std::to_string(pathsFound()); });
    }

    void RestartSimplify::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
    {
        if (pdef != pdef_)
        {
            forget();
        }
        Planner::setProblemDefinition(pdef);
    }

    void RestartSimplify::setup()
    {
        Planner::setup();
        trees_->setup();
    }

    void RestartSimplify::clear()
    {
        Planner::clear();
        forget();
    }

    void RestartSimplify::forget()
    {
        trees_->clear();
        treesProblem_.reset();
        treesJoined_ = false;
        best_.reset();
        published_.reset();
        bestCost_ = std::numeric_limits<double>::infinity();
        pathsFound_ = 0;
    }

    void RestartSimplify::setRange(double range)
    {
        trees_->setRange(range);
    }

    double RestartSimplify::getRange() const
    {
        return trees_->getRange();
    }

    double RestartSimplify::bestCost() const
    {
        return bestCost_;
    }

    std::uint64_t RestartSimplify::pathsFound() const
    {
        return pathsFound_;
    }

    ob::PlannerStatus RestartSimplify::solve(const ob::PlannerTerminationCondition &ptc)
    {
        checkValidity();
        objective_ = pdef_->getOptimizationObjective();
        if (!objective_)
        {
            objective_ = std::make_shared<ob::PathLengthOptimizationObjective>(si_);
        }
        ob::PlannerStatus status = ob::PlannerStatus::EXACT_SOLUTION;
        while (status == ob::PlannerStatus::EXACT_SOLUTION && !isSatisfied() && !(best_ && ptc))
        {
            status = findPath(ptc);
            if (status == ob::PlannerStatus::EXACT_SOLUTION && !isSatisfied())
            {
                simplify(ptc);
            }
        }
        if (best_)
        {
            if (!isPublished())
            {
                addSolution();
            }
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (status == ob::PlannerStatus::APPROXIMATE_SOLUTION)
        {
            addApproximateSolution();
        }
        return status;
    }

    ob::PlannerStatus RestartSimplify::findPath(const ob::PlannerTerminationCondition &ptc)
    {
        // thousands of starts have nothing to say that the first one has not said
        std::optional<NoWarnings> quiet;
        if (treesProblem_)
        {
            quiet.emplace();
        }
        if (!treesProblem_ || treesJoined_)
        {
            startTrees();
        }
        const ob::PlannerStatus status = trees_->solve(ptc);
        treesJoined_ = status == ob::PlannerStatus::EXACT_SOLUTION;
        if (!treesJoined_)
        {
            return status;
        }
        ++pathsFound_;
        const auto &path = *treesProblem_->getSolutionPath()->as<og::PathGeometric>();
        if (improves(path))
        {
            keep(path);
        }
        return status;
    }

    void RestartSimplify::startTrees()
    {
        treesProblem_ = pdef_->clone();
        trees_->clear();
        trees_->setProblemDefinition(treesProblem_);
    }

    void RestartSimplify::simplify(const ob::PlannerTerminationCondition &ptc)
    {
        og::PathGeometric path(*treesProblem_->getSolutionPath()->as<og::PathGeometric>());
        {
            const NoWarnings quiet;  // about invalid paths, which are dropped
            og::PathSimplifier(si_, pdef_->getGoal(), objective_).simplify(path, ptc, false);
        }
        // OMPL leaves paths invalid that it could not repair, or not in time
        if (improves(path) && path.check())
        {
            keep(path);
        }
    }

    bool RestartSimplify::improves(const og::PathGeometric &path) const
    {
        return !best_ || objective_->isCostBetterThan(path.cost(objective_), ob::Cost(bestCost_));
    }

    bool RestartSimplify::isSatisfied() const
    {
        return best_ && objective_->isSatisfied(ob::Cost(bestCost_));
    }

    void RestartSimplify::keep(const og::PathGeometric &path)
    {
        best_ = std::make_shared<og::PathGeometric>(path);
        bestCost_ = path.cost(objective_).value();
        addSolution();
        const auto callback = pdef_->getIntermediateSolutionCallback();
        if (callback)
        {
            callback(this, {best_->getStates().begin(), best_->getStates().end()}, ob::Cost(bestCost_));
        }
    }

    bool RestartSimplify::isPublished() const
    {
        const auto solutions = pdef_->getSolutions();
        return std::any_of(solutions.begin(), solutions.end(),
                           [this](const ob::PlannerSolution &solution) { return solution.path_ == published_; });
    }

    void RestartSimplify::addSolution()
    {
        // a copy, for whoever reads the solution may change it
        published_ = std::make_shared<og::PathGeometric>(*best_);
        ob::PlannerSolution solution(published_);
        solution.setPlannerName(getName());
        solution.setOptimized(objective_, ob::Cost(bestCost_), isSatisfied());
        pdef_->addSolutionPath(solution);
    }

    void RestartSimplify::addApproximateSolution() const
    {
        pdef_->addSolutionPath(treesProblem_->getSolutionPath(), true, treesProblem_->getSolutionDifference(),
                               getName());
    }

    void RestartSimplify::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        trees_->getPlannerData(data);
    }
}  // namespace ompl_mfa::benchmark
