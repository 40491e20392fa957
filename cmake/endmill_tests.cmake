# SPDX-License-Identifier: GPL-3.0-or-later
# The test program of a module: tests/NAME/*_test.cpp. Two measures halve its compile time:
# test files are compiled in batches, and all programs share one precompiled header. The target
# endmill_tests builds all of them; they are no part of the target all.

set(ENDMILL_TEST_BATCH 8 CACHE STRING "Test files that are compiled together; 1: each alone")

# endmill_test_options(TARGET): how every test program is compiled.
function(endmill_test_options target)
  target_link_libraries(${target} PRIVATE endmill_test_support endmill_warnings GTest::gtest_main
                        GTest::gmock)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Asan>:-O0>)
endfunction()

# endmill_precompile_tests(): declares endmill_tests and the owner of the shared header.
function(endmill_precompile_tests)
  add_custom_target(endmill_tests)
  file(CONFIGURE OUTPUT test_precompiled.cpp CONTENT "" @ONLY)
  add_library(endmill_test_precompiled OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/test_precompiled.cpp)
  target_compile_features(endmill_test_precompiled PUBLIC cxx_std_20)
  target_link_libraries(endmill_test_precompiled PRIVATE Eigen3::Eigen)
  endmill_test_options(endmill_test_precompiled)
  endmill_precompile(endmill_test_precompiled <gtest/gtest.h> <gmock/gmock.h>)
endfunction()

# endmill_module_tests(NAME LIBRARIES target... TESTS file...)
function(endmill_module_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;TESTS")
  set(target endmill_${name}_test)
  add_executable(${target} EXCLUDE_FROM_ALL ${arg_TESTS})
  add_dependencies(endmill_tests ${target})
  endmill_batch(${target} ${ENDMILL_TEST_BATCH} ${arg_TESTS})
  target_link_libraries(${target} PRIVATE endmill::${name} ${arg_LIBRARIES})
  endmill_test_options(${target})
  if(arg_LIBRARIES MATCHES "CGAL")
    # CGAL's compiler options differ from those of the shared header.
    endmill_precompile(${target} <gtest/gtest.h> <gmock/gmock.h>)
  else()
    target_precompile_headers(${target} REUSE_FROM endmill_test_precompiled)
  endif()
  gtest_discover_tests(${target} TEST_PREFIX ${name}. PROPERTIES LABELS ${name})
endfunction()
