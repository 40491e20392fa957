# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_use_fast_linker(TARGET): programs that link to the interface library TARGET are
# linked by mold or lld where one of them is installed. Both need a third of the time of ld.
include(CheckLinkerFlag)

function(endmill_use_fast_linker target)
  foreach(linker IN ITEMS mold lld)
    check_linker_flag(CXX -fuse-ld=${linker} ENDMILL_LINKS_WITH_${linker})
    if(ENDMILL_LINKS_WITH_${linker})
      target_link_options(${target} INTERFACE -fuse-ld=${linker})
      return()
    endif()
  endforeach()
endfunction()
