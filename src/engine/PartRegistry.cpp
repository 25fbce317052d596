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

#include "engine/PartRegistry.h"

#include <utility>

#include <ompl/util/Exception.h>

#include "engine/fireflies/FireflyPart.h"
#include "engine/fireflies/GoalSearchPart.h"
#include "engine/fireflies/RecombinationPart.h"
#include "engine/guides/GuestPlannerPart.h"
#include "engine/guides/RoadmapPart.h"
#include "engine/guides/TreePart.h"
#include "engine/refinement/PathMending.h"
#include "engine/refinement/StrictAnswer.h"
#include "engine/refinement/TighteningPart.h"

namespace ompl_mfa::engine
{
    namespace
    {
        /* Population sizes of the paper, and of a swarm beside other parts. */
        constexpr unsigned int PAPER_POPULATION = 100;
        constexpr unsigned int POPULATION = 20;

        FireflyOptimizer::Settings fireflySettings(const SearchSettings &search, unsigned int population)
        {
            FireflyOptimizer::Settings settings;
            settings.variant = search.variant == "mfa" ? FireflyOptimizer::Variant::MFA : FireflyOptimizer::Variant::FA;
            settings.populationSize = search.populationSize != 0 ? search.populationSize : population;
            settings.generations = search.generations;
            settings.gamma = search.gamma;
            settings.alpha = search.alpha;
            settings.eta = search.eta;
            return settings;
        }

        void addSwarms(const SearchContext &context, PartList &list)
        {
            fireflies::Swarms::Options options;
            options.guided = list.guided;
            options.pool = context.settings.usesPool();
            options.fireflies = fireflySettings(context.settings, POPULATION);
            list.swarms = std::make_shared<fireflies::Swarms>(context, options);
            list.parts.push_back(std::make_unique<fireflies::FireflyPart>(context, list.swarms));
            if (context.settings.recombination)
            {
                list.parts.push_back(std::make_unique<fireflies::RecombinationPart>(context, list.swarms));
            }
        }

        PartList paperParts(const SearchContext &context)
        {
            fireflies::Swarms::Options options;
            options.coordinates = fireflies::Swarm::Coordinates::Offsets;
            options.pool = options.bounded = false;
            options.fireflies = fireflySettings(context.settings, PAPER_POPULATION);
            PartList list;
            list.swarms = std::make_shared<fireflies::Swarms>(context, options);
            list.parts.push_back(std::make_unique<fireflies::FireflyPart>(context, list.swarms));
            return list;
        }
    }  // namespace

    PartList makeParts(const SearchContext &context, const ompl::base::PlannerAllocator &guest)
    {
        const SearchSettings &settings = context.settings;
        PartList list;
        if (settings.isPaper() && !guest)
        {
            list = paperParts(context);
        }
        else
        {
            list.guided = settings.usesTrees() || settings.usesRoadmap() || guest;
            if (!settings.fireflies && !list.guided)
            {
                throw ompl::Exception(context.owner.getName(),
                                      "nothing searches for paths: fireflies = 0, guide = none and no guide planner");
            }
            list.mender = std::make_unique<refinement::PathMending>(context.chart, context.evaluator(),
                                                                    streamSeed(context.seed, Stream::Mending));
            if (settings.fireflies)
            {
                addSwarms(context, list);
            }
            if (settings.tightening)
            {
                auto tightening = std::make_unique<refinement::TighteningPart>(context);
                list.refiner = tightening.get();
                list.parts.push_back(std::move(tightening));
            }
            if (settings.usesTrees())
            {
                list.parts.push_back(std::make_unique<guides::TreePart>(context));
            }
            if (settings.usesRoadmap())
            {
                list.parts.push_back(std::make_unique<guides::RoadmapPart>(context, settings.usesTrees()));
            }
            if (guest)
            {
                list.parts.push_back(std::make_unique<guides::GuestPlannerPart>(context, guest));
            }
        }
        if (context.query.needsGoalSearch())
        {
            list.parts.push_back(std::make_unique<fireflies::GoalSearchPart>(context));
        }
        return list;
    }

    std::unique_ptr<AnswerMaker> makeAnswerMaker(SearchContext &context)
    {
        return std::make_unique<refinement::StrictAnswer>(context);
    }
}  // namespace ompl_mfa::engine
