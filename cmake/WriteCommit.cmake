# Writes a source file that knows the commit; leaves it alone if it is right already, so that nothing is compiled for
# nothing.   cmake -DSOURCE=<repository> -DOUTPUT=<file> -P WriteCommit.cmake
set(commit unknown)
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=7 HEAD
    OUTPUT_VARIABLE found RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(result EQUAL 0)
    set(commit ${found})
    execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD RESULT_VARIABLE changed ERROR_QUIET)
    if(NOT changed EQUAL 0)
      string(APPEND commit "+")
    endif()
  endif()
endif()
set(text "// Written by cmake/WriteCommit.cmake.
#include \"apps/version.h\"

const char* murosimf::app::version_commit() { return \"${commit}\"; }
")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
