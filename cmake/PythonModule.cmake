# murosimf-python.so: what runs classes in Python (control_software/python). Loaded, not linked: only runs with such a class pay for it. It uses
# the part of Python's interface that is the same for all versions, so one file is for all of them, and it links no library of Python.
if(NOT Python_EXECUTABLE AND MUROSIMF_ORACLE_PYTHON)
  set(Python_EXECUTABLE ${MUROSIMF_ORACLE_PYTHON})
endif()
find_package(Python 3.10 QUIET COMPONENTS Interpreter Development.Module)

# The library of the Python that is found, for programs; a Python program brings its own. Without a folder the loader looks for it.
set(python_library "")
if(Python_Interpreter_FOUND)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "
import os, sysconfig
name, folder, triple = (sysconfig.get_config_var(key) or '' for key in ('INSTSONAME', 'LIBDIR', 'MULTIARCH'))
files = [os.path.join(folder, triple, name), os.path.join(folder, name)]
print(next(filter(os.path.isfile, files), name) if '.so' in name else '')"
    OUTPUT_VARIABLE python_library OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set_property(SOURCE control_software/python/python_interpreter.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  MUROSIMF_PYTHON_BUILT="${CMAKE_BINARY_DIR}/murosimf-python.so"
  MUROSIMF_PYTHON_INSTALLED="${CMAKE_INSTALL_FULL_LIBDIR}/murosimf-python.so"
  MUROSIMF_PYTHON_PROGRAM="${Python_EXECUTABLE}"
  MUROSIMF_LIBPYTHON="${python_library}")

if(NOT Python_Development.Module_FOUND)
  return()
endif()
set(python_module ${PROJECT_SOURCE_DIR}/murosimf/control_software/python/module)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${python_module}/classes.py)
file(READ ${python_module}/classes.py classes_text)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/python_module/classes_text.h @ONLY CONTENT
  "constexpr const char* classes_text = R\"-----(@classes_text@)-----\";\n")
file(GLOB python_module_sources CONFIGURE_DEPENDS ${python_module}/*.cpp)
add_library(murosimf_python_module MODULE ${python_module_sources})
target_compile_features(murosimf_python_module PRIVATE cxx_std_20)
set_target_properties(murosimf_python_module PROPERTIES PREFIX "" OUTPUT_NAME murosimf-python CXX_VISIBILITY_PRESET hidden
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
target_include_directories(murosimf_python_module PRIVATE ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/python_module)
target_include_directories(murosimf_python_module SYSTEM PRIVATE ${Python_INCLUDE_DIRS})
target_link_libraries(murosimf_python_module PRIVATE murosimf_options Threads::Threads)
add_dependencies(murosimf_control_software murosimf_python_module)
