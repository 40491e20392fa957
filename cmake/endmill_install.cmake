# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` leaves behind: the program, the libraries endmill::<module> with
# their headers, and a package for find_package(endmill). Nothing in it names the place
# where it was built or installed, so that it can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# endmill_dependency(PACKAGE [argument...]): finds a package that a module links to, as
# find_package does, and has the installed package find it too: who links to a static
# library must also link to what it keeps private.
macro(endmill_dependency)
  find_package(${ARGV} REQUIRED)
  string(JOIN " " endmill_dependency_arguments ${ARGV})
  string(APPEND ENDMILL_FIND_DEPENDENCIES "find_dependency(${endmill_dependency_arguments})\n")
endmacro()

# endmill_install(): all but the modules, which endmill_module installs. Call it last.
function(endmill_install)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/endmill)
  install(EXPORT endmillTargets NAMESPACE endmill:: DESTINATION ${package_folder})
  configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/endmillConfig.cmake.in ${PROJECT_BINARY_DIR}/endmillConfig.cmake
    INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/endmillConfigVersion.cmake
                                   COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/endmillConfig.cmake
                ${PROJECT_BINARY_DIR}/endmillConfigVersion.cmake DESTINATION ${package_folder})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
  if(TARGET endmill)
    install(TARGETS endmill)
    endmill_install_manual()
    foreach(kind IN ITEMS cad controls jobs machines materials meshes surfaces sweeps tools)
      install(DIRECTORY ${PROJECT_SOURCE_DIR}/datasets/${kind} DESTINATION ${CMAKE_INSTALL_DATADIR}/endmill)
    endforeach()
  endif()
endfunction()
