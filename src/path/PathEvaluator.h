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

#ifndef OMPL_MFA_PATH_PATH_EVALUATOR_
#define OMPL_MFA_PATH_PATH_EVALUATOR_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"
#include "path/CostBounds.h"
#include "path/DubinsGuard.h"
#include "path/Motion.h"
#include "path/ParallelChecks.h"
#include "path/Waypoints.h"

namespace ompl_mfa::path
{
    /** \brief Cost and validity of waypoint paths, evaluated lazily: first the cost, by the OptimizationObjective,
        then one motion after the other by SpaceInformation::checkMotion, no more than needed.

        Work is counted in state checks, so that the parts of a search can be compared without a clock. A cost that
        is NaN throws an ompl::Exception. A motion that OMPL cannot compute (see DubinsGuard) is invalid and has
        infinite cost. Not thread-safe. With several worker threads it checks states and motions in parallel, and
        nothing else: results, work and evaluations of the stop condition are the same as with one thread. */
    class PathEvaluator
    {
    public:
        using StopCondition = std::function<bool()>;

        /** \brief \e threads >= 1 is the number of threads that check states and motions, including the calling one.
            With more than one, the validity checker and the motion validator must be thread-safe. */
        PathEvaluator(ompl::base::SpaceInformationPtr si, ompl::base::OptimizationObjectivePtr objective,
                      unsigned int threads = 1);
        ~PathEvaluator();
        PathEvaluator(const PathEvaluator &) = delete;
        PathEvaluator &operator=(const PathEvaluator &) = delete;

        const ompl::base::SpaceInformationPtr &spaceInformation() const
        {
            return si_;
        }

        const ompl::base::OptimizationObjectivePtr &objective() const
        {
            return objective_;
        }

        /** \brief The lower bounds, which are compared with every cost computed here. */
        const CostBounds &bounds() const
        {
            return bounds_;
        }

        /** \brief Sets the condition that is evaluated before every motion check and before the cost of every motion,
           or of every few dozen motions if that is a mere distance. Once it is true, motions count as invalid without
           being checked, costs are infinite without being computed, and interrupted() is true. */
        void setStopCondition(StopCondition stop);

        /** \brief Whether the stop condition affected a result since it was set. */
        bool interrupted() const
        {
            return interrupted_;
        }

        /** \brief Evaluates the stop condition, for long searches without motion checks. */
        bool stopped();

        /** \brief Computes the \e cost of one motion; false, with an infinite cost, if interrupted. */
        bool motionCost(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost &cost);

        /** \brief The cost of \e path (at least one state), as defined by ompl::geometric::PathGeometric::cost.
            Infinite if interrupted. */
        ompl::base::Cost cost(const Waypoints &path);

        /** \brief The cost of \e path, given those of its motions. */
        ompl::base::Cost cost(const Waypoints &path, const std::vector<ompl::base::Cost> &motionCosts);

        /** \brief Compares the combined cost of consecutive motions from \e from to \e to with bounds(). */
        void observePath(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost cost)
        {
            bounds_.observePath(from, to, cost);
        }

        /** \brief Whether \e state is within the bounds and valid. */
        bool checkState(const ompl::base::State *state);

        /** \brief From now on motions are checked at one state in \e stride (at least 1) of OMPL's resolution, by the
            state validity checker and without the additional checks of checkStrictly. With a stride above 1 this is a
            draft: a valid motion passes it, and so do some invalid ones. */
        void setStride(unsigned int stride)
        {
            stride_ = stride;
        }

        unsigned int stride() const
        {
            return stride_;
        }

        /** \brief See hasDiscreteMotionChecks(). */
        bool isDiscrete() const;

        /** \brief From now on a motion that is valid is also checked at \e fineness (at least 1) times OMPL's
            resolution, by the state validity checker: at the states that OMPL's checkMotion would check with that
            factor as validSegmentCountFactor, those near its ends first, or those only with \e endsOnly: where a path
            turns around an obstacle, within a step of OMPL's resolution. Only for motions that are checked in full (a
            stride of 1), and without effect unless isDiscrete(). */
        void setFineness(unsigned int fineness, bool endsOnly = false);

