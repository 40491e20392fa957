# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_precompile(TARGET [header...]): compiles what nearly every file includes only once
# a target; it is half of the build's time. A file that relies on it without including what
# it needs is found by clang-tidy, which compiles without.
function(endmill_precompile target)
  target_precompile_headers(${target} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
                            <functional> <optional> <span> <string> <vector> ${ARGN})
endfunction()

# endmill_internal_headers(RESULT header...): those with a line `// Internal to ...`.
function(endmill_internal_headers result)
  set(internal)
  foreach(header IN LISTS ARGN)
    file(STRINGS ${header} marker REGEX "^// Internal to " LIMIT_COUNT 1)
    if(marker)
      list(APPEND internal ${header})
    endif()
  endforeach()
  set(${result} ${internal} PARENT_SCOPE)
endfunction()

# endmill_module(NAME [USES module...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...])
#
# Declares src/endmill/NAME as the library endmill::NAME and tests/NAME as its test
# program. USES is the module's complete list of arrows to other modules;
# scripts/check_layers.py fails when an #include follows an arrow not named here. LIBRARIES
# and PRIVATE_LIBRARIES come from packages that endmill_dependency finds. The library is
# installed with its headers, but those with a line `// Internal to ...`.
function(endmill_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;LIBRARIES;PRIVATE_LIBRARIES")
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/endmill/${name}/*.h)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/endmill/${name}/*.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  endmill_internal_headers(internal ${headers})
  list(REMOVE_ITEM headers ${internal})
  list(TRANSFORM arg_USES PREPEND endmill::)

  add_library(endmill_${name} ${sources})
  add_library(endmill::${name} ALIAS endmill_${name})
  target_sources(endmill_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src
                 FILES ${headers})
  target_sources(endmill_${name} PRIVATE FILE_SET internal TYPE HEADERS
                 BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${internal})
  target_compile_features(endmill_${name} PUBLIC cxx_std_20)
  # A fused a b - c d keeps the rounding of one product: its sign would hang on the machine.
  target_compile_options(endmill_${name} PRIVATE -ffp-contract=off)
  target_link_libraries(endmill_${name} PUBLIC ${arg_USES} ${arg_LIBRARIES}
                        PRIVATE ${arg_PRIVATE_LIBRARIES} $<BUILD_INTERFACE:endmill_warnings>)
  set_target_properties(endmill_${name} PROPERTIES EXPORT_NAME ${name}
                        VERIFY_INTERFACE_HEADER_SETS ON)
  endmill_precompile(endmill_${name})
  if(ENDMILL_INSTALL)
    install(TARGETS endmill_${name} EXPORT endmillTargets FILE_SET HEADERS)
  endif()

  if(ENDMILL_BUILD_TESTS AND tests)
    add_executable(endmill_${name}_test ${tests})
    target_link_libraries(endmill_${name}_test PRIVATE endmill::${name} endmill_test_support
                          endmill_warnings GTest::gtest_main)
    target_compile_options(endmill_${name}_test PRIVATE $<$<CONFIG:Release>:-O1>
                           $<$<CONFIG:Asan>:-O0>)
    endmill_precompile(endmill_${name}_test <gtest/gtest.h>)
    gtest_discover_tests(endmill_${name}_test TEST_PREFIX ${name}. PROPERTIES LABELS ${name})
  endif()
endfunction()
