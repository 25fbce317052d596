#ifndef OMPL_MFA_OMPL_COMPATIBILITY_
#define OMPL_MFA_OMPL_COMPATIBILITY_

/* The differences between OMPL 1.5.2 and newer releases, through 2.0. Nothing else in the project asks for OMPL's
   version. */

#include <memory>

#include <ompl/config.h>

/* Planners that only some releases have. */
#if __has_include(<ompl/geometric/planners/informedtrees/EITstar.h>)
#define OMPL_MFA_HAS_EITSTAR
#endif
#if __has_include(<ompl/geometric/planners/informedtrees/EIRMstar.h>)
#define OMPL_MFA_HAS_EIRMSTAR
#endif
#if __has_include(<ompl/geometric/planners/lazyinformedtrees/BLITstar.h>)
#define OMPL_MFA_HAS_BLITSTAR
#endif
#if __has_include(<ompl/geometric/planners/rrt/AORRTC.h>)
#define OMPL_MFA_HAS_AORRTC
#include <ompl/geometric/planners/rrt/AORRTC.h>
#endif
#if __has_include(<ompl/geometric/planners/rrt/AOXRRTConnect.h>)
#define OMPL_MFA_HAS_AOXRRTCONNECT
#endif
#if __has_include(<ompl/geometric/planners/rrt/ATRRT.h>)
#define OMPL_MFA_HAS_ATRRT
#endif
#if __has_include(<ompl/geometric/planners/rrt/TRRTstar.h>)
#define OMPL_MFA_HAS_TRRTSTAR
#endif
#if __has_include(<ompl/geometric/planners/quotientspace/QRRT.h>)
#define OMPL_MFA_HAS_QUOTIENT_SPACES
#elif __has_include(<ompl/multilevel/planners/qrrt/QRRT.h>)
#define OMPL_MFA_HAS_MULTILEVEL
#endif

#ifdef OMPL_MFA_HAS_AORRTC
namespace ompl_mfa
{
    /** \brief AORRTC that may be cleared and destroyed before it was set up: OMPL 2.0.2's own crashes then, because
        only setup() makes the search that it clears. */
    class ClearableAORRTC : public ompl::geometric::AORRTC
    {
    public:
        explicit ClearableAORRTC(const ompl::base::SpaceInformationPtr &si)
          : AORRTC(si)
        {
            aox_planner = std::make_shared<ompl::geometric::AOXRRTConnect>(si);
        }
    };
}  // namespace ompl_mfa
#endif

#endif
