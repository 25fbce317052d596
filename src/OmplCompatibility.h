/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

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
