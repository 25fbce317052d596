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

#ifndef OMPL_MFA_CLI_PATH_FILE_
#define OMPL_MFA_CLI_PATH_FILE_

#include <string>

#include <ompl/geometric/PathGeometric.h>

namespace ompl_mfa::cli
{
    /** \brief Formats of path files, by their extensions. */
    enum class PathFormat
    {
        Matrix,  ///< any other: the states of the path, a line each
        Csv,     ///< .csv: x,y,yaw
        Yaml     ///< .yaml, .yml: the fields of a nav_msgs/Path
    };

    /** \brief The format given by the extension of \e file, in upper or lower case. */
    PathFormat pathFormat(const std::string &file);

    /** \brief Throws InputError unless paths of \e space can be written in \e format: CSV and YAML are for R^2 and
        spaces of x, y and yaw. */
    void requirePathFormat(PathFormat format, const ompl::base::StateSpace &space, const std::string &file);

    /** \brief Writes \e path. In CSV and YAML states of its motions are added so that none is farther than \e spacing,
        above 0, from the next; in R^2 the yaw is the direction of travel. Throws InputError if \e file cannot be
        written. */
    void writePath(const ompl::geometric::PathGeometric &path, const std::string &file, double spacing);
}  // namespace ompl_mfa::cli

#endif
