#ifndef OMPL_MFA_ENGINE_GUIDES_GUIDE_PART_
#define OMPL_MFA_ENGINE_GUIDES_GUIDE_PART_

#include "engine/SearchPart.h"

namespace ompl_mfa
{
    /** \brief A part that finds paths of all homotopy classes, those included that fireflies on straight axes cannot
        express. */
    class GuidePart : public SearchPart
    {
    public:
        using SearchPart::SearchPart;

        void advance(std::uint64_t work, Findings &findings) final;

        /** \brief Searches for about \e work units of PathEvaluator::work(). Returns true as soon as it has a path,
           then in \e path, from one of the query's starts to one of its goals with all motions checked; the next call
           goes on from there. \e bound is the cost that a path should beat in the end (infinite before there is one).
         */
        virtual bool search(double bound, std::uint64_t work, Waypoints &path) = 0;
    };
}  // namespace ompl_mfa

#endif
