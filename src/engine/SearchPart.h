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
    /** \brief A valid path from a start to a goal that a part of the search hands to the engine. */
    struct Proposal
    {
        enum class Stage : unsigned char
        {
            Raw,      ///< to be tightened before it is judged: far from the best of its homotopy class
            Tight,    ///< as tightening left it
            Straight  ///< one motion, which nothing tightens
        };

        path::Waypoints path;
        std::optional<ompl::base::Cost> cost;  ///< of path; computed by the engine where it is not given
        Stage stage{Stage::Raw};
        std::optional<PartKind> origin;  ///< the part that found the path; none for a straight motion
    };

    /** \brief \e path with \e segment in place of its vertices from \e first to \e last. */
    path::Waypoints replaceSegment(const path::Waypoints &path, std::size_t first, std::size_t last,
                                   const path::Waypoints &segment);

    /** \brief A valid segment that may replace one of a path: tightened, it is compared with that alone. */
    struct Detour
    {
        path::Waypoints segment;
        ompl::base::Cost cost;   ///< of segment
        ompl::base::Cost rival;  ///< cost of the segment to be replaced
        path::Waypoints path;
        std::size_t first;  ///< vertex of path where the segment begins
        std::size_t last;   ///< vertex of path where it ends
        PartKind origin;
    };

    /** \brief What a turn of a part brought. */
    struct Findings
    {
        explicit Findings(const ompl::base::StateSpacePtr &space)
          : goals(space)
        {
        }

        std::vector<Proposal> paths;
        std::vector<Detour> detours;
        path::Waypoints goals;  ///< states that satisfy the goal
    };

    /** \brief How much of the time a part gets, relative to the others. */
    struct Share
    {
        double weight;      ///< at first; it grows with what the part gains for its work
        double floor;       ///< of the weight, however little the part gains
        double delay{0.0};  ///< seconds that the parts without a delay work before its first turn
    };

    enum class Readiness : unsigned char
    {
        Idle,     ///< a turn would lead to nothing
        Waiting,  ///< others should go first, but it keeps its claim to the time that passes
        Ready
    };

    /** \brief One way of searching, which takes turns with others. It knows what they have in common, but none of
        them. */
    class SearchPart
    {
    public:
        /** \brief \e context outlives the part. */
        SearchPart(PartKind kind, const SearchContext &context);
        virtual ~SearchPart() = default;
        SearchPart(const SearchPart &) = delete;
        SearchPart &operator=(const SearchPart &) = delete;

        PartKind kind() const
        {
            return kind_;
        }

        /** \brief Its share before there is a path of finite cost. */
        virtual Share firstShare() const = 0;

        /** \brief Its share from then on; the first path took \e seconds of work. */
        virtual Share improvementShare(double seconds) const = 0;

        virtual Readiness readiness() const = 0;

        /** \brief Searches for about \e work units of PathEvaluator::work(), or until it has something to hand over.
            The next call goes on from there. */
        virtual void advance(std::uint64_t work, Findings &findings) = 0;

        /** \brief Called when \e proposal became the best path. */
        virtual void improved(const Proposal &proposal);

        /** \brief Appends to \e graph the states that the part has, none of which is known to be invalid, with the
            motions between them that it found valid; nothing where it cannot answer for either. */
        virtual void explain(SearchGraph &graph) const;

    protected:
        const SearchContext &context() const
        {
            return context_;
        }

        /** \brief Appends a raw path of this part's. */
        void propose(path::Waypoints path, Findings &findings) const;

    private:
        PartKind kind_;
        const SearchContext &context_;
    };

    /** \brief Makes paths better that other parts found, at once and as far as it pays. */
    class PathRefiner
    {
    public:
        virtual ~PathRefiner() = default;

        /** \brief Tightens \e path of cost \e cost until it is better than \e rival, or for as long as what the last
            rounds gained promises that it will be. The result is valid until the next call. */
        virtual const path::Waypoints &refine(const path::Waypoints &path, ompl::base::Cost &cost,
                                              ompl::base::Cost rival) = 0;
    };

    /** \brief How much of the time suits a roadmap in a space of this dimension, relative to three dimensions: one of
        n states leaves gaps of n^(-1/d), so that it finds the less the more dimensions there are. */
    double roadmapFactor(const path::StateChart &chart);
}  // namespace ompl_mfa::engine

#endif
