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

#ifndef OMPL_MFA_ENGINE_PART_REGISTRY_
#define OMPL_MFA_ENGINE_PART_REGISTRY_

#include <memory>
#include <vector>

#include <ompl/base/Planner.h>

#include "engine/AnswerMaker.h"
#include "engine/SearchPart.h"

namespace ompl_mfa::engine
{
    namespace fireflies
    {
        class Swarms;
    }

    /** \brief The parts of a search, in the order of PartKind. */
    struct PartList
    {
        std::vector<std::unique_ptr<SearchPart>> parts;
        PathRefiner *refiner{nullptr};              ///< element of parts that tightens paths, or null
        std::shared_ptr<fireflies::Swarms> swarms;  ///< shared by the parts that use fireflies; may be null
        std::unique_ptr<PathMender> mender;         ///< null in the paper's algorithm
        bool guided{false};                         ///< whether a part other than the fireflies can find a first path
    };

    /** \brief Makes the parts that the settings of \e context ask for, and one for a guide planner unless \e guest is
        null. The paper's algorithm is a single part: fireflies whose coordinates are offsets. Throws ompl::Exception if
        no part can find a first path, or if \e guest returns no planner. */
    PartList makeParts(const SearchContext &context, const ompl::base::PlannerAllocator &guest);

    /** \brief What makes the answer of the search; \e context must outlive it. */
    std::unique_ptr<AnswerMaker> makeAnswerMaker(SearchContext &context);
}  // namespace ompl_mfa::engine

#endif
