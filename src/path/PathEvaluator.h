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
    /** \brief Cost and validity of waypoint paths, as lazily as they can be had: cost first, through the
        OptimizationObjective; then one motion after the other through SpaceInformation::checkMotion, and no more of
        them than the answer needs.

        It counts its work in state checks, so that the work of the parts of a planner can be compared without a
        clock. A cost that is not a number is an ompl::Exception, whoever computed it. A motion that OMPL cannot compute
        (see DubinsGuard) is invalid and of infinite cost. Not thread-safe; each thread has its own. With several
        threads of its own it checks states and motions in parallel, and nothing else: its answers, its work and when it
        asks the stop condition are those of one. */
    class PathEvaluator
    {
    public:
        using StopCondition = std::function<bool()>;

        /** \brief \e threads >= 1 is how many threads check states and motions, the calling one included. With more
            than one, the validity checker and the motion validator are called from them at once. */
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

        /** \brief What is known of lower bounds; learns from every cost that is computed here. */
        const CostBounds &bounds() const
        {
            return bounds_;
        }

        /** \brief Asked before every motion check, and before the cost of every motion, or of a few dozen where that is
           a mere distance: an integral along a motion takes as long as its check. Once it is true, motions count as
           invalid without being checked, costs are infinite without being computed, and interrupted() tells so. */
        void setStopCondition(StopCondition stop);

        /** \brief Whether the stop condition cut an answer short since it was set. */
        bool interrupted() const
        {
            return interrupted_;
        }

        /** \brief Asks the stop condition, for searches that may go on long without checking a motion. */
        bool stopped();

        /** \brief Computes the \e cost of one motion; false, with infinite cost, if interrupted. */
        bool motionCost(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost &cost);

        /** \brief The cost of \e path (at least one state), as ompl::geometric::PathGeometric::cost has it. Infinite if
            interrupted. */
        ompl::base::Cost cost(const Waypoints &path);

        /** \brief The cost of \e path whose motions cost \e motionCosts. */
        ompl::base::Cost cost(const Waypoints &path, const std::vector<ompl::base::Cost> &motionCosts);

        /** \brief Learns for bounds() from the combined cost of motions that lead \e from -> \e to. */
        void observePath(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost cost)
        {
            bounds_.observePath(from, to, cost);
        }

        /** \brief Whether \e state is within the bounds and valid. */
        bool checkState(const ompl::base::State *state);

        /** \brief Whether the motion is valid; \e from is taken to be a valid state. */
        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to);

        /** \brief Whether the states that halve the motion, and its halves, and so on, as long as they are at least
            \e stride steps of the resolution apart, are valid: for a part of the work of checkMotion it finds out most
            of the motions that are invalid. Both ends are taken to be valid. */
        bool screenMotion(const ompl::base::State *from, const ompl::base::State *to, unsigned int stride);

        /** \brief Whether all \e motions are valid; the first state of each is taken to be, or to be the last of one
            before it. None is checked after an invalid one, unless another thread has time for it. */
        bool checkMotions(std::initializer_list<Motion> motions);

        /** \brief Whether all \e motions are valid, and remain so at twice the resolution: a path that slips between
           the states of one resolution is worth little to what interpolates it otherwise, such as OMPL's path
           simplifier. */
        bool checkStrictly(std::initializer_list<Motion> motions);

        /** \brief What checkStrictly checks beyond checkMotions: the states halfway between those that it looks at. */
        bool checkBetween(std::initializer_list<Motion> motions);

        /** \brief Whether all motions of \e path are valid; its first state is taken to be. */
        bool checkPath(const Waypoints &path);

        /** \brief The brightness of \e path, whose first state is taken to be valid: its cost, and as violation the
            length of its invalid part in the unit of the space's distance.

            With a \e rival, an infinitely dim answer is given as soon as the path is known not to be brighter; a path
            that cannot win on cost is never checked for collision.

            With a \e stride above 1, one state in so many is asked first; where one of these is invalid they alone make
            up the violation. Only a path of which every state is valid is ever feasible. */
        Brightness evaluate(const Waypoints &path, const Brightness *rival, unsigned int stride = 1);

        /** \brief The same for a path whose \e cost is known. */
        Brightness evaluate(const Waypoints &path, ompl::base::Cost cost, const Brightness *rival,
                            unsigned int stride = 1);

        bool isBrighter(const Brightness &a, const Brightness &b) const;

        /** \brief \e factor (at least 1) times \e cost where that is a worse cost and finite, else \e cost: for
            objectives to be maximised and for costs that are not positive no factor is a slack. */
        double withSlack(double cost, double factor) const;

        /** \brief Called by evaluate for the first invalid motion of a path, with the path, the number of that motion
            and the last valid state on it. The motions before it are valid. Set it only while it is needed: it makes
            evaluate check the motions in order. */
        using PartialPathEvent =
            std::function<void(const Waypoints &path, std::size_t motion, const ompl::base::State *lastValid)>;
        void setPartialPathEvent(PartialPathEvent event);

        /** \brief The work of checking a motion that turned out \e valid or not, in state checks. */
        static std::uint64_t motionWork(const ompl::base::SpaceInformation &si, const Motion &motion, bool valid);

        /** \brief Work done so far, in state checks: states whose validity was asked for, counted by the resolution of
            each motion, and what else was added. Unlike time it is the same in every run. */
        std::uint64_t work() const
        {
            return checks_ + bookkeeping_;
        }

        /** \brief The part of work() that was states whose validity was asked for. */
        std::uint64_t checks() const
        {
            return checks_;
        }

        /** \brief The part of work() that was none: distances, queues, neighbours. */
        std::uint64_t bookkeeping() const
        {
            return bookkeeping_;
        }

        /** \brief Counts work that is not a state check, as so many of those that take 0.1 microseconds. */
        void addWork(std::uint64_t work)
        {
            bookkeeping_ += work;
        }

        /** \brief Distances that were computed for costs of motions and, as others estimated them, for neighbours. They
            are no part of work(). */
        std::uint64_t distances() const
        {
            return distances_;
        }

        /** \brief Counts distances that were computed elsewhere. */
        void addDistances(std::uint64_t count)
        {
            distances_ += count;
        }

        /** \brief Counts state checks that were made by others. */
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
        void reportPartialPath(const Waypoints &path, std::size_t motion);
        bool addInvalidLengths(const Waypoints &path, std::size_t first, unsigned int stride, const Brightness *rival,
                               Brightness &result);
        unsigned int countInvalid(const ompl::base::State *from, const ompl::base::State *to, unsigned int count);
        double invalidLength(const Motion &motion, unsigned int stride, unsigned int least);

        ompl::base::SpaceInformationPtr si_;
        ompl::base::OptimizationObjectivePtr objective_;
        DubinsGuard guard_;
        CostBounds bounds_;
        std::vector<ompl::base::Cost> motionCosts_;
        StopCondition stop_;
        PartialPathEvent partialPath_;
        std::unique_ptr<ParallelChecks> parallel_;  ///< null with one thread
        std::vector<Motion> motions_;               ///< that are to be checked one after the other
        std::vector<unsigned char> valid_;          ///< of motions_, as many as were checked, maybe ahead
        std::size_t checked_{0};
        ompl::base::State *scratch_;
        std::uint64_t checks_{0};
        std::uint64_t bookkeeping_{0};
        std::uint64_t distances_{0};
        std::uint64_t costs_{0};  ///< of motions, computed without a look at the stop condition
        std::size_t lastInvalid_{0};
        bool interrupted_{false};
    };
}  // namespace ompl_mfa::path

#endif
