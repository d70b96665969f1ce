# Libraries of C++ that pip brings with the requirements of the build (pyproject.toml), for machines without their packages: `pip install .`
# needs a compiler and Python alone. What the system has goes first, unless MUROSIMF_HEADLESS is on.

# murosimf_pip_folder(<variable> <module>): the folder that this module of Python stands in, empty if there is none.
function(murosimf_pip_folder variable module)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import pathlib, ${module}; print(pathlib.Path(list(${module}.__path__)[0]).parent)"
    OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

# toml++ is in no wheel, but in the sources of a package that wraps it; pip checks their hash.
function(murosimf_pip_tomlplusplus)
  set(work ${CMAKE_BINARY_DIR}/tomlplusplus)
  file(GLOB archive ${work}/*.tar.gz)
  if(NOT archive)
    execute_process(COMMAND ${Python_EXECUTABLE} -m pip download --quiet --disable-pip-version-check --no-deps --no-binary :all:
      --require-hashes --dest ${work} -r ${PROJECT_SOURCE_DIR}/cmake/tomlplusplus.txt
      RESULT_VARIABLE failed ERROR_VARIABLE said)
    if(failed)
      message(FATAL_ERROR "toml++ was not found (Debian and Ubuntu: libtomlplusplus-dev), and pip could not bring it: ${said}")
    endif()
    file(GLOB archive ${work}/*.tar.gz)
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${work} PATTERNS "*/third_party/tomlplusplus/*")
  endif()
  file(GLOB include ${work}/*/third_party/tomlplusplus/include)
  add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED GLOBAL)
  target_include_directories(tomlplusplus::tomlplusplus INTERFACE ${include})
endfunction()

# murosimf_find_headers(<package> <header>): find_package, and the target <package>::<package>; of headers that pip brought if the system has
# no such package.
function(murosimf_find_headers package header)
  find_path(MUROSIMF_PIP_${package} ${header} PATHS ${murosimf_pip_includes} NO_DEFAULT_PATH)
  mark_as_advanced(MUROSIMF_PIP_${package})
  if(NOT MUROSIMF_PIP_${package})
    find_package(${package} REQUIRED)
    return()
  endif()
  if(NOT MUROSIMF_HEADLESS)
    find_package(${package} QUIET)
  endif()
  if(NOT TARGET ${package}::${package})
    add_library(${package}::${package} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${package}::${package} SYSTEM INTERFACE ${MUROSIMF_PIP_${package}})
  endif()
endfunction()

set(murosimf_pip_includes "")
if(SKBUILD)
  find_package(Python 3.10 REQUIRED COMPONENTS Interpreter)
  murosimf_pip_folder(murosimf_pip_site cmeel)
  if(murosimf_pip_site AND MUROSIMF_HEADLESS)
    list(PREPEND CMAKE_PREFIX_PATH ${murosimf_pip_site}/cmeel.prefix)
  elseif(murosimf_pip_site)
    list(APPEND CMAKE_SYSTEM_PREFIX_PATH ${murosimf_pip_site}/cmeel.prefix)  # behind the system's
  endif()
  murosimf_pip_folder(folder pgm_build_deps)
  list(APPEND murosimf_pip_includes ${folder}/pgm_build_deps/cli11/include ${folder}/pgm_build_deps/nlohmann_json/include)
endif()
