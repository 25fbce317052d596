include(CMakePackageConfigHelpers)
set(OMPL_MFA_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ompl_mfa)

# The headers of the libraries that are built, one folder per library.
set(OMPL_MFA_HEADERS include/ompl_mfa/optimizer include/ompl_mfa/planner)
foreach(room pagmo collision maps robots benchmark)
    if(TARGET ompl_mfa_${room})
        list(APPEND OMPL_MFA_HEADERS include/ompl_mfa/${room})
    endif()
endforeach()
install(DIRECTORY ${OMPL_MFA_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ompl_mfa FILES_MATCHING PATTERN "*.h")
file(GLOB OMPL_MFA_COMMON_HEADERS include/ompl_mfa/*.h)
install(FILES ${OMPL_MFA_COMMON_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ompl_mfa)
install(EXPORT ompl_mfaTargets NAMESPACE ompl_mfa:: DESTINATION ${OMPL_MFA_CMAKE_DIR})
configure_package_config_file(cmake/ompl_mfaConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfig.cmake
                              INSTALL_DESTINATION ${OMPL_MFA_CMAKE_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfigVersion.cmake
              cmake/OmplTarget.cmake
        DESTINATION ${OMPL_MFA_CMAKE_DIR})

# ompl_mfa_pkg_config(<target> <description> REQUIRES <packages> LIBS <flags> CFLAGS <flags>): the file for pkg-config of
# a library. It finds its prefix by its own place.
file(RELATIVE_PATH OMPL_MFA_PKG_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
function(ompl_mfa_pkg_config target description)
    cmake_parse_arguments(PKG "" "" "REQUIRES;LIBS;CFLAGS" ${ARGN})
    foreach(list REQUIRES LIBS CFLAGS)
        list(JOIN PKG_${list} " " PKG_${list})
    endforeach()
    set(PKG_TARGET ${target})
    set(PKG_DESCRIPTION ${description})
    configure_file(${PROJECT_SOURCE_DIR}/cmake/package.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${target}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# OMPL's own ompl.pc is not used: Debian's asks for libraries of Boost that its development package does not depend on.
if(TARGET ompl::ompl)
    get_target_property(OMPL_MFA_OMPL_LIBRARY ompl::ompl LOCATION)
    get_target_property(OMPL_MFA_OMPL_INCLUDE ompl::ompl INTERFACE_INCLUDE_DIRECTORIES)
else()
    set(OMPL_MFA_OMPL_LIBRARY ${OMPL_LIBRARIES})
    list(FILTER OMPL_MFA_OMPL_LIBRARY INCLUDE REGEX "libompl")
    set(OMPL_MFA_OMPL_INCLUDE ${OMPL_INCLUDE_DIRS})
endif()
list(TRANSFORM OMPL_MFA_OMPL_INCLUDE PREPEND -I)
list(REMOVE_ITEM OMPL_MFA_OMPL_INCLUDE -I/usr/include)
ompl_mfa_pkg_config(ompl_mfa "${PROJECT_DESCRIPTION}" REQUIRES eigen3 LIBS ${OMPL_MFA_OMPL_LIBRARY} -pthread
                    CFLAGS ${OMPL_MFA_OMPL_INCLUDE})
if(TARGET ompl_mfa_collision)
    ompl_mfa_pkg_config(ompl_mfa_collision "Collision checking with FCL for OMPL" REQUIRES ompl_mfa fcl assimp octomap yaml-cpp)
endif()
if(TARGET ompl_mfa_maps)
    ompl_mfa_pkg_config(ompl_mfa_maps "Robots on occupancy grids for OMPL" REQUIRES ompl_mfa yaml-cpp GraphicsMagick)
endif()
if(TARGET ompl_mfa_robots)
    ompl_mfa_pkg_config(ompl_mfa_robots "Robot arms for OMPL"
                        REQUIRES ompl_mfa_collision urdfdom tinyxml2)
endif()
if(TARGET ompl_mfa_benchmark)
    ompl_mfa_pkg_config(ompl_mfa_benchmark "OMPL benchmark configs, campaigns and logs"
                        REQUIRES ompl_mfa_robots ompl_mfa_maps sqlite3)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
