#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <ompl/base/goals/GoalState.h>

#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/NumberText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "ompl_mfa/benchmark/ProblemSpace.h"

namespace
{
    namespace ob = ompl::base;
    using ompl_mfa::BenchmarkConfig;
    using ompl_mfa::ProblemFactory;

    struct Options
    {
        std::string file;
        bool json{false};
    };

    /** \brief The motion straight from start to goal. */
    struct StraightMotion
    {
        bool free{false};
        /** \brief Part of the motion that is known to be free, in [0, 1]. */
        double freeFraction{0.0};
        double length{0.0};
    };

    StraightMotion straightMotion(const ompl::geometric::SimpleSetup &setup)
    {
        const auto &si = setup.getSpaceInformation();
        const ob::State *start = setup.getProblemDefinition()->getStartState(0);
        const ob::State *goal = setup.getGoal()->as<ob::GoalState>()->getState();
        std::pair<ob::State *, double> lastValid(nullptr, 0.0);
        StraightMotion motion;
        motion.free = si->checkMotion(start, goal, lastValid);
        motion.freeFraction = motion.free ? 1.0 : lastValid.second;
        motion.length = si->distance(start, goal);
        return motion;
    }

    /** \brief Makes and sets up every planner of the config: what would fail in a campaign fails here. */
    void checkPlanners(const ProblemFactory &factory)
    {
        for (const auto &spec : factory.config().planners)
        {
            const auto setup = factory.create(spec);
            try
            {
                setup->setup();
            }
            catch (const std::exception &error)
            {
                throw ompl_mfa::InputError(spec.origin + ": planner '" + spec.type +
                                           "' cannot be set up for this problem: " + error.what());
            }
        }
    }

    nlohmann::json describe(const ProblemFactory &factory, const ompl::geometric::SimpleSetup &setup)
    {
        const BenchmarkConfig &config = factory.config();
        const StraightMotion motion = straightMotion(setup);
        nlohmann::json planners = nlohmann::json::array();
        for (const auto &spec : config.planners)
            planners.push_back({{"type", spec.type}, {"name", spec.name}});
        return {{"problem", config.problem.name},
                {"space", ompl_mfa::spaceName(config.problem.space)},
                {"world", config.problem.world ? nlohmann::json(config.problem.world->value) : nlohmann::json()},
                {"obstacles", factory.world().objects().size()},
                {"robot", config.problem.robot.value},
                {"robot_radius", factory.robot().radius()},
                {"start_valid", true},
                {"goal_valid", true},
                {"straight_motion",
                 {{"free", motion.free}, {"free_fraction", motion.freeFraction}, {"length", motion.length}}},
                {"planners", planners}};
    }

    void printText(const nlohmann::json &description)
    {
        const auto &motion = description["straight_motion"];
        const ompl_mfa::PlainNumbers plainNumbers(std::cout);
        std::cout << std::setprecision(6);
        std::cout << "problem    " << description["problem"].get<std::string>() << "\n"
                  << "space      " << description["space"].get<std::string>() << "\n"
                  << "world      "
                  << (description["world"].is_null() ? "empty" : description["world"].get<std::string>()) << ", "
                  << description["obstacles"] << " obstacles\n"
                  << "robot      " << description["robot"].get<std::string>() << ", radius "
                  << description["robot_radius"].get<double>() << "\n"
                  << "start      valid\n"
                  << "goal       valid\n"
                  << "straight   ";
        if (motion["free"].get<bool>())
            std::cout << "free, length " << motion["length"].get<double>() << "\n";
        else
            std::cout << "blocked after " << motion["free_fraction"].get<double>() << " of length "
                      << motion["length"].get<double>() << "\n";
        std::cout << "planners   " << description["planners"].size() << "\n";
    }

    void check(const Options &options)
    {
        const ProblemFactory factory(ompl_mfa::readBenchmarkConfig(options.file));
        ompl_mfa::setRandomSeed(factory.config().benchmark.seed);
        const auto setup = factory.create();
        checkPlanners(factory);
        const nlohmann::json description = describe(factory, *setup);
        if (options.json)
            ompl_mfa::cli::printDocument(description);
        else
            printText(description);
    }
}  // namespace

void ompl_mfa::cli::addCheckCommand(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    auto *command = app.add_subcommand("check", "Validate a benchmark config without running it");
    command->add_option("FILE", options->file, "A .cfg file")->required();
    command->add_flag("--json", options->json, "Print one JSON document");
    command->callback([options] { check(*options); });
}
