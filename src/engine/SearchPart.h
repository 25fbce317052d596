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

#ifndef OMPL_MFA_ENGINE_SEARCH_PART_
#define OMPL_MFA_ENGINE_SEARCH_PART_

#include <cstdint>
#include <optional>
#include <vector>

#include <ompl/base/Cost.h>

#include "engine/SearchContext.h"
#include "engine/SearchGraph.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief A path from a start to a goal that a part of the search hands to the engine. */
    struct Proposal
    {
        enum class Stage : unsigned char
        {
            Raw,      ///< far from the best of its homotopy class: to be tightened before it is compared
            Tight,    ///< already tightened
            Straight  ///< a single motion, which is not tightened
        };

        path::Waypoints path;
        std::optional<ompl::base::Cost> cost;  ///< cost of path; computed by the engine if not given
        Stage stage{Stage::Raw};
        std::optional<PartKind> origin;  ///< the part that found the path; none for a straight motion
        bool draft{false};  ///< whether it was only checked at a coarse resolution and may be invalid: needs repair
    };

    /** \brief The results of one turn of a part. */
    struct Findings
    {
        explicit Findings(const ompl::base::StateSpacePtr &space)
          : goals(space)
        {
        }

        std::vector<Proposal> paths;
        std::vector<Proposal> drafts;  ///< of known cost, for the pool only
        path::Waypoints goals;         ///< new states that satisfy the goal
    };

    /** \brief A part's claim to computing time, relative to the other parts'. */
    struct Share
    {
        double weight;      ///< initial weight; it grows with the gain for the work
        double floor;       ///< lower bound of the weight
        double delay{0.0};  ///< time in s that the parts without a delay work before this one's first turn
    };

    enum class Readiness : unsigned char
    {
        Idle,     ///< has nothing to do
        Waiting,  ///< lets other parts go first, but keeps its claim to the time that passes
        Ready
    };

    /** \brief What an earlier search knew that holds in the next one, too. */
    struct Heritage
    {
        bool states;    ///< whether the space and its bounds are the same
        bool validity;  ///< whether the validity of states and motions is the same
        bool costs;     ///< whether the costs of motions are the same
    };

    /** \brief One search method, which takes turns with others. It reads the shared SearchContext and knows none of the
        others. */
    class SearchPart
    {
    public:
        /** \brief \e context must outlive the part. */
        SearchPart(PartKind kind, const SearchContext &context);
        virtual ~SearchPart() = default;
        SearchPart(const SearchPart &) = delete;
        SearchPart &operator=(const SearchPart &) = delete;

        PartKind kind() const
        {
            return kind_;
        }

        /** \brief The share before there is a path of finite cost. */
        virtual Share firstShare() const = 0;

        /** \brief The share after that; \e seconds is how long the search for the first path took. */
        virtual Share improvementShare(double seconds) const = 0;

        virtual Readiness readiness() const = 0;

        /** \brief Searches with a budget of about \e work units of PathEvaluator::work(), or until there is a result.
            The next call resumes the search. */
        virtual void advance(std::uint64_t work, Findings &findings) = 0;

        /** \brief Called when \e proposal became the best path. */
        virtual void improved(const Proposal &proposal);

        /** \brief Takes from \e predecessor, the same part of an earlier search, what is of use in this one according
           to \e heritage. To be called before the first turn; the predecessor is not used again. By default nothing. */
        virtual void inherit(SearchPart &predecessor, const Heritage &heritage);

        /** \brief Appends to \e graph the part's states, except those known to be invalid, and its valid motions. By
            default nothing. */
        virtual void explain(SearchGraph &graph) const;

    protected:
        const SearchContext &context() const
        {
            return context_;
        }

        /** \brief Appends a raw path found by this part. */
        void propose(path::Waypoints path, Findings &findings) const;

    private:
        PartKind kind_;
        const SearchContext &context_;
    };

    /** \brief Tightens paths that other parts found, immediately and for as long as this is promising. */
    class PathRefiner
    {
    public:
        virtual ~PathRefiner() = default;

        /** \brief Tightens the path of \e proposal, whose cost is known, until it is better than \e rival, or until the
            recent gains no longer promise that it will be; if it is the best path already, for as long as it pays. A
            draft that promises to be better is repaired. The result is tight; it is a draft if it promised too little
            to be repaired, or could not be. */
        virtual Proposal refine(Proposal proposal, ompl::base::Cost rival) = 0;
    };

    /** \brief Makes invalid paths valid. */
    class PathMender
    {
    public:
        virtual ~PathMender() = default;

        /** \brief Makes \e path (at least two states), whose first and last state are valid, valid at the evaluator's
            present stride: replaces what collides. The higher \e effort (from 0), the longer it searches, and the
            longer may be what replaces a colliding section. False, with \e path unchanged, if that failed or was
            interrupted. */
        virtual bool mend(path::Waypoints &path, unsigned int effort) = 0;
    };

    /** \brief Factor for a roadmap's share of the time by the dimension of the space, 1 in three dimensions: n states
        leave gaps of n^(-1/d), so a roadmap is less efficient in more dimensions. */
    double roadmapFactor(const path::StateChart &chart);
}  // namespace ompl_mfa::engine

#endif
