# The page for browsers: murosimf_web_page(<target>) adds it to a target. npm bundles web/ when something of it has changed; without
# npm, or if it cannot get what web/package-lock.json names, the page is left out, and the program says so where it is asked for.
function(murosimf_web_page target)
  find_program(NPM npm)
  find_program(NODE NAMES node nodejs)
  if(NOT NPM OR NOT NODE)
    message(STATUS "the page for browsers is left out: npm was not found (Debian and Ubuntu: npm)")
    target_sources(${target} PRIVATE web/no_page.cpp)
    return()
  endif()
  set(work ${CMAKE_BINARY_DIR}/web)
  add_custom_target(murosimf_page
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DNODE=${NODE} -DSOURCE=${PROJECT_SOURCE_DIR}/web -DWORK=${work}
      -P ${PROJECT_SOURCE_DIR}/cmake/BundlePage.cmake
    BYPRODUCTS ${work}/page.cpp COMMENT "" VERBATIM)
  target_sources(${target} PRIVATE ${work}/page.cpp)
  set_source_files_properties(${work}/page.cpp PROPERTIES GENERATED TRUE SKIP_UNITY_BUILD_INCLUSION ON)
  add_dependencies(${target} murosimf_page)
endfunction()
