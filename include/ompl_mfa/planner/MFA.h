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

#ifndef OMPL_MFA_PLANNER_MFA_
#define OMPL_MFA_PLANNER_MFA_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa
{
    /** \brief The Modified Firefly Algorithm as an anytime planner.

        A path is one point on each of a fixed number of slices across the axis from start to goal. A swarm of
        fireflies, each a path, moves through the space of these coordinates: every firefly flies to the brighter
        ones, where collision-free paths are brighter than colliding ones, and then those of better cost. The random
        step and the attraction shrink over an epoch of generations.

        The other parts of the search take turns with the fireflies, according to each one's gain for its work:
        recombination splices the paths of a swarm into better ones, guides (restarting trees and a growing roadmap)
        find the homotopy classes that slices across a straight axis cannot express, and tightening refines what the
        others find. Once there is a path, the swarm consists of whole, tight, different paths.
        With guide = none, recombination = 0 and tightening = 0 the planner is the algorithm of the paper. */
    class OMPL_MFA_EXPORT MFA : public ompl::base::Planner
    {
    public:
        /** \brief Throws ompl::Exception if \e si is null. */
        explicit MFA(const ompl::base::SpaceInformationPtr &si);
        ~MFA() override;

        /** \brief Throws ompl::Exception if the state space is not supported, naming the subspace, or if its extent is
            not finite. Does not need a problem definition. */
        void setup() override;
        /** \brief Forgets everything but the parameters, hints that were not used yet included. */
        void clear() override;

        /** \brief For another start or goal in the same world: forgets starts, goals and solutions. The next solve()
            begins another search with the present parameters. It keeps the roadmap, with what is known of its validity,
            and joins the former best path, from the point nearest to the new start to the point nearest to the new
            goal, to these. Also call validityChanged() or clear() if the world has changed. */
        void clearQuery() override;

        /** \brief Adds a path that may help, valid or not, and of any origin, such as an earlier plan, another planner
           or a path that was drawn. The next solve() joins it to a start and a goal, from the points of it nearest to
            these, replaces what collides by small trees, tightens it, and adds it to the swarm's population. No state
           or motion of it is taken to be valid without a check, and a path that cannot be made valid has no effect. In
           the paper's algorithm it becomes a firefly of the first generation of a swarm if it crosses all of its
            slices; added later, or otherwise, it is ignored.

            The states are copied. The path may be of another space information, whose space must have the same
            structure (types and dimensions). Hints are kept until the next solve(); clear() forgets them. Not to be
            called during solve(). Throws ompl::Exception if there is no state, a coordinate is not finite, or the
            structure of the space is different; then nothing is added. */
        void addPathHint(const ompl::geometric::PathGeometric &path);

        /** \brief The same. Also throws ompl::Exception if \e path is null or not a PathGeometric. */
        void addPathHint(const ompl::base::PathPtr &path);

        /** \brief To be called after the results of the validity checker or the motion validator have changed, not
           during solve(). From now on no path has a cost: bestCost() is infinite, and planner data is empty. The next
           solve() checks the best path first, repairs it where it collides, and resumes from there; what is left of the
            roadmap and of the population is checked again when it is needed. It reads starts and goals again, also
           those that were invalid, and uses the present parameters. Costs are computed again for objectives other than
            length.

            Solutions that were added to the problem definition stay there: call its clearSolutionPaths() before
            solve(). */
        void validityChanged();

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
        using ompl::base::Planner::solve;

        /** \brief Appends the roadmap, the trees, the valid fireflies and the best path. Afterwards \e data owns copies
            of all its states. May be called from other threads while solve() runs; it then waits for the check in
            progress. */
        void getPlannerData(ompl::base::PlannerData &data) const override;

        /** \name Parameters. docs/planner.md and params() describe their meanings and accepted values. A setter throws
           ompl::Exception with the parameter, the value and the accepted values if the value is not accepted; a getter
           returns the value set last. Changes take effect with the first solve() after clear(), or with the next query.
            @{ */
        void setVariant(const std::string &variant);
        std::string getVariant() const;
        void setFireflies(bool fireflies);
        bool getFireflies() const;
        void setFireflyMoves(const std::string &moves);
        std::string getFireflyMoves() const;
        void setPopulationSize(unsigned int size);
        unsigned int getPopulationSize() const;
        void setSlices(unsigned int slices);
        unsigned int getSlices() const;
        void setGenerations(unsigned int generations);
        unsigned int getGenerations() const;
        void setGamma(double gamma);
        double getGamma() const;
        void setAlpha(double alpha);
        double getAlpha() const;
        void setEta(double eta);
        double getEta() const;
        void setGuide(const std::string &guide);
        std::string getGuide() const;
        void setRecombination(bool recombination);
        bool getRecombination() const;
        void setTightening(bool tightening);
        bool getTightening() const;
        void setSeed(std::uint32_t seed);
        std::uint32_t getSeed() const;
        void setStateCheckTime(double microseconds);
        double getStateCheckTime() const;
        void setThreads(unsigned int threads);
        unsigned int getThreads() const;
        void setStrictness(unsigned int strictness);
        unsigned int getStrictness() const;
        /** @} */

        /** \brief Adds another planner as a guide, which takes turns with the other parts and with the guides that the
            parameter \e guide names: MFA solves what it solves, and its paths are tightened, too. A null allocator (the
            default) removes it. Takes effect as the parameters do. */
        void setGuidePlanner(const ompl::base::PlannerAllocator &allocator);

        /** \brief The fireflies' paths as they are now, brightest first; empty before solve() and while a new swarm is
            being initialised. */
        std::vector<ompl::geometric::PathGeometric> getSwarmPaths() const;

        /** \brief The slices of the swarm's frame, as pairs of states: for each lateral coordinate of a slice the two
            ends of its range. */
        std::vector<ompl::geometric::PathGeometric> getSlicePaths() const;

        /** \brief Cost of the path that solve() would return now: the best one that holds at \e strictness times the
            resolution. Infinity before the first. Safe to call while solve() runs. */
        double bestCost() const;

        /** \brief Firefly generations so far. Safe to call while solve() runs. */
        std::uint64_t iterations() const;

        /** \brief The fraction of the search time used by each part, in [0, 1], by its name: fireflies, recombination,
            tightening, trees, roadmap, guide planner and goal search. Safe to call while solve() runs. */
        std::map<std::string, double> shares() const;

        /** \brief Path evaluations so far. Safe to call while solve() runs. */
        std::uint64_t evaluations() const;

    private:
        void declareProgress();
        void declareParameters();
        void prepareQuery(const ompl::base::PlannerTerminationCondition &ptc);
        void beginSearch();
        void endSearch();
        void forgetSearch();
        std::uint64_t seedOfSearch();

        class Implementation;
        std::unique_ptr<Implementation> implementation_;
    };
}  // namespace ompl_mfa

#endif
