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

#include "cli/PathFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <locale>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        struct PlanarPose
        {
            Eigen::Vector2d position;
            double yaw;
        };

        bool turns(const ob::StateSpace &space)
        {
            return dynamic_cast<const ob::SE2StateSpace *>(&space) != nullptr;
        }

        PlanarPose poseOf(const ob::StateSpace &space, const ob::State *state)
        {
            if (turns(space))
            {
                const auto *pose = state->as<ob::SE2StateSpace::StateType>();
                return {{pose->getX(), pose->getY()}, pose->getYaw()};
            }
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return {{values[0], values[1]}, 0.0};
        }

        /* The direction to the next position; where it rests, that of the motion before. */
        void turnAlong(std::vector<PlanarPose> &poses)
        {
            double yaw = 0.0;
            bool isKnown = false;
            for (std::size_t i = 0; i + 1 < poses.size(); ++i)
            {
                const Eigen::Vector2d along = poses[i + 1].position - poses[i].position;
                if (along.norm() > 0.0)
                {
                    yaw = std::atan2(along.y(), along.x());
                    std::for_each(poses.begin(), poses.begin() + (isKnown ? 0 : static_cast<std::ptrdiff_t>(i)),
                                  [yaw](PlanarPose &pose) { pose.yaw = yaw; });
                    isKnown = true;
                }
                poses[i].yaw = yaw;
            }
            poses.back().yaw = yaw;
        }

        std::vector<PlanarPose> spacedPoses(const og::PathGeometric &path, double spacing)
        {
            const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
            ob::ScopedState<> state(space);
            std::vector<PlanarPose> poses;
            for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            {
                const ob::State *from = path.getState(i);
                const ob::State *to = path.getState(i + 1);
                // of a curve the distance is the length; rotation adds to it in SE(2)
                const double length = space->distance(from, to);
                const auto parts = std::max(1.0, std::ceil(length / spacing));
                for (double part = 0.0; part < parts; part += 1.0)
                {
                    space->interpolate(from, to, part / parts, state.get());
                    poses.push_back(poseOf(*space, state.get()));
                }
            }
            poses.push_back(poseOf(*space, path.getState(static_cast<unsigned int>(path.getStateCount()) - 1)));
            if (!turns(*space))
            {
                turnAlong(poses);
            }
            return poses;
        }

        void writeCsv(std::ostream &out, const std::vector<PlanarPose> &poses)
        {
            out << "x,y,yaw\n";
            for (const PlanarPose &pose : poses)
            {
                out << pose.position.x() << ',' << pose.position.y() << ',' << pose.yaw << '\n';
            }
        }

        void writeYaml(std::ostream &out, const std::vector<PlanarPose> &poses)
        {
            const std::string header = "header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}\n";
            out << header << "poses:\n";
            for (const PlanarPose &pose : poses)
            {
                out << "- " << header << "  pose:\n    position: {x: " << pose.position.x()
                    << ", y: " << pose.position.y()
                    << ", z: 0.0}\n    orientation: {x: 0.0, y: 0.0, z: " << std::sin(0.5 * pose.yaw)
                    << ", w: " << std::cos(0.5 * pose.yaw) << "}\n";
            }
        }
    }  // namespace

    PathFormat pathFormat(const std::string &file)
    {
        const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
        return extension == ".csv"                           ? PathFormat::Csv
               : extension == ".yaml" || extension == ".yml" ? PathFormat::Yaml
                                                             : PathFormat::Matrix;
    }

    void requirePathFormat(PathFormat format, const ob::StateSpace &space, const std::string &file)
    {
        const auto *positions = dynamic_cast<const ob::RealVectorStateSpace *>(&space);
        if (format != PathFormat::Matrix && !turns(space) && (positions == nullptr || positions->getDimension() != 2))
        {
            throw InputError("--path " + file + ": x, y and yaw do not describe a state of the space " +
                             space.getName() + "; expected another extension than .csv, .yaml and .yml");
        }
    }

    void writePath(const og::PathGeometric &path, const std::string &file, double spacing)
    {
        std::ofstream out(file);
        out.imbue(std::locale::classic());
        out << std::setprecision(std::numeric_limits<double>::max_digits10);
        const PathFormat format = pathFormat(file);
        if (format == PathFormat::Matrix)
        {
            path.printAsMatrix(out);
        }
        else if (format == PathFormat::Csv)
        {
            writeCsv(out, spacedPoses(path, spacing));
        }
        else
        {
            writeYaml(out, spacedPoses(path, spacing));
        }
        out.close();
        if (!out)
        {
            throw InputError("--path " + file + ": cannot be written");
        }
    }
}  // namespace ompl_mfa::cli
