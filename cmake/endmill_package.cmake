# SPDX-License-Identifier: GPL-3.0-or-later
# The manual page, the bash completion, and the Debian package: build the target `package`.

# endmill_install_manual(): writes both from the helps of the program, and installs them.
function(endmill_install_manual)
  find_program(ENDMILL_PYTHON python3)
  if(NOT ENDMILL_PYTHON)
    message(STATUS "Manual page and completion are left out: python3 is missing")
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/manual)
  file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scripts/manual/*.py)
  add_custom_command(
    OUTPUT ${folder}/endmill.1 ${folder}/endmill
    COMMAND ${ENDMILL_PYTHON} ${PROJECT_SOURCE_DIR}/scripts/write_manual.py $<TARGET_FILE:endmill> ${folder}
    DEPENDS endmill ${PROJECT_SOURCE_DIR}/scripts/write_manual.py ${scripts}
    COMMENT "Writing manual page and bash completion")
  add_custom_target(endmill_manual ALL DEPENDS ${folder}/endmill.1 ${folder}/endmill)
  install(FILES ${folder}/endmill.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${folder}/endmill DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endfunction()

# endmill_package(): a Debian package of all that is installed. The program's libraries are
# dependencies, found by dpkg-shlibdeps; those that only a user of the C++ libraries needs are
# suggested. Call it last, at the top level.
macro(endmill_package)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME endmill)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
  set(CPACK_PACKAGE_DESCRIPTION
      "Plans, simulates, trims and posts tool paths: a program and C++20 libraries.")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The endmill authors")
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  string(JOIN ", " CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev (>= 3.4)" libboost-dev
         "libcgal-dev (>= 5.5)" nlohmann-json3-dev libopenmesh-dev libssl-dev)
  include(CPack)
endmacro()
