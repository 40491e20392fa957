# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_precompile(TARGET [header...]): compiles what nearly every file includes only once
# a target; it is half of the build's time. A file that relies on it without including what
# it needs is found by clang-tidy, which compiles without.
function(endmill_precompile target)
  target_precompile_headers(${target} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
                            <functional> <optional> <span> <string> <vector> ${ARGN})
endfunction()

# endmill_module(NAME [USES module...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...])
#
# Declares src/endmill/NAME as the library endmill::NAME and tests/NAME as its test
# program. USES is the module's complete list of arrows to other modules;
# scripts/check_layers.py fails when an #include follows an arrow not named here.
function(endmill_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;LIBRARIES;PRIVATE_LIBRARIES")
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/endmill/${name}/*.h)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/endmill/${name}/*.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  list(TRANSFORM arg_USES PREPEND endmill::)

  add_library(endmill_${name} ${sources})
  add_library(endmill::${name} ALIAS endmill_${name})
  target_sources(endmill_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src
                 FILES ${headers})
  target_compile_features(endmill_${name} PUBLIC cxx_std_20)
  target_link_libraries(endmill_${name} PUBLIC ${arg_USES} ${arg_LIBRARIES}
                        PRIVATE ${arg_PRIVATE_LIBRARIES} endmill_warnings)
  set_target_properties(endmill_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
  endmill_precompile(endmill_${name})

  if(ENDMILL_BUILD_TESTS AND tests)
    add_executable(endmill_${name}_test ${tests})
    target_link_libraries(endmill_${name}_test PRIVATE endmill::${name} endmill_test_support
                          endmill_warnings GTest::gtest_main)
    target_compile_options(endmill_${name}_test PRIVATE $<$<CONFIG:Release>:-O1>)
    endmill_precompile(endmill_${name}_test <gtest/gtest.h>)
    gtest_discover_tests(endmill_${name}_test TEST_PREFIX ${name}. PROPERTIES LABELS ${name})
  endif()
endfunction()
