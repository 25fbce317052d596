#ifndef OMPL_MFA_ENGINE_PART_REGISTRY_
#define OMPL_MFA_ENGINE_PART_REGISTRY_

#include <memory>
#include <vector>

#include <ompl/base/Planner.h>

#include "engine/SearchPart.h"

namespace ompl_mfa
{
    class Swarms;

    /** \brief The parts of a search, in the order of PartKind. */
    struct PartList
    {
        std::vector<std::unique_ptr<SearchPart>> parts;
        PathRefiner *refiner{nullptr};   ///< one of parts, or null
        std::shared_ptr<Swarms> swarms;  ///< of the parts that have fireflies; may be null
        bool guided{false};              ///< whether there are parts beside the fireflies that find first paths
    };

    /** \brief The parts that the settings of \e context name, and a guest planner unless \e guest is null. The paper's
        algorithm is one part: fireflies whose coordinates are offsets. Throws ompl::Exception where no part can find a
        first path, or if \e guest returns no planner. */
    PartList makeParts(const SearchContext &context, const ompl::base::PlannerAllocator &guest);
}  // namespace ompl_mfa

#endif
