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

#ifndef OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_
#define OMPL_MFA_BENCHMARK_PROBLEM_FACTORY_

#include <cstdint>
#include <memory>

#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::benchmark
{
    /** \brief Makes ready problems of one config. World and robot are loaded once and shared by all of them. */
    class OMPL_MFA_EXPORT ProblemFactory
    {
    public:
        /** \brief Loads world and robot. Makes no random number generator. Throws InputError for a file that is missing
            or cannot be used, and where neither the config nor a world bounds the problem. */
        explicit ProblemFactory(BenchmarkConfig config);

        const BenchmarkConfig &config() const
        {
            return config_;
        }

        /** \brief Empty where the config names no world. */
        const collision::Scene &world() const
        {
            return *world_;
        }

        const collision::RigidBody &robot() const
        {
            return robot_;
        }

        /** \brief A new problem, set up but for its planner; \e plannerContext overrides the context of the config, so
            that nothing of one planner reaches the next.

            Makes random number generators: setRandomSeed() comes before. Throws InputError when start or goal is out
            of bounds or collides (by less than a hundredth of the bounds' diagonal: with a valid state nearby), or when
            the space or the sampler has no such setting. */
        ompl::geometric::SimpleSetupPtr create(const ContextConfig &plannerContext = {}) const;

        /** \brief As create() with the context of \e spec, and with its planner. */
        ompl::geometric::SimpleSetupPtr create(const PlannerSpec &spec) const;

    private:
        BenchmarkConfig config_;
        std::shared_ptr<const collision::Scene> world_;
        collision::RigidBody robot_;
    };

    /** \brief Seeds OMPL; runs repeat when this comes before the first random number generator of the process. Throws
        InputError for 0, which OMPL does not accept. */
    OMPL_MFA_EXPORT void setRandomSeed(std::uint_fast32_t seed);
}  // namespace ompl_mfa::benchmark

#endif