        unsigned int fineness() const
        {
            return fineness_;
        }

        bool finenessEndsOnly() const
        {
            return endsOnly_;
        }

        /** \brief The additional checks of a motion that is known to be valid at OMPL's resolution. */
        bool checkFinely(const ompl::base::State *from, const ompl::base::State *to);

        /** \brief Of the last motion that failed at the finer resolution only: the number of the invalid state, with
            checkedSegments() for the end of the motion; 0 if the last motion checked did not fail so. */
        unsigned int failedState() const
        {
            return failed_;
        }

        /** \brief Number of segments between the states at which checkMotion checks the motion; at least 1. */
        unsigned int checkedSegments(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief The work of checking all motions of \e path, if they are valid. */
        std::uint64_t checkWork(const Waypoints &path) const;

        /** \brief Whether the motion is valid; \e from is assumed to be valid. */
        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to);

        /** \brief Checks a motion at some of its states, in bisection order, at least \e stride steps of the resolution
            apart. Detects most invalid motions for a fraction of the work of checkMotion. Both ends are assumed to be
            valid. */
        bool screenMotion(const ompl::base::State *from, const ompl::base::State *to, unsigned int stride);

        /** \brief Whether all \e motions are valid. The first state of each is assumed to be valid, or is the last
            state of an earlier one. No motion is checked after an invalid one, except by another thread that is
            free. */
        bool checkMotions(std::initializer_list<Motion> motions);

        /** \brief Whether all \e motions are valid at twice the resolution, too. A path that passes between obstacles
           only at one resolution may become invalid when interpolated differently, as by OMPL's path simplifier. */
        bool checkStrictly(std::initializer_list<Motion> motions);

        /** \brief The same for all motions of \e path. */
        bool checkStrictly(const Waypoints &path);

        /** \brief The additional checks of checkStrictly: the states halfway between those of checkMotions. */
        bool checkBetween(std::initializer_list<Motion> motions);

        /** \brief Whether all motions of \e path are valid; its first state is assumed to be. */
        bool checkPath(const Waypoints &path);

        /** \brief The brightness of \e path, whose first state is assumed to be valid: its cost and, as violation,
            the length of its invalid segments in the unit of the space's distance.

            With a \e rival, the result is infinitely dim as soon as the path is known not to be brighter; a path
            that is worse in cost is never checked for collision. */
        Brightness evaluate(const Waypoints &path, const Brightness *rival);

        /** \brief The same for a path whose \e cost is known. */
        Brightness evaluate(const Waypoints &path, ompl::base::Cost cost, const Brightness *rival);

        /** \brief Whether the objective prefers the cost \e a to \e b. */
        bool isBetter(double a, double b) const
        {
            return objective_->isCostBetterThan(ompl::base::Cost(a), ompl::base::Cost(b));
        }

        bool isBrighter(const Brightness &a, const Brightness &b) const;

        /** \brief \e factor (at least 1) times \e cost if that is finite and worse than \e cost, else \e cost: a factor
            gives no slack if the objective is maximised or costs are not positive. */
        double withSlack(double cost, double factor) const;

        /** \brief Called by evaluate for the first invalid motion of a path, with the path, the index of the motion and
            the last valid state on it. The motions before it are valid. Set it only while needed, as evaluate then
            checks the motions in order. */
        using PartialPathEvent =
            std::function<void(const Waypoints &path, std::size_t motion, const ompl::base::State *lastValid)>;
        void setPartialPathEvent(PartialPathEvent event);

        /** \brief The work of checking a motion, given the result \e valid, in state checks. */
        static std::uint64_t motionWork(const ompl::base::SpaceInformation &si, const Motion &motion, bool valid);

        /** \brief Work so far, in state checks: checked states, counted by the resolution of each motion, and other
            work that was added. Unlike time it is the same in every run. */
        std::uint64_t work() const
        {
            return checks_ + bookkeeping_;
        }

