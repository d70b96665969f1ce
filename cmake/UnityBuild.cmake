# Several sources in one: half of compiling is reading the same headers again. Faster from scratch (CI, scripts/demo), slower
# when one file changes, so it is off by default (MUROSIMF_UNITY). -Wshadow is off with it: names of another source in the
# same group are no mistake.

# Sources whose names in anonymous namespaces others have, too, or that define macros for themselves.
set(murosimf_unity_excluded io/data_path.cpp io/sensor_signal.cpp io/sensor_toml.cpp motion/joint_stop.cpp)

# Groups `sources` (relative paths): up to 9 of a folder, in io those whose names begin with the same word.
function(murosimf_group_sources sources)
  list(REMOVE_ITEM sources ${murosimf_unity_excluded})
  set(count 0)
  set(last_folder "")
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(name ${source} NAME_WE)
    if(folder STREQUAL "io")
      string(REGEX REPLACE "_.*" "" word ${name})
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "io_${word}")
      continue()
    endif()
    if(NOT folder STREQUAL last_folder)
      set(count 0)
      set(last_folder ${folder})
    endif()
    math(EXPR part "${count} / 9")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}_${part}")
    math(EXPR count "${count} + 1")
  endforeach()
endfunction()
