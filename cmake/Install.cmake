# `cmake --install`: program, library with headers and its CMake package `murosimf`, robots, servos, parts of sensors,
# lenses and scenes.

include(CMakePackageConfigHelpers)

set(murosimf_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/murosimf)

get_property(folder_targets GLOBAL PROPERTY murosimf_folder_targets)
install(TARGETS murosimf murosimf_plugin murosimf_controller ${folder_targets} EXPORT murosimf
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET murosimf_app)
  install(TARGETS murosimf_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # where shells and man look for them
  install(FILES ${CMAKE_BINARY_DIR}/share/murosimf.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME murosimf OPTIONAL)
  install(FILES ${CMAKE_BINARY_DIR}/share/_murosimf DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions OPTIONAL)
  install(FILES ${CMAKE_BINARY_DIR}/share/murosimf.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endif()
if(TARGET murosimf_sdf_frames)
  install(TARGETS murosimf_sdf_frames RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/murosimf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*.proto")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lenses ${PROJECT_SOURCE_DIR}/models ${PROJECT_SOURCE_DIR}/motions ${PROJECT_SOURCE_DIR}/parts ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/servos
  DESTINATION ${CMAKE_INSTALL_DATADIR}/murosimf)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/murosimf_client DESTINATION ${CMAKE_INSTALL_DATADIR}/murosimf/python
  FILES_MATCHING PATTERN "*.py")

install(EXPORT murosimf NAMESPACE murosimf:: FILE murosimfTargets.cmake DESTINATION ${murosimf_package_dir})

# A static library passes its private libraries on to whoever links it; the package finds them in the same way.
if(tomlplusplus_DIR)
  set(murosimf_tomlplusplus_from_pkg_config OFF)
else()
  set(murosimf_tomlplusplus_from_pkg_config ON)
endif()
foreach(part cairo=PkgConfig::cairo opengl=PkgConfig::opengl zstd=PkgConfig::zstd nlopt=NLopt::nlopt protobuf=protobuf::libprotobuf-lite yaml=yaml-cpp::yaml-cpp
    websockets=PkgConfig::websockets zlib=ZLIB::ZLIB)
  string(REPLACE "=" ";" part ${part})
  list(GET part 0 name)
  list(GET part 1 library)
  if(TARGET ${library})
    set(murosimf_uses_${name} ON)
  else()
    set(murosimf_uses_${name} OFF)
  endif()
endforeach()

set(murosimf_uses_window OFF)
if(murosimf_can_view)
  set(murosimf_uses_window ON)
endif()

set(murosimf_data_dir ${CMAKE_INSTALL_DATADIR}/murosimf)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/murosimfConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfig.cmake
  INSTALL_DESTINATION ${murosimf_package_dir}
  PATH_VARS murosimf_data_dir)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/murosimfConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/murosimfConfigVersion.cmake
  DESTINATION ${murosimf_package_dir})
