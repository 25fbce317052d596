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

#ifndef OMPL_MFA_TEST_COLLISION_OMPL_APP_PROBLEMS_
#define OMPL_MFA_TEST_COLLISION_OMPL_APP_PROBLEMS_

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "ompl_mfa/collision/FclStateValidityChecker.h"
#include "ompl_mfa/collision/SceneLoader.h"

namespace ompl_mfa::collision
{
    namespace ob = ompl::base;

    /** \brief A problem of OMPL.app, as given by its .cfg. */
    struct OmplAppProblem
    {
        const char *name;
        const char *folder;
        const char *world;
        const char *robot;
        bool planar;
        std::vector<double> low;
        std::vector<double> high;

        /** \brief Length scale for tolerances of clearances. */
        double scale() const
        {
            return high[0] - low[0];
        }
    };

    inline const std::vector<OmplAppProblem> &omplAppProblems()
    {
        static const std::vector<OmplAppProblem> PROBLEMS{
            {"Barriers",
             "2D",
             "Barriers_easy_env.dae",
             "Barriers_easy_robot.dae",
             true,
             {0.0, -440.22998046875},
             {661.0222778320312, 0.4874267578125}},
            {"RandomPolygons_planar",
             "2D",
             "RandomPolygons_planar_env.dae",
             "car2_planar_robot.dae",
             true,
             {-55.0, -55.0006408691},
             {55.0, 54.9992599487}},
            {"Easy",
             "3D",
             "Easy_env.dae",
             "Easy_robot.dae",
             false,
             {14.4604492188, -24.25, -504.855102539},
             {457.960449219, 321.25, -72.8550872803}},
            {"Twistycool",
             "3D",
             "Twistycool_env.dae",
             "Twistycool_robot.dae",
             false,
             {53.46, -21.25, -476.86},
             {402.96, 269.25, -91.0}},
            {"cubicles",
             "3D",
             "cubicles_env.dae",
             "cubicles_robot.dae",
             false,
             {-508.88, -230.13, -123.75},
             {319.62, 531.87, 101.0}},
        };
        return PROBLEMS;
    }

    inline std::filesystem::path omplAppFolder()
    {
        const char *folder = std::getenv("OMPL_MFA_OMPLAPP_DIR");
        return folder != nullptr ? std::filesystem::path(folder)
                                 : std::filesystem::path(OMPL_MFA_SOURCE_DIR) / ".." / "shared" / "omplapp";
    }

    /** \brief Space, world and robot of a problem, ready for queries. */
    class OmplAppWorld
    {
    public:
        explicit OmplAppWorld(const OmplAppProblem &problem)
          : planar_(problem.planar)
        {
            ob::RealVectorBounds bounds(static_cast<unsigned int>(problem.low.size()));
            bounds.low = problem.low;
            bounds.high = problem.high;
            if (planar_)
            {
                auto space = std::make_shared<ob::SE2StateSpace>();
                space->setBounds(bounds);
                space_ = space;
            }
            else
            {
                auto space = std::make_shared<ob::SE3StateSpace>();
                space->setBounds(bounds);
                space_ = space;
            }
            si_ = std::make_shared<ob::SpaceInformation>(space_);
            const std::filesystem::path folder = omplAppFolder() / problem.folder;
            checker_ = std::make_shared<FclStateValidityChecker>(
                si_, std::make_shared<Scene>(loadScene(folder / problem.world)),
                loadRobot(folder / problem.robot,
                          planar_ ? RobotCentring::PlanarVertexMean : RobotCentring::VertexMean));
            si_->setStateValidityChecker(checker_);
            si_->setup();
        }

        const ob::SpaceInformationPtr &si() const
        {
            return si_;
        }

        const std::shared_ptr<FclStateValidityChecker> &checker() const
        {
            return checker_;
        }

        /** \brief A state from x y theta or x y z qx qy qz qw. */
        ob::ScopedState<> state(const std::vector<double> &values) const
        {
            ob::ScopedState<> state(space_);
            if (planar_)
            {
                auto *se2 = state->as<ob::SE2StateSpace::StateType>();
                se2->setXY(values[0], values[1]);
                se2->setYaw(values[2]);
            }
            else
            {
                auto *se3 = state->as<ob::SE3StateSpace::StateType>();
                se3->setXYZ(values[0], values[1], values[2]);
                se3->rotation().x = values[3];
                se3->rotation().y = values[4];
                se3->rotation().z = values[5];
                se3->rotation().w = values[6];
            }
            si_->enforceBounds(state.get());
            return state;
        }

    private:
        bool planar_;
        ob::StateSpacePtr space_;
        ob::SpaceInformationPtr si_;
        std::shared_ptr<FclStateValidityChecker> checker_;
    };

    /** \brief Rows of numbers of a file. */
    inline std::vector<std::vector<double>> readRows(const std::filesystem::path &file)
    {
        std::vector<std::vector<double>> rows;
        std::ifstream stream(file);
        for (std::string line; std::getline(stream, line);)
        {
            std::istringstream words(line);
            std::vector<double> row;
            for (double value = 0.; words >> value;)
            {
                row.push_back(value);
            }
            if (!row.empty())
            {
                rows.push_back(std::move(row));
            }
        }
        return rows;
    }

    /** \brief A test for each problem; skipped without OMPL.app's files. */
    class OmplAppTest : public ::testing::TestWithParam<OmplAppProblem>
    {
    protected:
        void SetUp() override
        {
            if (!std::filesystem::is_directory(omplAppFolder()))
            {
                GTEST_SKIP() << "set OMPL_MFA_OMPLAPP_DIR to the folder with OMPL.app's 2D, 3D and samples";
            }
        }
    };

    inline std::string problemName(const ::testing::TestParamInfo<OmplAppProblem> &info)
    {
        return info.param.name;
    }
}  // namespace ompl_mfa::collision

#endif
