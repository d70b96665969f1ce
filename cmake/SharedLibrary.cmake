# The public interface (include/murosimf) as libmurosimf.so and libmurosimf.a: the objects of the folders that it needs, which are
# compiled once, position independent, for both and for the program. What others may see of the shared one stands in murosimf.map.

# murosimf_needed_folders(<variable> <folder>): its target and those of all that it uses, low to high.
function(murosimf_needed_folders variable folder)
  set(needed ${folder})
  set(open ${folder})
  while(open)
    list(POP_FRONT open each)
    get_target_property(uses ${each} MUROSIMF_USES)
    foreach(use IN LISTS uses)
      if(use AND NOT use IN_LIST needed)
        list(APPEND needed ${use})
        list(APPEND open ${use})
      endif()
    endforeach()
  endwhile()
  set(ordered "")
  get_property(all GLOBAL PROPERTY murosimf_folder_targets)
  foreach(target IN LISTS all)
    if(target IN_LIST needed)
      list(APPEND ordered ${target})
    endif()
  endforeach()
  set(${variable} ${ordered} PARENT_SCOPE)
endfunction()

# murosimf_shared_library(<folder>): the target murosimf_shared, that folder with what it needs.
function(murosimf_shared_library folder)
  murosimf_needed_folders(needed murosimf_${folder})
  set(map ${PROJECT_SOURCE_DIR}/cmake/murosimf.map)
  add_library(murosimf_shared SHARED $<TARGET_OBJECTS:murosimf_${folder}>)
  set_target_properties(murosimf_shared PROPERTIES OUTPUT_NAME murosimf EXPORT_NAME murosimf LINK_DEPENDS ${map}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(murosimf_shared INTERFACE cxx_std_20)
  target_include_directories(murosimf_shared INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_options(murosimf_shared PRIVATE LINKER:--version-script=${map} LINKER:--no-undefined LINKER:--gc-sections)
  target_link_libraries(murosimf_shared PRIVATE ${needed})

  # one archive of all of them, for programs that want no other file
  set(archive ${CMAKE_CURRENT_BINARY_DIR}/libmurosimf.a)
  list(TRANSFORM needed REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE archives)
  add_custom_command(OUTPUT ${archive} DEPENDS ${needed} VERBATIM COMMENT "Joining archives to libmurosimf.a"
    COMMAND ${CMAKE_COMMAND} -DAR=${CMAKE_AR} -DOUTPUT=${archive} "-DARCHIVES=${archives}"
      -P ${PROJECT_SOURCE_DIR}/cmake/JoinArchives.cmake)
  add_custom_target(murosimf_static ALL DEPENDS ${archive})
endfunction()
