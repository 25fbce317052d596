include(CMakePackageConfigHelpers)
set(OMPL_MFA_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ompl_mfa)

# The headers of the libraries that are built, one folder per library.
set(OMPL_MFA_HEADERS include/ompl_mfa/optimizer include/ompl_mfa/planner)
foreach(room pagmo collision maps benchmark)
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
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
