#include "engine/SearchPart.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa
{
    namespace
    {
        /* Dimensions beyond which the roadmap has less of the time, and below which more, but no more than so many
           times as much. */
        constexpr double ROADMAP_DIMENSIONS = 3.0;
        constexpr double MOST_ROADMAP = 1.5;
    }  // namespace

    Waypoints replaceSegment(const Waypoints &path, std::size_t first, std::size_t last, const Waypoints &segment)
    {
        Waypoints whole(path.space());
        for (std::size_t i = 0; i < first; ++i)
            whole.append(path[i]);
        for (std::size_t i = 0; i < segment.size(); ++i)
            whole.append(segment[i]);
        for (std::size_t i = last + 1; i < path.size(); ++i)
            whole.append(path[i]);
        return whole;
    }

    SearchPart::SearchPart(PartKind kind, const SearchContext &context)
      : kind_(kind)
      , context_(context)
    {
    }

    void SearchPart::improved(const Proposal & /*proposal*/)
    {
    }

    void SearchPart::explain(SearchGraph & /*graph*/) const
    {
    }

    void SearchPart::propose(Waypoints path, Findings &findings) const
    {
        findings.paths.push_back({std::move(path), std::nullopt, Proposal::Stage::Raw, kind_});
    }

    double roadmapFactor(const StateChart &chart)
    {
        return std::min(MOST_ROADMAP, ROADMAP_DIMENSIONS / static_cast<double>(chart.dimension()));
    }
}  // namespace ompl_mfa
