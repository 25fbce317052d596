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

/* Random sequences of calls against the model, whatever was called before. */

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "planner/ConsoleRecord.h"
#include "planner/ContractModel.h"

namespace ompl_mfa::planner
{
    // where RapidCheck finds it
    std::ostream &operator<<(std::ostream &out, const Command &command)
    {
        static const std::array<const char *, static_cast<std::size_t>(Call::Count)> NAMES{{"SetByText",
                                                                                            "SetByText",
                                                                                            "SetBySetter",
                                                                                            "SetGuidePlanner",
                                                                                            "SameQueryElsewhere",
                                                                                            "NewProblemDefinition",
                                                                                            "NoProblemDefinition",
                                                                                            "AddStart",
                                                                                            "ReplaceStarts",
                                                                                            "NewGoal",
                                                                                            "ChangeGoal",
                                                                                            "ChangeGoal",
                                                                                            "AddGoal",
                                                                                            "NewObjective",
                                                                                            "ChangeThreshold",
                                                                                            "ChangeWorld",
                                                                                            "Clear",
                                                                                            "ClearQuery",
                                                                                            "ValidityChanged",
                                                                                            "AddHint",
                                                                                            "Setup",
                                                                                            "GetPlannerData",
                                                                                            "Solve",
                                                                                            "Solve",
                                                                                            "Solve",
                                                                                            "Solve",
                                                                                            "Solve"}};
        return out << NAMES[static_cast<std::size_t>(command.call)] << '(' << command.a << ", " << command.b << ')';
    }

    namespace
    {
        /* Uniform in [0, end) from the first case on, although RapidCheck starts with small numbers. */
        template <typename T>
        rc::Gen<T> below(T end)
        {
            return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(0, end));
        }

        rc::Gen<std::vector<Command>> anyCommands()
        {
            const auto call =
                rc::gen::map(below(static_cast<int>(Call::Count)), [](int i) { return static_cast<Call>(i); });
            const auto command =
                rc::gen::build<Command>(rc::gen::set(&Command::call, call), rc::gen::set(&Command::a, below(64U)),
                                        rc::gen::set(&Command::b, below(64U)));
            return rc::gen::scale(2.0, rc::gen::container<std::vector<Command>>(command));
        }

        RC_GTEST_PROP(ContractModel, HoldsForEverySequenceOfCalls, ())
        {
            const auto commands = *anyCommands();
            const test::ConsoleRecord console;
            Model model;
            for (const Command &command : commands)
            {
                model.run(command);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
