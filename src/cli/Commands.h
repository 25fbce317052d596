#ifndef OMPL_MFA_CLI_COMMANDS_
#define OMPL_MFA_CLI_COMMANDS_

#include <CLI/CLI.hpp>

/** \brief Each function declares one subcommand of the program with its options and its callback.

    A callback prints its result to standard output: a table for people or, with `--json`, exactly one JSON document.
    Messages go to standard error. For anything the user handed in that cannot be used it throws InputError, which the
    program prints on one line before it exits with status 2. A command that ran but did not reach its aim throws
    CLI::RuntimeError(1) after printing its result. */
namespace ompl_mfa::cli
{
    void addBenchmarkCommand(CLI::App &app);
    void addCheckCommand(CLI::App &app);
    void addMergeCommand(CLI::App &app);
    void addOptimizeCommand(CLI::App &app);
    void addPlanCommand(CLI::App &app);
    void addPlannersCommand(CLI::App &app);
}  // namespace ompl_mfa::cli

#endif
