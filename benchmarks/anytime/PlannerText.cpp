#include "anytime/PlannerText.h"

#include <sstream>

#include "OmplCompatibility.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        std::vector<std::string> split(const std::string &text, char separator)
        {
            std::vector<std::string> parts;
            std::istringstream in(text);
            for (std::string part; std::getline(in, part, separator);)
                parts.push_back(part);
            return parts;
        }

        [[noreturn]] void failForm(const std::string &text, const std::string &part)
        {
            throw InputError("--planners '" + text + "': expected PLANNER:KEY=VALUE,... and found '" + part + "'");
        }
    }  // namespace

    std::vector<std::string> peers()
    {
        std::vector<std::string> names{"rrtstar", "informedrrtstar",      "prmstar", "bitstar", "abitstar",
                                       "aitstar", "anytimepathshortening"};
#ifdef OMPL_MFA_HAS_EITSTAR
        names.emplace_back("eitstar");
#endif
#ifdef OMPL_MFA_HAS_BLITSTAR
        names.emplace_back("blitstar");
#endif
#ifdef OMPL_MFA_HAS_AORRTC
        names.emplace_back("aorrtc");
#endif
        names.emplace_back("rrtconnect");
        return names;
    }

    std::vector<std::string> splitPlanners(const std::string &text)
    {
        std::vector<std::string> planners;
        for (const std::string &part : split(text, ','))
        {
            const bool isParameter = part.find('=') != std::string::npos && part.find(':') == std::string::npos;
            if (isParameter && !planners.empty() && planners.back().find(':') != std::string::npos)
                planners.back() += "," + part;
            else if (part == "peers")
            {
                const auto all = peers();
                planners.insert(planners.end(), all.begin(), all.end());
            }
            else
                planners.push_back(part);
        }
        if (planners.empty())
            throw InputError("--planners '" + text + "': expected PLANNER[:KEY=VALUE,...],...");
        return planners;
    }

    PlannerSpec parsePlanner(const std::string &text)
    {
        const std::string origin = "--planners";
        const std::size_t colon = text.find(':');
        PlannerSpec spec;
        spec.type = text.substr(0, colon);
        spec.name = text;
        spec.origin = origin;
        requireKnownPlanner(spec.type, origin);
        if (colon == std::string::npos)
            return spec;
        for (const std::string &part : split(text.substr(colon + 1), ','))
        {
            const std::size_t equals = part.find('=');
            if (equals == std::string::npos || equals == 0)
                failForm(text, part);
            spec.parameters.push_back({part.substr(0, equals), part.substr(equals + 1), origin});
        }
        return spec;
    }
}  // namespace ompl_mfa::anytime
