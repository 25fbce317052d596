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

#include "Module.h"

#include <ompl/util/Console.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

#include <pybind11/stl.h>

namespace py = pybind11;

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The compiled part of ompl_mfa; use the functions of the package ompl_mfa.";
    module.attr("__version__") = OMPL_MFA_VERSION;
    module.attr("ompl_version") = OMPL_MFA_OMPL_VERSION;
    py::register_exception<ompl_mfa::InputError>(module, "InputError", PyExc_ValueError);
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    module.def(
        "set_verbose",
        [](bool verbose) { ompl::msg::setLogLevel(verbose ? ompl::msg::LOG_DEBUG : ompl::msg::LOG_ERROR); },
        py::arg("verbose"), "Whether OMPL's messages are written to standard output and standard error.");
    module.def("planner_names", &ompl_mfa::benchmark::plannerNames,
               "Names of all planners that plan() and solve() know: those of OMPL and of this project.");
    ompl_mfa::python::bindOptimizer(module);
    ompl_mfa::python::bindPlanning(module);
    ompl_mfa::python::bindCampaigns(module);
}
