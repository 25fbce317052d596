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

#ifndef OMPL_MFA_ENGINE_SEARCH_SETTINGS_
#define OMPL_MFA_ENGINE_SEARCH_SETTINGS_

#include <string>

namespace ompl_mfa::engine
{
    /** \brief The parameters of a search with their defaults; mfaParameters() describes each. A search uses a copy that
       does not change. */
    struct SearchSettings
    {
        std::string variant{"mfa"};
        bool fireflies{true};
        std::string fireflyMoves{"both"};
        unsigned int populationSize{0};
        unsigned int slices{12};
        unsigned int generations{50};
        double gamma{0.5};
        double alpha{0.2};
        double eta{1.0};
        std::string guide{"both"};
        bool recombination{true};
        bool tightening{true};
        unsigned int seed{0};
        double stateCheckTime{0.1};
        unsigned int threads{1};
        unsigned int strictness{8};

        bool usesTrees() const
        {
            return guide == "trees" || guide == "both";
        }

        bool usesRoadmap() const
        {
            return guide == "roadmap" || guide == "both";
        }

        /** \brief Whether the pool of good paths is the swarm's population once there is a path. */
        bool usesPool() const
        {
            return fireflies && tightening;
        }

        /** \brief Whether the fireflies are the only part, as in the paper's algorithm (a guide planner aside). */
        bool isPaper() const
        {
            return fireflies && !usesTrees() && !usesRoadmap() && !recombination && !tightening;
        }
    };
}  // namespace ompl_mfa::engine

#endif
