# Functions that declare all libraries, programs and tests of the project.

# Compiler settings that all targets share. No flag here may change Eigen's alignment (-march=native and the like):
# Eigen types cross the ABI of OMPL and FCL.
function(ompl_mfa_compile_settings target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
    if(OMPL_MFA_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(OMPL_MFA_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${OMPL_MFA_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
        target_link_options(${target} PRIVATE -fsanitize=${OMPL_MFA_SANITIZE})
        # Under AddressSanitizer Eigen would use its own aligned allocation, but libompl, built without, frees memory
        # allocated by this code.
        target_compile_definitions(${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
    endif()
endfunction()

# A lower optimisation level that halves the compile time, for code that is not performance-critical and consists mostly
# of templates of other libraries, such as tests and command lines.
function(ompl_mfa_optimize_lightly target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# ompl_mfa_precompile(<target> <headers>): headers of other libraries that most sources of the target include. Tools
# that parse the sources need CMAKE_DISABLE_PRECOMPILE_HEADERS.
function(ompl_mfa_precompile target)
    # Other compilers are stricter about sharing precompiled headers.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        # Required by ccache for precompiled headers.
        target_compile_options(${target} PRIVATE -fpch-preprocess)
        target_precompile_headers(${target} PRIVATE ${ARGN})
    endif()
endfunction()

# ompl_mfa_add_library(<target> <exported name>): an installed library, to which the folders add their sources.
function(ompl_mfa_add_library target export_name)
    add_library(${target})
    add_library(ompl_mfa::${export_name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES
        EXPORT_NAME ${export_name} VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON INSTALL_RPATH "$ORIGIN")
    target_compile_features(${target} PUBLIC cxx_std_17)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                                         PRIVATE ${PROJECT_SOURCE_DIR}/src)
    ompl_mfa_compile_settings(${target})
    install(TARGETS ${target} EXPORT ompl_mfaTargets
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# ompl_mfa_add_test(<name> SOURCES <files> LIBRARIES <targets> [LABELS <labels>] [TIMEOUT <seconds>]): one GoogleTest
# program, registered with CTest as one test and named <folder>_<what>. The target ompl_mfa_tests builds all of them.
# RapidCheck properties use the same examples in every CTest run; to try others, run a program manually with
# RC_PARAMS="seed=N max_success=1000" in the environment.
function(ompl_mfa_add_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    ompl_mfa_compile_settings(${name})
    target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gtest GTest::gtest_main)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/test)
    target_compile_definitions(${name} PRIVATE OMPL_MFA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    ompl_mfa_optimize_lightly(${name})
    if("${ARG_LIBRARIES}" MATCHES "ompl_mfa(::(ompl_mfa|collision|maps|robots|benchmark)|_cli|_anytime|_paper)")
        target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/test/OmplSeed.cpp)
    endif()
    # Tests that do not link OMPL are compiled without it.
    if(TARGET ompl_mfa_test_headers AND "${ARG_LIBRARIES}" MATCHES "ompl_mfa(::|_cli|_anytime|_paper)")
        target_compile_options(${name} PRIVATE -fpch-preprocess)
        target_precompile_headers(${name} REUSE_FROM ompl_mfa_test_headers)
    endif()
    if(OMPL_MFA_SANITIZE)
        # Only the libraries are instrumented for null pointers; instrumenting tests would double their build time.
        target_compile_options(${name} PRIVATE -fno-sanitize=null,alignment,vptr)
    endif()
    if(NOT TARGET ompl_mfa_tests)
        add_custom_target(ompl_mfa_tests)
    endif()
    add_dependencies(ompl_mfa_tests ${name})
    add_test(NAME ${name} COMMAND ${name})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}"
                                            ENVIRONMENT "RC_PARAMS=seed=1")
endfunction()
