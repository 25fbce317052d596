#include "engine/PartRegistry.h"

#include <utility>

#include <ompl/util/Exception.h>

#include "engine/fireflies/FireflyPart.h"
#include "engine/fireflies/GoalSearchPart.h"
#include "engine/fireflies/RecombinationPart.h"
#include "engine/guides/GuestPlannerPart.h"
#include "engine/guides/RoadmapPart.h"
#include "engine/guides/TreePart.h"
#include "engine/refinement/TighteningPart.h"

namespace ompl_mfa
{
    namespace
    {
        /* Fireflies of the paper, and of a swarm that other parts assist. */
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
            Swarms::Options options;
            options.fireflies = fireflySettings(context.settings, POPULATION);
            list.swarms = std::make_shared<Swarms>(context, options);
            list.parts.push_back(std::make_unique<FireflyPart>(context, list.swarms, list.guided));
            if (context.settings.recombination)
                list.parts.push_back(std::make_unique<RecombinationPart>(context, list.swarms, list.guided));
        }

        PartList paperParts(const SearchContext &context)
        {
            Swarms::Options options;
            options.coordinates = Swarm::Coordinates::Offsets;
            options.windows = options.bounded = false;
            options.fireflies = fireflySettings(context.settings, PAPER_POPULATION);
            PartList list;
            list.swarms = std::make_shared<Swarms>(context, options);
            list.parts.push_back(std::make_unique<FireflyPart>(context, list.swarms, false));
            return list;
        }
    }  // namespace

    PartList makeParts(const SearchContext &context, const ompl::base::PlannerAllocator &guest)
    {
        const SearchSettings &settings = context.settings;
        PartList list;
        if (settings.isPaper() && !guest)
            list = paperParts(context);
        else
        {
            list.guided = settings.usesTrees() || settings.usesRoadmap() || guest;
            if (!settings.fireflies && !list.guided)
                throw ompl::Exception(context.owner.getName(),
                                      "nothing searches for paths: fireflies = 0, guide = none and no guide planner");
            if (settings.fireflies)
                addSwarms(context, list);
            if (settings.tightening)
            {
                auto tightening = std::make_unique<TighteningPart>(context);
                list.refiner = tightening.get();
                list.parts.push_back(std::move(tightening));
            }
            if (settings.usesTrees())
                list.parts.push_back(std::make_unique<TreePart>(context));
            if (settings.usesRoadmap())
                list.parts.push_back(std::make_unique<RoadmapPart>(context, settings.usesTrees()));
            if (guest)
                list.parts.push_back(std::make_unique<GuestPlannerPart>(context, guest));
        }
        if (context.query.needsGoalSearch())
            list.parts.push_back(std::make_unique<GoalSearchPart>(context));
        return list;
    }
}  // namespace ompl_mfa