        /** \brief State checks in work(). */
        std::uint64_t checks() const
        {
            return checks_;
        }

        /** \brief Work in work() other than state checks: distances, queues, neighbours. */
        std::uint64_t bookkeeping() const
        {
            return bookkeeping_;
        }

        /** \brief Adds work other than state checks, in units of 0.1 microseconds. */
        void addWork(std::uint64_t work)
        {
            bookkeeping_ += work;
        }

        /** \brief Number of distances computed for motion costs and, as estimated by callers, in nearest-neighbour
            queries. Not included in work(). */
        std::uint64_t distances() const
        {
            return distances_;
        }

        /** \brief Adds distances computed elsewhere. */
        void addDistances(std::uint64_t count)
        {
            distances_ += count;
        }

        /** \brief Adds state checks made elsewhere. */
        void addChecks(std::uint64_t states)
        {
            checks_ += states;
        }

    private:
        ompl::base::Cost number(ompl::base::Cost cost, const char *what) const;
        bool checkNext(std::size_t i);
        std::size_t allowedFrom(std::size_t i) const;
        bool checkAll();
        bool checkBetween(const Motion &motion);
        bool checkInside(const Motion &motion, unsigned int count);
        bool checkDraft(const Motion &motion);
        void orderFineStates(unsigned int segments);
        bool checkFineStates(const Motion &motion);
        void reportPartialPath(const Waypoints &path, std::size_t motion);
        unsigned int countInvalid(const ompl::base::State *from, const ompl::base::State *to, unsigned int count);
        double invalidLength(const Motion &motion);

        ompl::base::SpaceInformationPtr si_;
        ompl::base::OptimizationObjectivePtr objective_;
        DubinsGuard guard_;
        CostBounds bounds_;
        std::vector<ompl::base::Cost> motionCosts_;
        StopCondition stop_;
        PartialPathEvent partialPath_;
        std::unique_ptr<ParallelChecks> parallel_;  ///< null with one thread
        std::vector<Motion> motions_;               ///< to be checked in this order
        std::vector<unsigned char> valid_;          ///< validity of motions_, as far as checked, possibly ahead
        std::size_t checked_{0};
        ompl::base::State *scratch_;
        std::uint64_t checks_{0};
        std::uint64_t bookkeeping_{0};
        std::uint64_t distances_{0};
        std::uint64_t costs_{0};  ///< motion costs computed since the stop condition was evaluated
        std::size_t lastInvalid_{0};
        std::vector<unsigned int> fine_;  ///< numbers of the states of a finer check, in their order
        unsigned int stride_{1};
        unsigned int fineness_{1};
        unsigned int failed_{0};
        bool endsOnly_{false};
        bool interrupted_{false};
    };

    /** \brief Sets an evaluator's stride during its lifetime. */
    class StrideScope
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        StrideScope(PathEvaluator &evaluator, unsigned int stride)
          : evaluator_(evaluator)
          , before_(evaluator.stride())
        {
            evaluator_.setStride(stride);
        }

        ~StrideScope()
        {
            evaluator_.setStride(before_);
        }

        StrideScope(const StrideScope &) = delete;
        StrideScope &operator=(const StrideScope &) = delete;

    private:
        PathEvaluator &evaluator_;
        unsigned int before_;
    };

    /** \brief Sets an evaluator's fineness during its lifetime. */
    class FinenessScope
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        FinenessScope(PathEvaluator &evaluator, unsigned int fineness, bool endsOnly)
          : evaluator_(evaluator)
          , before_(evaluator.fineness())
          , endsOnlyBefore_(evaluator.finenessEndsOnly())
        {
            evaluator_.setFineness(fineness, endsOnly);
        }

        ~FinenessScope()
        {
            evaluator_.setFineness(before_, endsOnlyBefore_);
        }

        FinenessScope(const FinenessScope &) = delete;
        FinenessScope &operator=(const FinenessScope &) = delete;

    private:
        PathEvaluator &evaluator_;
        unsigned int before_;
        bool endsOnlyBefore_;
    };
}  // namespace ompl_mfa::path

#endif
