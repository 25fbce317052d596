#ifndef OMPL_MFA_ENGINE_STREAMS_
#define OMPL_MFA_ENGINE_STREAMS_

#include <cstdint>

#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa
{
    /** \brief Every stream of random numbers in a run. What draws numbers has a stream of its own here, so that no two
        parts of a run draw the same ones, nor do two runs with different seeds. */
    enum class Stream : std::uint64_t
    {
        // of a run
        Trees,          ///< TreeGuide
        Roadmap,        ///< RoadmapGuide
        Tightening,     ///< PathTightening of the best path
        NewTightening,  ///< PathTightening of new paths
        Windows,        ///< which windows are opened
        WindowSwarm,    ///< the swarm of the window with this index
        Swarm,          ///< the swarm on the straight axis with this index
        Detours,        ///< the detour with this index that is held against the objective's bounds
        GoalSearch,     ///< the search for states that satisfy a goal

        // of a swarm, or of a search for goals
        Epoch,         ///< the fireflies of the epoch with this index
        Recombination  ///< fresh states for recombination
    };

    /** \brief The seed of \e stream: of the \e index-th where there are several. \e seed is that of the run, or of the
        swarm or goal search that the stream belongs to. */
    inline std::uint64_t streamSeed(std::uint64_t seed, Stream stream, std::uint64_t index = 0)
    {
        return deriveSeed(seed, static_cast<std::uint64_t>(stream), index);
    }
}  // namespace ompl_mfa

#endif
