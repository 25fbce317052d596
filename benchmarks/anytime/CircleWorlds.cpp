#include <utility>

#include "anytime/WorldList.h"
#include "oracle/ShortestPath.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        constexpr int CIRCLES = 70;
        constexpr double RESOLUTION = 0.001;
        /* The best class is narrow when discs grown by this much close it ... */
        constexpr double NARROW = 0.004;
        /* ... and the way that is left then is longer by this factor. */
        constexpr double DETOUR = 1.02;

        oracle::Point start()
        {
            return {0.05, 0.5};
        }

        oracle::Point goal()
        {
            return {0.95, 0.5};
        }

        oracle::Scene drawScene(WorldRandom &random)
        {
            oracle::Scene scene;
            scene.lower = {0.0, 0.0};
            scene.upper = {1.0, 1.0};
            while (static_cast<int>(scene.obstacles.size()) < CIRCLES)
            {
                const double radius = random.uniform(0.02, 0.06);
                const double x = random.uniform(0.0, 1.0);
                const oracle::Point centre(x, random.uniform(0.0, 1.0));
                if ((centre - start()).norm() > radius + 0.02 && (centre - goal()).norm() > radius + 0.02)
                    scene.obstacles.push_back(oracle::disc(centre, radius));
            }
            return scene;
        }

        bool hasNarrowBestClass(oracle::Scene scene)
        {
            const double shortest = oracle::shortestPath(scene, start(), goal()).length;
            scene.robotRadius = NARROW;
            const double withMargin = oracle::shortestPath(scene, start(), goal()).length;
            return withMargin > DETOUR * shortest && withMargin < 2.0;
        }

        /* \e seed is one that hasNarrowBestClass(), found once by going through all from 1. */
        oracle::Scene makeScene(std::uint64_t seed)
        {
            WorldRandom random(seed);
            return drawScene(random);
        }

        Problem makeCircleProblem(std::uint64_t seed)
        {
            std::vector<double> circles;  // x, y and squared radius of each
            for (const auto &disc : makeScene(seed).obstacles)
                circles.insert(circles.end(),
                               {disc.vertices[0].x(), disc.vertices[0].y(), disc.radius * disc.radius});
            const auto isFree = [circles = std::move(circles)](const double *x)
            {
                for (std::size_t i = 0; i < circles.size(); i += 3)
                {
                    const double dx = x[0] - circles[i];
                    const double dy = x[1] - circles[i + 1];
                    if (dx * dx + dy * dy < circles[i + 2])
                        return false;
                }
                return true;
            };
            return makeProblem(Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones(), start(), goal(), RESOLUTION, isFree);
        }
    }  // namespace

    std::vector<std::uint64_t> narrowCircleSeeds(std::uint64_t last)
    {
        std::vector<std::uint64_t> seeds;
        for (std::uint64_t seed = 1; seed <= last; ++seed)
        {
            if (hasNarrowBestClass(makeScene(seed)))
                seeds.push_back(seed);
        }
        return seeds;
    }

    std::vector<World> circleWorlds()
    {
        std::vector<World> worlds;
        for (const std::uint64_t seed : {1, 2, 3})
        {
            World world;
            world.family = "circles_narrow_2d";
            world.name = world.family + "_" + std::to_string(seed);
            world.make = [seed] { return makeCircleProblem(seed); };
            world.optimum = [seed] { return oracle::shortestPath(makeScene(seed), start(), goal()).length; };
            worlds.push_back(std::move(world));
        }
        return worlds;
    }
}  // namespace ompl_mfa::anytime
