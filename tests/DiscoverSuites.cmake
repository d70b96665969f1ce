# murosimf_discover_suites(<target> <prefix> <environment> <changes of it>): after the executable of tests is built, asks it for its
# suites and makes one test <prefix>.<Suite> of each. How many tests a suite has stands in its test's XML file in test_results (scripts/test_summary).
# The tests that murosimf_release_only names, <prefix>.<Suite>.<Test>, are left out. Of laws of physics over many parameters every
# third is taken, along the diagonal of levels and three laws of contact: the code is the same.
# As a script (cmake -D EXECUTABLE= -D PREFIX= -D ENVIRONMENT= -D CHANGES= -D RESULTS= -D OUTPUT= -D LEFT_OUT= -P): writes the file that ctest
# includes.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(murosimf_discovery_script ${CMAKE_CURRENT_LIST_FILE})
  function(murosimf_discover_suites target prefix environment changes)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    set(left_out ${murosimf_release_only})
    list(FILTER left_out INCLUDE REGEX "^${prefix}\\.")
    list(TRANSFORM left_out REPLACE "^${prefix}\\." "")
    add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${output} VERBATIM
      COMMAND ${CMAKE_COMMAND} -D EXECUTABLE=$<TARGET_FILE:${target}> -D PREFIX=${prefix} -D ENVIRONMENT=${environment}
        -D CHANGES=${changes} -D RESULTS=${PROJECT_BINARY_DIR}/test_results/${target} -D OUTPUT=${output} "-D LEFT_OUT=${left_out}" -P
        ${murosimf_discovery_script})
    # the file is missing where only some of the executables are built
    set(include_file ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
    file(CONFIGURE OUTPUT ${include_file} CONTENT
      "if(EXISTS \"${output}\")\n  include(\"${output}\")\nelse()\n  add_test(${prefix}_NOT_BUILT ${target}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include_file})
  endfunction()
  return()
endif()

cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${EXECUTABLE} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${EXECUTABLE} does not list its tests: ${result}")
endif()
string(REGEX REPLACE "#[^\n]*" "" listed "${listed}")  # values of parameters
string(REPLACE "\n" ";" lines "${listed}")
set(suites "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\. *$")
    set(suite ${CMAKE_MATCH_1})
    list(APPEND suites ${suite})
    set(count_${suite} 0)
    set(not_${suite} "")
  elseif(line MATCHES "^  ([^ ]+)")
    set(test ${suite}.${CMAKE_MATCH_1})
    set(another_parameter OFF)
    if(PREFIX STREQUAL "physics" AND test MATCHES "^(.+/.+)/")
      if(NOT CMAKE_MATCH_1 STREQUAL without_parameter)
        set(without_parameter ${CMAKE_MATCH_1})
        set(number 0)
      endif()
      math(EXPR third "(${number} + ${number} / 3) % 3")
      math(EXPR number "${number} + 1")
      if(third GREATER 0)
        set(another_parameter ON)
      endif()
    endif()
    if(test IN_LIST LEFT_OUT OR another_parameter)
      list(REMOVE_ITEM LEFT_OUT ${test})
      string(APPEND not_${suite} ":${test}")
    else()
      math(EXPR count_${suite} "${count_${suite}} + 1")
    endif()
  endif()
endforeach()
if(LEFT_OUT)
  message(FATAL_ERROR "${EXECUTABLE} does not have the tests that murosimf_release_only names: ${LEFT_OUT}")
endif()
# A suite costs as many seconds as it has tests; those that simulate for long start before the others.
set(ahead 0)
if(PREFIX MATCHES "^(physics|soccer|scene|dynamics)$")
  set(ahead 60)
endif()
set(text "")
foreach(suite IN LISTS suites)
  if(count_${suite} EQUAL 0)
    continue()
  endif()
  string(REGEX REPLACE "^:" "-" not "${not_${suite}}")
  string(REPLACE "/" "." file ${suite})
  math(EXPR cost "${ahead} + ${count_${suite}}")
  string(APPEND text "add_test([=[${PREFIX}.${suite}]=] [=[${EXECUTABLE}]=] [=[--gtest_filter=${suite}.*${not}]=]\
 [=[--gtest_output=xml:${RESULTS}/${file}.xml]=])\n\
set_tests_properties([=[${PREFIX}.${suite}]=] PROPERTIES ENVIRONMENT [=[${ENVIRONMENT}]=] ENVIRONMENT_MODIFICATION [=[${CHANGES}]=] COST ${cost})\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
