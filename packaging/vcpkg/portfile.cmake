# Not tried: the project has been built with Debian's packages only.
set(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../..)
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES collision OMPL_MFA_BUILD_COLLISION)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH}
                      OPTIONS ${FEATURE_OPTIONS} -DOMPL_MFA_BUILD_BENCHMARK=OFF -DOMPL_MFA_BUILD_TESTS=OFF
                              -DOMPL_MFA_BUILD_DEMOS=OFF -DOMPL_MFA_BUILD_PAGMO=OFF -DOMPL_MFA_BUILD_STUDY=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/ompl_mfa)
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)
