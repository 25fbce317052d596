#ifndef OMPL_MFA_ENGINE_STRAIGHT_MOTIONS_
#define OMPL_MFA_ENGINE_STRAIGHT_MOTIONS_

#include "engine/EndPairs.h"
#include "engine/SearchContext.h"
#include "engine/SearchPart.h"

namespace ompl_mfa
{
    /** \brief Tries the straight motion from every start to every goal, before anything else is searched. */
    class StraightMotions
    {
    public:
        /** \brief Without guides (\e guided) a straight motion that is not valid serves as partial path at once, as far
            as it leads; else once the guides have not found a path soon. \e context outlives the object. */
        StraightMotions(const SearchContext &context, bool guided);

        /** \brief Tries the motions of the pairs that are new until one is valid. One that the stop condition cut short
            is tried again by the next call. */
        void advance(Findings &findings);

    private:
        void followFirst();
        Waypoints path(const ompl::base::State *start, const ompl::base::State *goal) const;

        const SearchContext &context_;
        bool guided_;
        EndPairs pairs_;
        bool followed_{false};  ///< whether the first straight motion has served as partial path
    };
}  // namespace ompl_mfa

#endif
