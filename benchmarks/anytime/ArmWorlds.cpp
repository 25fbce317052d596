#include <cmath>

#include "anytime/PlanarArm.h"
#include "anytime/WorldList.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        using Point = Eigen::Vector2d;

        /* Radians. The tip moves by less than the thinnest obstacle between two checked states. */
        constexpr double RESOLUTION = 0.01;
        constexpr double PI = 3.14159265358979323846;

        /* Stretched out to one side; the goal is its mirror image. */
        Eigen::VectorXd startAngles(int links)
        {
            Eigen::VectorXd angles = Eigen::VectorXd::Constant(links, 0.05);
            angles[0] = 1.3;
            return angles;
        }

        /* A bar points at the base from outside and discs lie around it, all between start and goal: the arm folds. */
        Capsules drawObstacles(int links, WorldRandom &random)
        {
            const Eigen::VectorXd start = startAngles(links);
            const Eigen::VectorXd goal = -start;
            const double bar = random.uniform(-0.2, 0.2);
            Capsules obstacles{{0.6 * Point(std::cos(bar), std::sin(bar)), Point(std::cos(bar), std::sin(bar)), 0.02}};
            while (obstacles.size() < 7)
            {
                const double distance = random.uniform(0.55, 0.95);
                const double angle = random.uniform(-1.0, 1.0);
                const Point centre = distance * Point(std::cos(angle), std::sin(angle));
                obstacles.push_back({centre, centre, random.uniform(0.04, 0.08)});
                if (!armIsFree(start.data(), links, obstacles) || !armIsFree(goal.data(), links, obstacles))
                    obstacles.pop_back();
            }
            return obstacles;
        }

        World armWorld(int links, std::uint64_t seed)
        {
            World world;
            world.family = "arm_" + std::to_string(links);
            world.name = world.family + "_" + std::to_string(seed);
            world.make = [links, seed]
            {
                WorldRandom random(seed);
                const Eigen::VectorXd limit = Eigen::VectorXd::Constant(links, PI);
                const Eigen::VectorXd start = startAngles(links);
                return makeProblem(-limit, limit, start, -start, RESOLUTION,
                                   [links, obstacles = drawObstacles(links, random)](const double *angles)
                                   { return armIsFree(angles, links, obstacles); });
            };
            return world;
        }
    }  // namespace

    std::vector<World> armWorlds()
    {
        return {armWorld(7, 1), armWorld(12, 1)};
    }
}  // namespace ompl_mfa::anytime
