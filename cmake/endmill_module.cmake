# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_precompile(TARGET [header...]): compiles what nearly every file includes only once
# a target; it is half of the build's time. A file that relies on it without including what
# it needs is found by clang-tidy, which compiles without.
function(endmill_precompile target)
  target_precompile_headers(${target} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
                            <functional> <optional> <span> <string> <vector> ${ARGN})
endfunction()

# A fused a b - c d keeps the rounding of one product, so its sign would depend on the machine.
# The Python module is a shared library that holds the modules. Their functions are still
# inlined, because no other library may replace them.
set(ENDMILL_MODULE_OPTIONS -ffp-contract=off -fno-semantic-interposition)

# endmill_precompile_module(TARGET OPTIONS [option...] LIBRARIES [target...]): modules that are
# compiled with the same options share one precompiled header. CGAL brings options of its own.
function(endmill_precompile_module target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OPTIONS;LIBRARIES")
  list(FILTER arg_LIBRARIES INCLUDE REGEX "^CGAL::CGAL$")
  string(MAKE_C_IDENTIFIER "endmill_precompiled${arg_LIBRARIES}${arg_OPTIONS}" owner)
  if(NOT TARGET ${owner})
    file(CONFIGURE OUTPUT ${owner}.cpp CONTENT "" @ONLY)
    add_library(${owner} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp)
    target_compile_features(${owner} PUBLIC cxx_std_20)
    target_compile_options(${owner} PRIVATE ${ENDMILL_MODULE_OPTIONS} ${arg_OPTIONS})
    target_link_libraries(${owner} PRIVATE Eigen3::Eigen ${arg_LIBRARIES} endmill_warnings)
    set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endmill_precompile(${owner})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# endmill_batch(TARGET SIZE file...): the target compiles its files in batches of at most SIZE,
# in which no two files use one name for two things; scripts/batch_sources.py describes the rule.
function(endmill_batch target size)
  if(size EQUAL 1)
    return()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN}
               ${PROJECT_SOURCE_DIR}/scripts/batch_sources.py)
  execute_process(
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/scripts/batch_sources.py ${size} ${ARGN}
    OUTPUT_VARIABLE batches OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" "," batches "${batches}")
  string(REPLACE "\n" ";" batches "${batches}")
  set(number 0)
  foreach(batch IN LISTS batches)
    math(EXPR number "${number} + 1")
    string(REPLACE "," ";" batch "${batch}")
    list(LENGTH batch length)
    if(length GREATER 1)
      set_source_files_properties(${batch} PROPERTIES UNITY_GROUP batch_${number})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

if(PROJECT_IS_TOP_LEVEL)
  set(ENDMILL_SOURCE_BATCH 6 CACHE STRING "Source files that are compiled together; 1: each alone")
else()
  set(ENDMILL_SOURCE_BATCH 1)
endif()

# endmill_module(NAME [USES module...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...]
#                [OPTIONS option...] [TEST_LIBRARIES target...])
#
# Declares src/endmill/NAME as the library endmill::NAME and tests/NAME as its test
# program. USES is the module's complete list of arrows to other modules;
# scripts/check_layers.py fails when an #include follows an arrow not named here. LIBRARIES
# and PRIVATE_LIBRARIES come from packages that endmill_dependency finds. OPTIONS are compiler
# options of the module's sources, TEST_LIBRARIES what only its tests link to.
#
# The headers in src/endmill/NAME and the umbrella src/endmill/NAME.h are installed. The
# folder src/endmill/NAME/detail holds everything else and is not installed.
function(endmill_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;LIBRARIES;PRIVATE_LIBRARIES;OPTIONS;TEST_LIBRARIES")
  set(folder ${PROJECT_SOURCE_DIR}/src/endmill/${name})
  file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.h)
  file(GLOB internal CONFIGURE_DEPENDS ${folder}/detail/*.h)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/detail/*.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  list(APPEND headers ${folder}.h)
  list(TRANSFORM arg_USES PREPEND endmill::)

  add_library(endmill_${name} ${sources})
  add_library(endmill::${name} ALIAS endmill_${name})
  target_sources(endmill_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src
                 FILES ${headers})
  target_sources(endmill_${name} PRIVATE FILE_SET internal TYPE HEADERS
                 BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${internal})
  target_compile_features(endmill_${name} PUBLIC cxx_std_20)
  target_compile_options(endmill_${name} PRIVATE ${ENDMILL_MODULE_OPTIONS} ${arg_OPTIONS})
  target_link_libraries(endmill_${name} PUBLIC ${arg_USES} ${arg_LIBRARIES}
                        PRIVATE ${arg_PRIVATE_LIBRARIES} $<BUILD_INTERFACE:endmill_warnings>)
  set_target_properties(endmill_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
                        VERIFY_INTERFACE_HEADER_SETS ON)
  endmill_precompile_module(endmill_${name} OPTIONS ${arg_OPTIONS} LIBRARIES ${arg_PRIVATE_LIBRARIES})
  endmill_batch(endmill_${name} ${ENDMILL_SOURCE_BATCH} ${sources})
  if(ENDMILL_INSTALL)
    install(TARGETS endmill_${name} EXPORT endmillTargets FILE_SET HEADERS)
  endif()

  if(ENDMILL_BUILD_TESTS AND tests)
    endmill_module_tests(${name} LIBRARIES ${arg_TEST_LIBRARIES} TESTS ${tests})
  endif()
endfunction()
