# Libraries of C++ that pip brings with the requirements of the build (pyproject.toml), for machines without their packages: `pip install .`
# needs a compiler and Python alone. What the system has goes first, unless MUROSIMF_HEADLESS is on.

# murosimf_pip_folder(<variable> <module>): the folder that this module of Python stands in, empty if there is none.
function(murosimf_pip_folder variable module)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import pathlib, ${module}; print(pathlib.Path(list(${module}.__path__)[0]).parent)"
    OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

# murosimf_pip_archive(<name> <patterns> <options>...): downloads what cmake/<name>.txt names, whose hash pip checks, and unpacks the files of
# these patterns below murosimf_pip_<name>. It stands in no environment, so any version of Python may bring it.
function(murosimf_pip_archive name patterns)
  set(work ${CMAKE_BINARY_DIR}/pip_${name})
  set(murosimf_pip_${name} ${work} PARENT_SCOPE)
  if(EXISTS ${work}/unpacked)
    return()
  endif()
  execute_process(COMMAND ${Python_EXECUTABLE} -m pip download --quiet --disable-pip-version-check --no-deps ${ARGN}
    --require-hashes --dest ${work} -r ${PROJECT_SOURCE_DIR}/cmake/${name}.txt
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${name} was not found on this machine (Debian and Ubuntu: scripts/install_dependencies), and pip could not bring it: ${said}")
  endif()
  file(GLOB archive ${work}/*.tar.gz ${work}/*.whl)
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${work} PATTERNS ${patterns})
  file(REMOVE ${archive})
  file(TOUCH ${work}/unpacked)
endfunction()

# toml++ is in no wheel, but in the sources of a package that wraps it.
function(murosimf_pip_tomlplusplus)
  murosimf_pip_archive(tomlplusplus "*/third_party/tomlplusplus/*" --no-binary :all:)
  file(GLOB include ${murosimf_pip_tomlplusplus}/*/third_party/tomlplusplus/include)
  add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED GLOBAL)
  target_include_directories(tomlplusplus::tomlplusplus INTERFACE ${include})
endfunction()

# murosimf_find_headers(<package> <folder>): find_package, and the target <package>::<package>; if the system has no such package, of headers
# that pip brings in a wheel with those of many libraries.
function(murosimf_find_headers package folder)
  if(SKBUILD AND MUROSIMF_HEADLESS)
    set(${package}_FOUND OFF)
  elseif(SKBUILD)
    find_package(${package} QUIET)
  else()
    find_package(${package} REQUIRED)
  endif()
  if(TARGET ${package}::${package})
    return()
  elseif(SKBUILD AND NOT ${package}_FOUND)
    murosimf_pip_archive(headers "*/cli11/include/*;*/nlohmann_json/include/*" --only-binary :all: --ignore-requires-python)
    set(include ${murosimf_pip_headers}/pgm_build_deps/${folder}/include)
  endif()
  add_library(${package}::${package} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${package}::${package} SYSTEM INTERFACE ${include})
endfunction()

if(SKBUILD)
  find_package(Python 3.10 REQUIRED COMPONENTS Interpreter)
  murosimf_pip_folder(murosimf_pip_site cmeel)
  if(murosimf_pip_site AND MUROSIMF_HEADLESS)
    list(PREPEND CMAKE_PREFIX_PATH ${murosimf_pip_site}/cmeel.prefix)
  elseif(murosimf_pip_site)
    list(APPEND CMAKE_SYSTEM_PREFIX_PATH ${murosimf_pip_site}/cmeel.prefix)  # behind the system's
  endif()
endif()
