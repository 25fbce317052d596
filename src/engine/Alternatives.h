#ifndef OMPL_MFA_ENGINE_ALTERNATIVES_
#define OMPL_MFA_ENGINE_ALTERNATIVES_

#include <cstddef>
#include <vector>

#include "path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief The last few tightened paths that were a little worse than the best one: as a rule paths of other
        homotopy classes. */
    class Alternatives
    {
    public:
        /** \brief A path is kept if its cost is at most this many times the best one. */
        static constexpr double SLACK = 1.1;

        /** \brief Keeps \e path, in the place of the oldest where there are three. */
        void add(const Waypoints &path);

        std::size_t size() const
        {
            return paths_.size();
        }

        const Waypoints &operator[](std::size_t i) const
        {
            return paths_[i];
        }

    private:
        std::vector<Waypoints> paths_;
        std::size_t next_{0};
    };
}  // namespace ompl_mfa

#endif
