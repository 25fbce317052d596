include(CMakePackageConfigHelpers)
set(OMPL_MFA_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ompl_mfa)

install(DIRECTORY include/ompl_mfa DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT ompl_mfaTargets NAMESPACE ompl_mfa:: DESTINATION ${OMPL_MFA_CMAKE_DIR})
configure_package_config_file(cmake/ompl_mfaConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfig.cmake
                              INSTALL_DESTINATION ${OMPL_MFA_CMAKE_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ompl_mfaConfigVersion.cmake
              cmake/OmplTarget.cmake
        DESTINATION ${OMPL_MFA_CMAKE_DIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
