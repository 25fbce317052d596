#ifndef OMPL_MFA_TEST_CLI_CONFIG_FIXTURE_
#define OMPL_MFA_TEST_CLI_CONFIG_FIXTURE_

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "cli/RunProgram.h"

/** \brief A folder of its own with a world of one wall and a config that plans around it. */
class ConfigFixture : public testing::Test
{
protected:
    ConfigFixture()
      : folder_(std::filesystem::temp_directory_path() / ("ompl_mfa_cli_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
        write("wall.yaml",
              "world:\n  collision_objects:\n    - id: wall\n"
              "      primitives: [{type: box, dimensions: [1.0, 4.0, 1.0]}]\n"
              "      primitive_poses: [{position: [5.0, 3.0, 0.0], orientation: [0, 0, 0, 1]}]\n");
    }

    ~ConfigFixture() override
    {
        std::filesystem::remove_all(folder_);
    }

    std::string path(const std::string &name) const
    {
        return (folder_ / name).string();
    }

    void write(const std::string &name, const std::string &text) const
    {
        std::ofstream(folder_ / name) << text;
    }

    /** \brief Writes a.cfg: 10 m x 10 m, a disc of radius 0.5, the shortest path 9.6435 m long; returns its path. */
    std::string config(const std::string &start = "start.x = 1\nstart.y = 3\n", const std::string &planners = "",
                       const std::string &world = "world = wall.yaml\n") const
    {
        write("a.cfg",
              "[problem]\n" + world + "robot = disc\nrobot.radius = 0.5\n" + start +
                  "goal.x = 9\ngoal.y = 3\nvolume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 10\n"
                  "volume.max.y = 10\nobjective = length\n[benchmark]\ntime_limit = 0.5\nseed = 5\n[planner]\n" +
                  planners);
        return path("a.cfg");
    }

    std::filesystem::path folder_;
};

#endif
