# `cmake --install`: program, shared and static library with the public headers, CMake package and pkg-config file, what plug-ins and
# control software need, robots, servos, parts of sensors, lenses, motions and scenes. Other headers are not installed.

include(CMakePackageConfigHelpers)

set(murosimf_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/murosimf)
set(murosimf_data_dir ${CMAKE_INSTALL_DATADIR}/murosimf)

# The program.
if(TARGET murosimf_app)
  install(TARGETS murosimf_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # where shells and man look for them
  install(FILES ${CMAKE_BINARY_DIR}/share/murosimf.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME murosimf OPTIONAL)
  install(FILES ${CMAKE_BINARY_DIR}/share/_murosimf DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions OPTIONAL)
  install(FILES ${CMAKE_BINARY_DIR}/share/murosimf.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endif()
if(TARGET murosimf_fast_dds)
  install(TARGETS murosimf_fast_dds LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(TARGET murosimf_python_module)
  install(TARGETS murosimf_python_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(TARGET murosimf_sdf_frames)
  install(TARGETS murosimf_sdf_frames RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(folder datasets lenses models motions parts scenes servos)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${murosimf_data_dir})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/murosimf_client DESTINATION ${murosimf_data_dir}/python
  FILES_MATCHING PATTERN "*.py")

# The library, for programs: murosimf::murosimf, and murosimf::static for who asks for the component `static`.
file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/murosimf/*.h)
install(FILES ${public_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/murosimf)
if(TARGET murosimf_shared)
  install(TARGETS murosimf_shared EXPORT murosimf LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(FILES ${CMAKE_BINARY_DIR}/library/libmurosimf.a DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()

# For plug-ins: their headers, and what these include, in a folder of its own; murosimf::plugin.
include(${PROJECT_SOURCE_DIR}/cmake/IncludedHeaders.cmake)
file(GLOB plugin_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/murosimf/plugin/*.h)
murosimf_included_headers(headers ${plugin_headers})
foreach(header IN LISTS headers)
  get_filename_component(folder ${header} DIRECTORY)
  murosimf_find_header(file ${header})
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/murosimf-plugin/${folder})
endforeach()

# For control software: in shared libraries (murosimf::controller), and in programs of its own (murosimf::client).
install(FILES ${PROJECT_SOURCE_DIR}/murosimf/control_software/murosimf_controller.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/murosimf/control_software)
install(TARGETS murosimf_plugin murosimf_controller EXPORT murosimf)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/murosimf/network DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/murosimf
  FILES_MATCHING PATTERN "*.proto")
if(TARGET murosimf::client)
  install(FILES ${PROJECT_SOURCE_DIR}/murosimf/network/robot_client.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/murosimf/network)
  install(TARGETS murosimf_network EXPORT murosimf_client ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT murosimf_client NAMESPACE murosimf:: FILE murosimfClientTargets.cmake DESTINATION ${murosimf_package_dir})
endif()

# What finds all that. The shared library brings its own; whoever links the static one links these, too.
set(murosimf_static_libraries -lfmt -ltinyxml2 -ltomlplusplus -lqhull_r -lpthread -ldl)
foreach(part PkgConfig::cairo=-lcairo,-lpng PkgConfig::jpeg=-ljpeg PkgConfig::opengl=-lepoxy,-lEGL PkgConfig::zstd=-lzstd yaml-cpp::yaml-cpp=-lyaml-cpp
    protobuf::libprotobuf-lite=-lprotobuf-lite PkgConfig::websockets=-lwebsockets ZLIB::ZLIB=-lz)
  string(REGEX MATCH "^(.+)=(.+)$" part ${part})
  string(REPLACE "," ";" libraries ${CMAKE_MATCH_2})
  if(TARGET ${CMAKE_MATCH_1})
    list(APPEND murosimf_static_libraries ${libraries})
  endif()
endforeach()
find_library(MUROSIMF_TOMLPLUSPLUS_LIBRARY tomlplusplus)
mark_as_advanced(MUROSIMF_TOMLPLUSPLUS_LIBRARY)
if(NOT MUROSIMF_TOMLPLUSPLUS_LIBRARY)  # headers alone
  list(REMOVE_ITEM murosimf_static_libraries -ltomlplusplus)
endif()
list(JOIN murosimf_static_libraries " " murosimf_static_libraries_in_line)

file(RELATIVE_PATH murosimf_prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/murosimf.pc.in ${CMAKE_CURRENT_BINARY_DIR}/murosimf.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/murosimf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(EXPORT murosimf NAMESPACE murosimf:: FILE murosimfTargets.cmake DESTINATION ${murosimf_package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/murosimfConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfig.cmake
  INSTALL_DESTINATION ${murosimf_package_dir}
  PATH_VARS murosimf_data_dir CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/murosimfConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfigVersion.cmake
  DESTINATION ${murosimf_package_dir})
