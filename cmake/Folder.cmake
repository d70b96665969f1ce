# With MUROSIMF_UNITY several sources of a folder are compiled as one: half of compiling is reading the same headers again.
# Left alone are sources whose names in anonymous namespaces others of their folder have, too, or that define macros.
# MUROSIMF_FOLDERS_ALONE has more of them.
set(murosimf_folders_alone geometry ${MUROSIMF_FOLDERS_ALONE})
set_source_files_properties(soccer/localize.cpp robot_formats/mjcf/mjcf_tendons.cpp robot/conversion_additions.cpp robot/robot_builder.cpp component_files/sensor_keys.cpp component_files/sensor_toml.cpp
  component_files/servo_description.cpp files/data_path.cpp robot_formats/mesh/obj_file.cpp robot_formats/urdf/urdf_joint.cpp
  serial/line_rate.cpp dds/participant.cpp locomotion/gait_clock.cpp dynamics/joint_stop.cpp robot/role_inference.cpp render/image_png.cpp render/opengl/gl_drawing.cpp web/server.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# They read, check and write, and no step of a simulation runs through them: optimizing them fully is a fifth of their time.
set(murosimf_cold_folders files robot_formats component_files dds robot appearance catalog scene_file scene session viewer league logging
  supervise recording ros2 web studies)

# Where the time of a step goes. Nine of their sources are compiled as one, so that what is inlined, and the counted instructions
# (tests/instruction_counts.txt), do not change with the other folders. Of others eighteen are: an eighth to three tenths less to compile.
set(murosimf_hot_folders math model world geometry multibody collision dynamics air runtime imaging sensors locomotion
  soccer)
# Sanitizers see the same accesses in code that is not optimized, and that compiles in half of the time: folders that are compiled so.
# The thread sanitizer optimizes hot folders only; that of addresses also what draws, speaks and plays in its tests.
function(murosimf_unoptimized folder variable)
  set(${variable} OFF PARENT_SCOPE)
  if(CMAKE_CXX_FLAGS MATCHES "fsanitize=thread" AND NOT folder IN_LIST murosimf_hot_folders)
    set(${variable} ON PARENT_SCOPE)
  elseif(CMAKE_CXX_FLAGS MATCHES "fsanitize=address" AND NOT MUROSIMF_FUZZ AND folder IN_LIST murosimf_cold_folders)
    set(${variable} ON PARENT_SCOPE)
  endif()
endfunction()

# All bytes of recordings pass through it, and unoptimized it takes half of the time of their tests.
murosimf_unoptimized(recording recording_is_unoptimized)
if(recording_is_unoptimized)
  set_source_files_properties(recording/mcap/crc32.cpp
    PROPERTIES COMPILE_OPTIONS -O1 SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endif()

# With MUROSIMF_PRECOMPILE: what nearly all sources of the library include, compiled once for all folders that are optimized, and once
# for those that are not, as clang wants it.
function(murosimf_precompile)
  if(NOT MUROSIMF_PRECOMPILE)
    return()
  endif()
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")  # keeps its date, so that configuring again compiles nothing
  set(targets murosimf_precompiled)
  murosimf_unoptimized(scene some_unoptimized)  # a cold one
  if(some_unoptimized)
    list(APPEND targets murosimf_precompiled_cold)
  endif()
  foreach(target IN LISTS targets)
    add_library(${target} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${target} PRIVATE murosimf_options fmt::fmt)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endforeach()
  if(some_unoptimized)
    target_compile_options(murosimf_precompiled_cold PRIVATE -O0)
  endif()
endfunction()

# murosimf_folder(<folder> [USES <folders>] [LINKS <libraries>] [EXCEPT <sources or folders in it>]): one folder of the library, with the
# folders in it, as a static library murosimf_<folder>. Adds it to the global properties murosimf_folders and murosimf_folder_targets.
function(murosimf_folder folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;LINKS;EXCEPT")
  set(target murosimf_${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  foreach(source IN LISTS arg_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${source}(/|$)")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY murosimf_folders ${folder})
  set_property(GLOBAL APPEND PROPERTY murosimf_folder_targets ${target})
  list(TRANSFORM arg_USES PREPEND "murosimf_")
  add_library(${target} ${sources})
  set_target_properties(${target} PROPERTIES MUROSIMF_USES "${arg_USES}")
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC ${arg_USES} PRIVATE $<BUILD_INTERFACE:murosimf_options> fmt::fmt ${arg_LINKS})
  # Eigen's prefetching does not compile with sanitizers and without optimization
  target_compile_definitions(${target} PRIVATE $<$<CONFIG:Debug>:EIGEN_DONT_VECTORIZE>)
  if(folder IN_LIST murosimf_cold_folders)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  set(precompiled murosimf_precompiled)
  set(batch 18)
  if(folder IN_LIST murosimf_hot_folders)
    set(batch 9)
  endif()
  murosimf_unoptimized(${folder} unoptimized)
  if(unoptimized)
    target_compile_options(${target} PRIVATE -O0)
    set(precompiled murosimf_precompiled_cold)
  endif()
  # kernels have flags of their own, which a header compiled with others does not fit
  if(MUROSIMF_PRECOMPILE AND NOT folder STREQUAL "multibody")
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
  if(MUROSIMF_UNITY AND NOT folder IN_LIST murosimf_folders_alone)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()
