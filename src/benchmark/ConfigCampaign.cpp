#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "benchmark/FileNames.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ompl_mfa
{
    namespace
    {
        std::string fileText(const std::filesystem::path &file)
        {
            std::ifstream in(file, std::ios::binary);
            return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        }

        /* The texts of the config and of world and robot: a campaign with another mesh is another campaign. */
        std::string identityOf(const BenchmarkConfig &config)
        {
            std::string identity = fileText(config.file);
            if (config.problem.world)
            {
                identity += fileText(findResource(config, *config.problem.world));
            }
            try
            {
                identity += fileText(findResource(config, config.problem.robot));
            }
            catch (const InputError &)
            {
                // A point, a disc or a sphere: not a file.
            }
            return identity;
        }

        void refuseSeeds(const BenchmarkConfig &config)
        {
            for (const PlannerSpec &planner : config.planners)
            {
                for (const ConfigEntry &parameter : planner.parameters)
                {
                    if (parameter.key == "seed")
                    {
                        failAt(parameter, "a campaign gives each run its own seed; benchmark.seed sets the first one");
                    }
                }
            }
        }
    }  // namespace

    Campaign makeCampaign(const BenchmarkConfig &config)
    {
        refuseSeeds(config);
        CampaignDescription description;
        description.name = config.problem.name;
        description.settings.timeLimit = config.benchmark.timeLimit;
        description.settings.memoryLimit = config.benchmark.memoryLimit;
        description.settings.progressInterval = config.benchmark.progressInterval;
        description.settings.iterationLimit = config.benchmark.iterationLimit;
        description.settings.simplify = config.benchmark.simplify;
        description.runCount = config.benchmark.runCount;
        description.seed = config.benchmark.seed;
        description.savePaths = config.benchmark.savePaths;
        description.identity = identityOf(config);
        const auto factory = std::make_shared<ProblemFactory>(config);
        for (const PlannerSpec &planner : config.planners)
        {
            description.planners.push_back(
                {planner.name, [factory, planner] { return factory->create(planner.context); },
                 [planner](const ompl::base::SpaceInformationPtr &si) { return createPlanner(si, planner); }});
        }
        return Campaign(std::move(description));
    }

    std::filesystem::path logFile(const BenchmarkConfig &config, unsigned int shard, unsigned int shards)
    {
        std::filesystem::path folder = config.file.parent_path();
        if (!config.benchmark.output.empty())
        {
            folder = config.benchmark.output;
        }
        std::string name = fileNamePart(config.problem.name);
        if (shards > 1)
        {
            name += "." + std::to_string(shard) + "-of-" + std::to_string(shards);
        }
        return folder / (name + ".log");
    }
}  // namespace ompl_mfa
