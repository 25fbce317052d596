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

#include <cstdio>
#include <exception>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcl/config.h>
#include <ompl/util/Console.h>
#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include "cli/Commands.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NearestName.h"

namespace
{
    constexpr int FAILURE = 1;
    constexpr int BAD_INPUT = 2;

    /** \brief Writes OMPL's messages to standard error, as standard output is for results. */
    class StandardErrorOutput : public ompl::msg::OutputHandler
    {
    public:
        void log(const std::string &text, ompl::msg::LogLevel level, const char * /*filename*/, int /*line*/) override
        {
            std::cerr << (level == ompl::msg::LOG_WARN ? "warning: " : "") << ompl_mfa::oneLine(text) << std::endl;
        }
    };

    int report(const std::string &message, int status)
    {
        std::fputs(("ompl_mfa: " + ompl_mfa::oneLine(message) + "\n").c_str(), stderr);
        return status;
    }

    std::vector<std::string> commandNames(const CLI::App &app)
    {
        std::vector<std::string> names;
        for (const auto *command : app.get_subcommands([](const CLI::App *) { return true; }))
        {
            names.push_back(command->get_name());
        }
        return names;
    }

    std::vector<std::string> optionNames(const CLI::App &app)
    {
        std::vector<std::string> names;
        for (const auto *option : app.get_options())
        {
            for (const auto &name : option->get_lnames())
            {
                names.push_back("--" + name);
            }
        }
        return names;
    }

    /** \brief Message for unexpected arguments, with what would have been accepted. */
    std::string describeExtra(const CLI::App &app)
    {
        const auto parsed = app.get_subcommands();
        const CLI::App &innermost = parsed.empty() ? app : *parsed.back();
        const std::string extra = app.remaining(true).front();
        if (extra.front() == '-')
        {
            const std::string name = extra.substr(0, extra.find('='));
            return ompl_mfa::text::describeUnknown("option", name, optionNames(innermost));
        }
        if (parsed.empty())
        {
            return ompl_mfa::text::describeUnknown("command", extra, commandNames(app));
        }
        return "unexpected argument '" + extra + "' of '" + innermost.get_name() + "'";
    }

    int handleParseError(const CLI::App &app, const CLI::ParseError &error)
    {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
        {
            return app.exit(error);
        }
        if (error.get_name() == "RuntimeError")
        {
            return error.get_exit_code();
        }
        if (!app.remaining(true).empty())
        {
            return report(describeExtra(app), BAD_INPUT);
        }
        if (app.get_subcommands().empty())
        {
            return report(error.what() + std::string("; run 'ompl_mfa --help' for the list"), BAD_INPUT);
        }
        return report(error.what(), BAD_INPUT);
    }

    /** \brief The version of this program and of what it was built with. */
    std::string describeVersion()
    {
        const auto joined = [](std::initializer_list<int> numbers)
        {
            std::string text;
            for (const int number : numbers)
            {
                text += (text.empty() ? "" : ".") + std::to_string(number);
            }
            return text;
        };
        return "ompl_mfa " OMPL_MFA_VERSION "\nOMPL " OMPL_MFA_OMPL_VERSION "\nFCL " +
               joined({FCL_MAJOR_VERSION, FCL_MINOR_VERSION, FCL_PATCH_VERSION}) + "\nEigen " +
               joined({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION}) + "\n" OMPL_MFA_COMPILER;
    }

    int run(int argc, char **argv)
    {
        CLI::App app{"Modified Firefly Algorithm planning for OMPL", "ompl_mfa"};
        app.set_version_flag("--version", describeVersion());
        app.require_subcommand(1);
        ompl_mfa::cli::addAnimateCommand(app);
        ompl_mfa::cli::addBenchmarkCommand(app);
        ompl_mfa::cli::addCheckCommand(app);
        ompl_mfa::cli::addDriveCommand(app);
        ompl_mfa::cli::addMergeCommand(app);
        ompl_mfa::cli::addOptimizeCommand(app);
        ompl_mfa::cli::addPlanCommand(app);
        ompl_mfa::cli::addPlannersCommand(app);
        ompl_mfa::cli::addReportCommand(app);

        static StandardErrorOutput output;
        ompl::msg::useOutputHandler(&output);
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
        try
        {
            app.parse(argc, argv);
        }
        catch (const CLI::ParseError &error)
        {
            return handleParseError(app, error);
        }
        return 0;
    }
}  // namespace

int main(int argc, char **argv)
{
    try
    {
        const int status = run(argc, argv);
        if (std::fflush(stdout) != 0 || !std::cout.flush())
        {
            return report("standard output cannot be written", FAILURE);
        }
        return status;
    }
    catch (const ompl_mfa::InputError &error)
    {
        return report(error.what(), BAD_INPUT);
    }
    catch (const std::invalid_argument &error)
    {
        return report(error.what(), BAD_INPUT);
    }
    catch (const std::exception &error)
    {
        return report(error.what(), FAILURE);
    }
}
