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

#ifndef OMPL_MFA_DRIVE_DRIVE_
#define OMPL_MFA_DRIVE_DRIVE_

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "drive/KnownWorld.h"
#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ompl_mfa::drive
{
    /** \brief How a drive ended. */
    enum class DriveStatus
    {
        Arrived,
        NoPath,    ///< no path for as long as the robot's patience lasts
        TimeOut,   ///< the time limit of the drive is over
        Collision  ///< the robot touched an obstacle, which what it knows excludes
    };

    /** \brief "arrived", "no path", "time out" or "collision". */
    std::string statusText(DriveStatus status);

    /** \brief One period of a drive. */
    struct DrivePeriod
    {
        /** \brief Seconds from the beginning of the drive, and where the robot is then. */
        double time;
        Pose pose;
        /** \brief What it has driven so far. */
        double driven;
        /** \brief Cells that the scan showed to be otherwise than known. */
        std::size_t newCells;
        /** \brief Whether there was a path and it collides with what the scan showed. */
        bool isBlocked;
        /** \brief Seconds of planning until a valid path was at hand: 0 if the old one was valid, infinite if there is
            none at the end of the period. */
        double pathTime;
        /** \brief Length of the path that the robot follows; infinite without one. */
        double pathLength;
    };

    /** \brief What an animation shows of a period. */
    struct DriveFrame
    {
        using Line = std::vector<Eigen::Vector2d>;

        /** \brief What was learnt since the frame before. */
        std::vector<maps::CellChange> news;
        Line path;
        std::vector<Line> swarm;
        /** \brief Index of the pose in the trail. */
        std::size_t place{0};
    };

    struct DriveResult
    {
        DriveStatus status{DriveStatus::TimeOut};
        /** \brief Seconds on the robot's clock, which stands still while it plans. */
        double duration{0.0};
        double driven{0.0};
        /** \brief The poses after all steps, at most a quarter of a cell apart. */
        std::vector<Pose> trail;
        std::vector<DrivePeriod> periods;
        /** \brief For each time that the path was blocked: seconds of learning, checking and planning, over as many
            periods as it took, until there was a valid path again. */
        std::vector<double> repairTimes;
        /** \brief How often the path was blocked, and how often it was replaced by a better one. */
        std::size_t blockages{0};
        std::size_t improvements{0};
        /** \brief As many as periods if a recording was asked for, and one with what was learnt last; else none. */
        std::vector<DriveFrame> frames;
    };

    /** \brief The map that the robot of \e factory knows at first. Throws InputError if the file is wrong, or has not
        the frame and the size of the world. */
    std::optional<maps::GridMap> loadKnownMap(const benchmark::ProblemFactory &factory);

    /** \brief Lets the robot of \e factory, whose world is a map, drive from start to goal with the planner of \e spec.
        In each period it scans, plans from where it is for the replan time, takes the new path if the old one is
        blocked or costs more, and drives on, in steps that are valid by what it knows: their motions, or states of
       which no point is more than a twentieth of a cell from the state before, for a robot that turns close to
       obstacles.

        Its random numbers are OMPL's. Throws InputError for start or goal in collision, and as createPlanner(). */
    DriveResult drive(const benchmark::ProblemFactory &factory, const std::optional<maps::GridMap> &known,
                      const benchmark::PlannerSpec &spec, bool isRecorded = false);

    /** \brief Length of the path that MFA finds on the true map in \e seconds; infinite if it finds none. */
    double omniscientLength(const benchmark::ProblemFactory &factory, double seconds);
}  // namespace ompl_mfa::drive

#endif
