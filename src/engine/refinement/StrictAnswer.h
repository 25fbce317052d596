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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_STRICT_ANSWER_
#define OMPL_MFA_ENGINE_REFINEMENT_STRICT_ANSWER_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/AnswerMaker.h"
#include "engine/SearchContext.h"
#include "engine/refinement/CheckedPath.h"
#include "engine/refinement/PathRepair.h"
#include "engine/refinement/PathTightening.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Makes the answer of a search from its incumbent: the path that is returned.

        The incumbent is valid at OMPL's resolution and touches obstacles, so at a finer one it often is not. The answer
        is the incumbent checked at \e strictness times the resolution and led around what is found invalid there. That
        is too expensive for each improvement, so it is done as often as a small fraction of the work allows. Until the
        first such answer can be afforded, notably better paths become the answer once they are checked near their
        corners. The parts of the search do not know the answer.

        With a strictness of 1, in the paper's algorithm, and with a motion validator that does not check motions at
        discrete states, the answer is the incumbent. */
    class StrictAnswer : public AnswerMaker
    {
    public:
        /** \brief \e context must outlive the object. */
        explicit StrictAnswer(SearchContext &context);

        /** \brief Makes a new answer if there is a better incumbent and that is due. With \e demanded the full check is
            due now, for a few attempts an improvement. After a long search without an answer, the incumbent becomes the
            answer as it is. */
        void update(bool demanded) override;

        /** \brief Makes the incumbent the answer as it is, unless there is one that was checked: nothing more can be
            done. */
        void giveUp() override;

        /** \brief Whether the answer was checked in full. */
        bool isStrict() const
        {
            return level_ == CheckLevel::Everywhere;
        }

        /** \brief Whether the answer may differ from the incumbent. */
        bool isActive() const override;

    private:
        /* Attempts of one level. */
        struct Effort
        {
            std::uint64_t spent{0};    ///< work of all attempts
            std::uint64_t last{0};     ///< work of the last attempt
            std::uint64_t tried{0};    ///< improvements of the incumbent at the last attempt
            unsigned int attempts{0};  ///< for that improvement
            bool succeeded{false};     ///< the last attempt
        };

        /* The last notable improvement of the incumbent. */
        struct Notable
        {
            double cost{0.0};
            double work{0.0};  ///< 0: none yet
        };

        /* Costs of the last path that was checked in full. */
        struct Repair
        {
            double incumbent{0.0};
            double repaired{0.0};
        };

        double firstShare() const;
        double expectedGain() const;
        bool isBetterBy(double fraction) const;
        bool isSingleMotion() const;
        bool isAffordable(std::uint64_t work, double share) const;
        bool isFullCheckDue() const;
        bool areCornersDue() const;
        bool isTighteningDue() const;
        std::uint64_t fullCheckWork(const path::Waypoints &path) const;
        void watchImprovements();
        void tighten();
        void make(CheckLevel level);
        bool check(CheckLevel level, path::Waypoints &path);
        void accept(const path::Waypoints &path, double cost, CheckLevel level, const path::Waypoints &original,
                    std::optional<PartKind> origin);
        bool isConfirmationDue() const;
        void confirm();

        SearchContext &context_;
        PathRepair repair_;
        PathTightening tightening_;         ///< of the answer, or of a path that is to become better
        std::uint64_t tighteningSpent_{0};  ///< work of that
        bool canTighten_{false};            ///< whether it has a path, which was checked in full
        std::uint64_t confirmed_{0};        ///< improvements of the answer that was checked last as it was
        CheckedPath checked_;
        Effort full_;
        Effort corners_;
        Notable notable_;
        Repair lastFull_;
        std::uint64_t begin_{0};                 ///< work before the first attempt; 0: none
        CheckLevel level_{CheckLevel::Nowhere};  ///< of the answer
    };
}  // namespace ompl_mfa::engine::refinement

#endif
