# SPDX-License-Identifier: GPL-3.0-or-later
# Packages of npm: three.js for the page of `endmill view`, a driver of browsers for its tests.
find_program(ENDMILL_NPM npm)

# endmill_fetch_modules(SOURCE FOLDER FAILURE): fetches the packages of SOURCE/package-lock.json into
# FOLDER/node_modules, once for each version of that file. Their scripts are not run. The variable
# FAILURE receives the reason if there is one, else it is empty.
function(endmill_fetch_modules source folder failure)
  set(${failure} "" PARENT_SCOPE)
  set(lock ${source}/package-lock.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lock})
  file(SHA256 ${lock} wanted)
  set(fetched "")
  if(EXISTS ${folder}/node_modules/fetched)
    file(READ ${folder}/node_modules/fetched fetched)
  endif()
  if(fetched STREQUAL wanted)
    return()
  endif()
  if(NOT ENDMILL_NPM)
    set(${failure} "no npm (scripts/setup.sh page)" PARENT_SCOPE)
    return()
  endif()
  file(COPY ${lock} ${source}/package.json DESTINATION ${folder})
  execute_process(COMMAND ${ENDMILL_NPM} ci --ignore-scripts --no-audit --no-fund
                  WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE said)
  if(failed)
    set(${failure} "npm cannot fetch the packages of ${lock}\n${said}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${folder}/node_modules/fetched ${wanted})
endfunction()
