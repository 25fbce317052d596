#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"

namespace
{
    const std::string START = "start.x = 1\nstart.y = 3\n";

    class Check : public ConfigFixture
    {
    };
}  // namespace

TEST_F(Check, tellsWhereTheStraightMotionIsBlocked)
{
    const ProgramResult result = runProgram("check " + config(START, "prm =\nmfa =\n") + " --json");
    ASSERT_EQ(result.status, 0) << result.err;
    const auto document = nlohmann::json::parse(result.out);
    EXPECT_EQ(document["problem"], "a");
    EXPECT_EQ(document["space"], "R^2");
    EXPECT_EQ(document["obstacles"], 1);
    EXPECT_EQ(document["robot_radius"], 0.5);
    EXPECT_FALSE(document["straight_motion"]["free"]);
    // the disc touches the wall after 3 m of 8 m, and a hundredth of the diagonal is the resolution
    EXPECT_NEAR(document["straight_motion"]["free_fraction"].get<double>(), 3.0 / 8.0, 0.02);
    EXPECT_NEAR(document["straight_motion"]["length"].get<double>(), 8.0, 1e-9);
    ASSERT_EQ(document["planners"].size(), 2U);
    EXPECT_EQ(document["planners"][1]["type"], "mfa");
}

TEST_F(Check, tellsThatTheStraightMotionIsFree)
{
    const std::string file = config("start.x = 1\nstart.y = 7\n");
    std::string text = readFile(file);
    text.replace(text.find("goal.y = 3"), 10, "goal.y = 7");
    write("a.cfg", text);
    const ProgramResult result = runProgram("check " + file);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("straight   free, length 8\n"), std::string::npos) << result.out;
}

TEST_F(Check, triesEveryPlannerOfTheConfig)
{
    expectBadInput("check " + config(START, "prm =\nprm.max_neighbors = 3\n"),
                   {"a.cfg:19", "max_neighbors", "max_nearest_neighbors"});
    expectBadInput("check " + config(START, "rrt =\nrrt.goal_bias = often\n"), {"a.cfg:19", "goal_bias", "often"});
    expectBadInput("check " + config(START, "rrt =\nproblem.sampler = magic\n"), {"a.cfg:19", "sampler", "magic"});
}

TEST_F(Check, refusesEachFaultOfAConfig)
{
    expectBadInput("check " + config("start.x = 1\nstart.y\n"), {"a.cfg:6", "start.y"});
    expectBadInput("check " + config(START + "start.x = 2\n"), {"a.cfg:7", "start.x", "a.cfg:5"});
    expectBadInput("check " + config(START + "threshold = near\n"), {"a.cfg:7", "threshold", "near"});
    expectBadInput("check " + config(START + "control = blimp\n"), {"a.cfg:7", "control", "blimp"});
    expectBadInput("check " + config(START, "", "world = none.dae\n"), {"a.cfg:2", "none.dae"});
    expectBadInput("check " + config(START, "prm =\nprm.name = x\nrrt =\nrrt.name = x\n"), {"a.cfg:20", "x"});
    expectBadInput("check " + path("none.cfg"), {"none.cfg"});
    expectBadInput("check", {"FILE"});
}

