#ifndef OMPL_MFA_OMPL_COMPATIBILITY_
#define OMPL_MFA_OMPL_COMPATIBILITY_

/* The differences between OMPL 1.5.2 and newer releases, through 2.0. Nothing else in the project asks for OMPL's
   version. */

#include <ompl/config.h>

#endif
