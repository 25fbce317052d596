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

#ifndef OMPL_MFA_BENCHMARK_CONFIG_FILE_
#define OMPL_MFA_BENCHMARK_CONFIG_FILE_

#include <array>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigLines.h"
#include "ompl_mfa/collision/FclMotionValidator.h"
#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::benchmark
{
    /** \brief The state space of a problem, determined by the keys of start and goal and by `statespace`. */
    enum class StateSpaceKind
    {
        R2,               ///< x, y: a point or a disc
        R3,               ///< x, y, z: a point or a ball
        SE2,              ///< x, y, theta
        SE3,              ///< x, y, z, axis.x, axis.y, axis.z, theta
        Dubins,           ///< SE2 with `statespace = dubins`
        DubinsSymmetric,  ///< SE2 with `statespace = dubinssymmetric`
        ReedsShepp,       ///< SE2 with `statespace = reedsshepp`
        Joints            ///< the joints of an arm
    };

    /** \brief Kind of robot. */
    enum class RobotKind
    {
        File,  ///< a mesh or planning scene
        Point,
        Disc,       ///< with robot.radius
        Sphere,     ///< with robot.radius
        Footprint,  ///< a polygon on a map, with robot.footprint
        Arm         ///< a URDF file
    };

    /** \brief The objective, or a term of a weighted sum. */
    enum class ObjectiveKind
    {
        Length,
        MaxMinClearance,  ///< not as a term
        MechanicalWork,
        ClearanceCost,  ///< length weighted by Nav2's inflation, on a map
        Proximity,      ///< only as a term
        Smoothness,     ///< only as a term, in SE2
        Weighted        ///< the sum of the problem's objectiveWeights
    };

    /** \brief How valid states are sampled. */
    enum class SamplerKind
    {
        Uniform,
        Gaussian,
        ObstacleBased,
        MaxClearance,
        BridgeTest
    };

    /** \brief A pose in the world. Coordinates that the problem's space does not have are 0. */
    struct ConfigPose
    {
        double x{0.0};
        double y{0.0};
        double z{0.0};
        /** \brief Rotation axis (SE3 only), of any nonzero length. */
        double axis[3]{0.0, 0.0, 1.0};
        /** \brief Rotation about the axis, radians. Any value is accepted and normalised later. */
        double theta{0.0};
        std::string origin;
    };

    /** \brief `volume.min.*` and `volume.max.*`. */
    struct ConfigVolume
    {
        double min[3]{0.0, 0.0, 0.0};
        double max[3]{0.0, 0.0, 0.0};
        std::string origin;
    };

    /** \brief Settings of a problem's space information that a planner may override. OMPL's defaults hold for those not
        set. */
    struct ContextConfig
    {
        std::optional<SamplerKind> sampler;
        std::optional<unsigned int> attempts;
        /** \brief For the gaussian and bridge_test samplers. */
        std::optional<Given<double>> standardDeviation;
        /** \brief For the max_clearance sampler. */
        std::optional<Given<unsigned int>> improveAttempts;
        std::optional<double> longestValidSegmentFraction;
        std::optional<unsigned int> validSegmentCountFactor;
        /** \brief Cell sizes of the default projection, one per dimension. */
        std::array<std::optional<Given<double>>, 3> cellSizes;
        /** \brief Factor for the cell sizes. */
        std::optional<double> cellSizeFactor;
    };

    /** \brief What describes an arm besides its URDF file. */
    struct ArmConfig
    {
        /** \brief An SRDF file. */
        std::optional<ConfigEntry> semantics;
        std::optional<ConfigEntry> group;
        /** \brief Folders of packages, separated by colons. */
        std::optional<ConfigEntry> packages;
        /** \brief A motion plan request. */
        std::optional<ConfigEntry> request;
        /** \brief Names of group states or values of the joints, in place of the request's. */
        std::optional<ConfigEntry> start;
        std::optional<ConfigEntry> goal;
        /** \brief Longest step between two checked states of a motion, in joint space: radians or metres. */
        double step{1.0 / 32.0};
        /** \brief Factors for the distances of the joints; empty: all 1. */
        std::vector<double> weights;
        /** \brief Enlargement of all links, metres. */
        double padding{0.0};
    };

    /** \brief A robot that drives and knows a map only in part, for `ompl_mfa drive`. */
    struct DriveConfig
    {
        /** \brief The map that the robot knows at first; it knows nothing if not set. */
        std::optional<ConfigEntry> knownMap;
        /** \brief World units that the lidar sees. */
        double range{8.0};
        /** \brief Number of its rays, all around. */
        unsigned int rays{720};
        /** \brief World units per second. */
        double speed{1.0};
        /** \brief Seconds between two scans. */
        double period{0.2};
        /** \brief Seconds of planning in each period. */
        double replanTime{0.05};
        /** \brief Seconds of planning without a path after which the robot gives up. */
        double patience{5.0};
        /** \brief Seconds that the robot may take. */
        double timeLimit{1000.0};
    };

    /** \brief Corners of a polygon: x and y. */
    using FootprintCorners = std::vector<std::array<double, 2>>;

    /** \brief A range of the problems of a scenario, which are counted from 0. */
    struct ScenarioIndices
    {
        std::size_t first{0};
        /** \brief All from `first` on if not set. */
        std::size_t last{std::numeric_limits<std::size_t>::max()};
    };

    /** \brief The section [problem]. */
    struct ProblemConfig
    {
        /** \brief The stem of the config's file name if not given. A valid file name, see isFileName(). */
        std::string name;
        /** \brief A mesh, a scene, an OctoMap or a map; the world is empty if it is not given. */
        std::optional<ConfigEntry> world;
        /** \brief Only for maps, where unknown cells are occupied if it is not set. */
        std::optional<Given<maps::UnknownCells>> unknownCells;
        RobotKind robotKind{RobotKind::File};
        /** \brief As written: a file name, or the keyword of another kind. */
        ConfigEntry robot;
        /** \brief Radius of a `disc` or `sphere` robot, world units. */
        double robotRadius{0.0};
        /** \brief Set exactly for a `footprint`, in its own frame and world units. */
        std::optional<Given<FootprintCorners>> footprint;
        /** \brief Distance by which a footprint is enlarged, world units. */
        double padding{0.0};
        /** \brief A MovingAI scenario, whose problems replace the positions of start and goal. */
        std::optional<ConfigEntry> scenario;
        Given<ScenarioIndices> scenarioIndices;
        StateSpaceKind space{StateSpaceKind::SE2};
        /** \brief Turning radius of Dubins and Reeds-Shepp spaces, world units. */
        double turningRadius{1.0};
        /** \brief Weight of the rotation in the distance of SE2 and SE3; OMPL's default (0.5 and 1) if not set. */
        std::optional<double> rotationWeight;
        ConfigPose start;
        ConfigPose goal;
        /** \brief Distance at which a state counts as the goal. */
        double threshold{1e-6};
        /** \brief Empty unless all keys are given; the world's bounding box is used then. */
        std::optional<ConfigVolume> volume;
        /** \brief If empty the problem has no objective: each planner uses its default, and those that do not optimize
            stop at their first path. */
        std::optional<ObjectiveKind> objective;
        /** \brief "FILE:LINE" of the objective, for errors. */
        std::string objectiveOrigin;
        /** \brief Cost at which an optimizing planner may stop; the objective's default if not set. */
        std::optional<double> objectiveThreshold;
        /** \brief Settings of ClearanceCost; the inscribed radius is the robot's if not set. */
        double costScalingFactor{3.0};
        std::optional<double> inscribedRadius;
        double costPenalty{2.0};
        /** \brief objective.weight.NAME, in the order written; nonempty exactly if the objective is `weighted`. */
        std::vector<std::pair<ObjectiveKind, double>> objectiveWeights;
        /** \brief Motions on a map are checked continuously if it is not set, those in other worlds discretely. */
        std::optional<Given<collision::MotionValidation>> motionValidation;
        collision::MeshInterior meshInterior{collision::MeshInterior::Free};
        DriveConfig drive;
        /** \brief For all planners. */
        ContextConfig context;
        /** \brief Only for an arm. */
        ArmConfig arm;
    };

    enum class SavePaths
    {
        None,
        All,
        Shortest
    };

    /** \brief Seconds, some thirty years: can be added to the time of the day by clocks that count nanoseconds. */
    constexpr double LONGEST_TIME_LIMIT = 1e9;

    /** \brief Seconds between two samples of a planner's progress. */
    constexpr double SHORTEST_PROGRESS_INTERVAL = 0.001;

    /** \brief The section [benchmark]. */
    struct CampaignConfig
    {
        /** \brief Seconds per run, at most LONGEST_TIME_LIMIT. */
        double timeLimit{5.0};
        /** \brief Megabytes per run. */
        double memoryLimit{4096.0};
        unsigned int runCount{100};
        /** \brief Folder of the log, with `~` replaced by the home folder; if empty, the folder of the config. */
        std::filesystem::path output;
        SavePaths savePaths{SavePaths::None};
        bool simplify{true};
        /** \brief Seed of the whole campaign, above 0. */
        std::uint_fast32_t seed{1};
        /** \brief Seconds between two samples of the progress properties, at least SHORTEST_PROGRESS_INTERVAL; if not
            set, a 100000th of a time limit of more than 1000 s. */
        double progressInterval{0.01};
        /** \brief Evaluations of the termination condition after which a planner has to stop; 0: no limit. */
        std::uint64_t iterationLimit{0};
    };

    /** \brief One planner instance of the section [planner]. */
    struct PlannerSpec
    {
        /** \brief The planner factory's name for it, in lower case. */
        std::string type;
        /** \brief The name in logs, unique in the config: as given, or else the planner's name, numbered from its
            second instance on. */
        std::string name;
        std::string origin;
        /** \brief As written; createPlanner() checks them against the planner's types. */
        std::vector<ConfigEntry> parameters;
        /** \brief Overrides of the problem's context for this planner. */
        ContextConfig context;
    };

    /** \brief A benchmark config of OMPL.app's `ompl_benchmark`, with the extensions of docs/configs.md. */
    struct BenchmarkConfig
    {
        std::filesystem::path file;
        ProblemConfig problem;
        CampaignConfig benchmark;
        /** \brief In the order of the file. */
        std::vector<PlannerSpec> planners;
    };

    /** \brief Reads \e file. Throws InputError, naming file, line, key, value and what is accepted, for anything
        invalid or unknown; planner parameters are checked by createPlanner(). */
    OMPL_MFA_EXPORT BenchmarkConfig readBenchmarkConfig(const std::filesystem::path &file);

    /** \brief As readBenchmarkConfig(), from a stream; \e file is its name in messages, and its folder is searched for
        files. */
    OMPL_MFA_EXPORT BenchmarkConfig parseBenchmarkConfig(std::istream &in, const std::filesystem::path &file);

    /** \brief The path of a file named in a config. It is searched as given, in the folder of the config, and in the
        folders of the environment variable OMPL_MFA_RESOURCE_DIR (separated by colons). Throws InputError listing these
        places if it is not found. */
    OMPL_MFA_EXPORT std::filesystem::path findResource(const BenchmarkConfig &config, const ConfigEntry &entry);
}  // namespace ompl_mfa::benchmark

#endif
