#include "anytime/WorldList.h"

#include <cstdlib>
#include <iterator>
#include <regex>
#include <utility>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        std::filesystem::path omplAppFolder()
        {
            const char *folder = std::getenv("OMPL_MFA_OMPLAPP_DIR");
            return folder != nullptr ? folder : std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "../shared/omplapp";
        }

        std::regex compile(const std::string &pattern)
        {
            try
            {
                return std::regex(pattern);
            }
            catch (const std::regex_error &error)
            {
                throw InputError("--worlds '" + pattern + "': expected a regular expression: " + error.what());
            }
        }
    }  // namespace

    std::vector<World> allWorlds()
    {
        std::vector<World> worlds = circleWorlds();
        const auto append = [&worlds](std::vector<World> more)
        { std::move(more.begin(), more.end(), std::back_inserter(worlds)); };
        append(boxWorlds());
        append(armWorlds());
        append(configWorlds(std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks/configs", "own_"));
        append(omplAppWorlds(omplAppFolder()));
        return worlds;
    }

    std::vector<World> selectWorlds(const std::string &pattern)
    {
        const std::regex expression = compile(pattern);
        std::vector<World> selected;
        for (auto &world : allWorlds())
        {
            if (std::regex_search(world.name, expression))
                selected.push_back(std::move(world));
        }
        if (selected.empty())
            throw InputError("--worlds '" + pattern + "': no world has such a name; `ompl_mfa_anytime list` names all");
        return selected;
    }
}  // namespace ompl_mfa::anytime
