# Defines ompl_mfa::ompl, the OMPL that this project links, and OMPL_MFA_OMPL_VERSION.
#
# OMPL 1.6 and newer export ompl::ompl. OMPL 1.5 only sets variables, and Debian's OMPL_LIBRARIES lists development
# files of packages that may not be installed: only the libompl entry is kept.
find_package(ompl REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(Boost REQUIRED)
find_package(Threads REQUIRED)
set(OMPL_MFA_OMPL_VERSION "${OMPL_VERSION}")

if(NOT TARGET ompl_mfa::ompl)
    add_library(ompl_mfa::ompl INTERFACE IMPORTED)
    if(TARGET ompl::ompl)
        target_link_libraries(ompl_mfa::ompl INTERFACE ompl::ompl)
    else()
        set(_ompl_library "${OMPL_LIBRARIES}")
        list(FILTER _ompl_library INCLUDE REGEX "libompl")
        target_link_libraries(ompl_mfa::ompl INTERFACE "${_ompl_library}")
        target_include_directories(ompl_mfa::ompl SYSTEM INTERFACE "${OMPL_INCLUDE_DIRS}")
    endif()
    target_link_libraries(ompl_mfa::ompl INTERFACE Eigen3::Eigen Boost::headers Threads::Threads)
endif()