TEST_F(Check, refusesEachFaultOfAWorld)
{
    const auto expectFault =
        [this](const std::string &world, const std::string &content, const std::vector<std::string> &words)
    {
        write(world, content);
        std::vector<std::string> all{"a.cfg:2", world};
        all.insert(all.end(), words.begin(), words.end());
        expectBadInput("check " + config(START, "", "world = " + world + "\n"), all);
    };
    const auto scene = [](const std::string &shape, const std::string &orientation)
    {
        return "world:\n  collision_objects:\n    - id: thing\n      primitives: [{" + shape +
               "}]\n      primitive_poses: [{orientation: [" + orientation + "]}]\n";
    };
    expectFault("unreadable.dae", "no XML", {"not a readable mesh"});
    expectFault("empty.stl", "", {"not a readable mesh"});
    expectFault("robot.urdf", "<robot/>", {"unknown kind", ".yaml", ".scene", ".bt", ".dae"});
    expectFault("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"no triangles"});
    expectFault("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", {"not a finite number"});
    expectFault("zero.yaml", scene("type: box, dimensions: [1, 1, 1]", "0, 0, 0, 1e-9"), {":5", "orientation"});
    expectFault("negative.yaml", scene("type: cylinder, dimensions: [1, -0.5]", "0, 0, 0, 1"),
                {":4", "cylinder radius = -0.5"});
    expectFault("unknown.yaml", scene("type: torus, dimensions: [1, 1]", "0, 0, 0, 1"), {":4", "'torus'", "sphere"});
    expectFault("mesh.yaml", "world:\n  collision_objects:\n    - id: thing\n      meshes: [{resource: none.stl}]\n",
                {":4", "none.stl", "not found"});
    expectFault("old.bt", "# OctoMap v0.5\n", {":1", "version 1.0"});
    expectFault("other.ot", "# Octomap OcTree file\nid ColorOcTree\nsize 1\nres 0.1\ndata\n", {"ColorOcTree"});
    expectFault("none.bt", "# Octomap OcTree binary file\nid OcTree\nsize 0\nres 0.1\ndata\n", {"no occupied cell"});
}

TEST_F(Check, warnsOfWhatASceneLeavesUnset)
{
    write("scene.yaml",
          "world:\n  collision_objects:\n  - id: thing\n"
          "    primitives: [{type: sphere, dimensions: [0.1]}, {type: sphere, dimensions: [0.1]}]\n"
          "    primitive_poses: [{orientation: [0, 0, 0, 0]}, {orientation: [0, 0, 0, 0]}]\n");
    const ProgramResult result = runProgram("check " + config(START, "", "world = scene.yaml\n") + " --json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["obstacles"], 2);
    EXPECT_EQ(result.err.find("warning: "), 0U) << result.err;
    EXPECT_NE(result.err.find("scene.yaml:3: object 'thing'"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("'thing'"), result.err.rfind("'thing'")) << result.err;
}

TEST_F(Check, acceptsByteOrderMarksAndAnglesBeyondPi)
{
    const std::string text = readFile(config(START + "start.theta = 3.5\ngoal.theta = -9.75\n"));
    write("a.cfg", "\xEF\xBB\xBF" + text);
    const ProgramResult result = runProgram("check " + path("a.cfg") + " --json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["space"], "SE(2)");
}

TEST(CheckConfigs, everyProblemOfTheProjectIsReady)
{
    unsigned int count = 0;
    for (const auto &entry :
         std::filesystem::directory_iterator(std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks" / "configs"))
    {
        if (entry.path().extension() != ".cfg")
            continue;
        const ProgramResult result = runProgram("check '" + entry.path().string() + "' --json");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_FALSE(nlohmann::json::parse(result.out)["straight_motion"]["free"]) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 12U);
}

TEST(CheckConfigs, worldsAreWhatTheirScriptWrites)
{
    const std::filesystem::path worlds = std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks" / "worlds";
    if (std::system("python3 --version >/dev/null 2>&1") != 0)  // NOLINT(bugprone-command-processor): a fixed command
        GTEST_SKIP() << "python3 is not there";
    const std::filesystem::path copy = temporaryFile("worlds");
    std::filesystem::create_directories(copy);
    std::filesystem::copy(worlds / "make_worlds.py", copy);
    const std::string command = "python3 '" + (copy / "make_worlds.py").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor): the test's own file
    unsigned int count = 0;
    for (const auto &entry : std::filesystem::directory_iterator(copy))
    {
        if (entry.path().filename() != "make_worlds.py")
        {
            EXPECT_EQ(readFile(entry.path().string()), readFile((worlds / entry.path().filename()).string()))
                << entry.path().filename();
            ++count;
        }
    }
    EXPECT_GE(count, 10U);
    std::filesystem::remove_all(copy);
}
