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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_TIGHTENING_PART_
#define OMPL_MFA_ENGINE_REFINEMENT_TIGHTENING_PART_

#include <cstddef>
#include <cstdint>
#include <memory>

#include "engine/SearchPart.h"
#include "engine/refinement/PathRepair.h"
#include "engine/refinement/PathTightening.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Tightens the best path in its own turns, and the paths that other parts propose at once.

        What only has to be compared is tightened as a draft, whose motions are checked at one state in a few. Only a
        draft that promises to be the best path is repaired, and tightened in full. */
    class TighteningPart : public SearchPart, public PathRefiner
    {
    public:
        explicit TighteningPart(const SearchContext &context);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        void advance(std::uint64_t work, Findings &findings) override;

        /** \brief Continues with the result of the last refine(), or begins with any other path. */
        void improved(const Proposal &proposal) override;

        Proposal refine(Proposal proposal, ompl::base::Cost rival) override;

    private:
        /* The draft of the best path. */
        struct BestDraft
        {
            double cost{0.0};  ///< cost of the best path when it was last compared with the draft
            bool begun{false};
            bool done{false};      ///< whether it promises no further gain
            double promise{0.0};   ///< relative gain that it must promise to be repaired
            double promised{0.0};  ///< relative gain that it promised when it was proposed; 0: not proposed since
        };

        double gain(double before, double after) const;
        bool advanceDraft(std::uint64_t work, Findings &findings);
        bool tightenDraft(Proposal &proposal, ompl::base::Cost rival);
        bool repair(Proposal &proposal);
        void tightenFully(Proposal &proposal, ompl::base::Cost rival);

        std::unique_ptr<PathTightening> best_;  ///< for the best path
        std::unique_ptr<PathTightening> new_;   ///< for a proposed path
        PathTightening draft_;                  ///< for drafts of proposed paths
        PathTightening bestDraft_;              ///< for a draft of the best path
        PathRepair repair_;
        BestDraft drafted_;
        std::size_t turn_{0};
        bool refined_{false};  ///< whether new_ made the last result
        bool stale_{false};    ///< whether best_ has to restart from the best path
    };
}  // namespace ompl_mfa::engine::refinement

#endif
