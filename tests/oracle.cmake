# Comparisons with other programs, where these are installed.

set(MUROSIMF_ORACLE_PYTHON python3 CACHE STRING "Python interpreter that has the packages mujoco, cv2 and numpy")
function(add_oracle_test name)
  add_test(NAME oracle.${name} COMMAND ${MUROSIMF_ORACLE_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/oracle/${name}.py ${ARGN})
  set_tests_properties(oracle.${name} PROPERTIES COST 5 SKIP_RETURN_CODE 77)
endfunction()

# With sanitizers, too: many robots of others are read, converted and written, and a server is told nonsense.
add_oracle_test(converted_robots_in_mujoco $<TARGET_FILE:murosimf_app> ${PROJECT_SOURCE_DIR}/models
  ${PROJECT_SOURCE_DIR}/../shared/data)
add_oracle_test(written_robots $<TARGET_FILE:murosimf_app> ${PROJECT_SOURCE_DIR}/models
  ${PROJECT_SOURCE_DIR}/../shared/data)
if(TARGET PkgConfig::websockets)
  add_oracle_test(foxglove_live $<TARGET_FILE:murosimf_app>)
  set_tests_properties(oracle.foxglove_live PROPERTIES TIMEOUT 300)
endif()
if(sanitized)
  return()  # the others compare values
endif()

# Kinematics, masses and dynamics against MuJoCo and Pinocchio, lenses against OpenCV, the serial line with
# the vendor's dynamixel-sdk, where their Python packages are installed.
foreach(program dump_poses dump_masses dump_robot dump_dynamics dump_trajectory dump_lens dump_mcap)
  add_executable(${program} oracle/${program}.cpp)
  target_link_libraries(${program} PRIVATE murosimf)
  murosimf_compile_as_test(${program})
endforeach()
add_oracle_test(kid21_against_mujoco $<TARGET_FILE:dump_poses> ${PROJECT_SOURCE_DIR}/models/kid21.xml)
add_oracle_test(meshes_against_mujoco $<TARGET_FILE:dump_masses>)
add_oracle_test(robots_against_mujoco $<TARGET_FILE:dump_robot> ${PROJECT_SOURCE_DIR}/../shared/data)
add_oracle_test(mjcf_words_against_mujoco $<TARGET_FILE:murosimf_app>)
add_oracle_test(tendons_against_mujoco $<TARGET_FILE:murosimf_app>)
add_oracle_test(strings_against_mujoco $<TARGET_FILE:murosimf_app>)
add_oracle_test(macros_by_xacro $<TARGET_FILE:murosimf_app> $<TARGET_FILE:test_robot_formats>)
add_oracle_test(random_trees_against_mujoco $<TARGET_FILE:dump_dynamics>)
add_oracle_test(random_trees_against_pinocchio $<TARGET_FILE:dump_dynamics>)
add_oracle_test(trajectories_against_mujoco $<TARGET_FILE:dump_trajectory>)
add_oracle_test(linkages_against_mujoco $<TARGET_FILE:dump_trajectory>)
add_oracle_test(lenses_against_opencv $<TARGET_FILE:dump_lens>)
add_oracle_test(dataset_against_coco $<TARGET_FILE:murosimf_app> ${PROJECT_SOURCE_DIR}/scenes/three_on_three.toml)
add_oracle_test(mcap_against_official $<TARGET_FILE:dump_mcap>)
add_oracle_test(recording_against_official $<TARGET_FILE:murosimf_app>)
add_oracle_test(recorded_pictures $<TARGET_FILE:murosimf_app>)
add_oracle_test(recorded_drawings $<TARGET_FILE:murosimf_app>)
set_tests_properties(oracle.recorded_drawings PROPERTIES RESOURCE_LOCK real_time COST 205 TIMEOUT 300)  # in real time
add_oracle_test(bags_with_rosbags $<TARGET_FILE:murosimf_app>)
add_oracle_test(bvh_against_recording $<TARGET_FILE:murosimf_app>)
add_oracle_test(logs_in_numpy $<TARGET_FILE:murosimf_app>)
add_oracle_test(serial_with_vendor_sdk $<TARGET_FILE:murosimf_app>)
set_tests_properties(oracle.serial_with_vendor_sdk PROPERTIES RESOURCE_LOCK real_time COST 212 TIMEOUT 300)  # in real time

if(TARGET fastrtps)
  add_oracle_test(booster_sdk $<TARGET_FILE:murosimf_app> --short)
  set_tests_properties(oracle.booster_sdk PROPERTIES RESOURCE_LOCK real_time COST 213 TIMEOUT 300)  # in real time
  add_oracle_test(ros2_nodes $<TARGET_FILE:murosimf_app>)
  set_tests_properties(oracle.ros2_nodes PROPERTIES RESOURCE_LOCK real_time COST 212 TIMEOUT 300)  # in real time
  add_oracle_test(unitree_hg $<TARGET_FILE:murosimf_app>)
  set_tests_properties(oracle.unitree_hg PROPERTIES RESOURCE_LOCK real_time COST 211 TIMEOUT 120)  # in real time
endif()

# Collision against FCL, where it is installed. Never by MUROSIMF_TEST_COMPILER: objects of Eigen are in FCL's interface, and clang relies on an
# alignment that the library, compiled by g++ for any processor, does not give them.
find_package(fcl QUIET)
if(fcl_FOUND)
  add_executable(test_fcl oracle/fcl_test.cpp)
  target_compile_options(test_fcl PRIVATE ${test_optimization})
  target_link_libraries(test_fcl PRIVATE murosimf murosimf_options GTest::gtest_main Eigen3::Eigen fmt::fmt fcl)
  gtest_discover_tests(test_fcl TEST_PREFIX oracle_fcl. DISCOVERY_TIMEOUT 60 PROPERTIES ENVIRONMENT "${leak_options}")
endif()

# Files of robots against the reference reader of URDF, where it is installed.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(urdfdom QUIET IMPORTED_TARGET urdfdom)
endif()
if(TARGET PkgConfig::urdfdom)
  add_executable(test_urdfdom oracle/urdfdom_test.cpp)
  target_compile_options(test_urdfdom PRIVATE ${test_optimization})
  target_compile_definitions(test_urdfdom PRIVATE MUROSIMF_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(test_urdfdom PRIVATE
    murosimf murosimf_options GTest::gtest_main Eigen3::Eigen fmt::fmt PkgConfig::urdfdom)
  gtest_discover_tests(test_urdfdom TEST_PREFIX oracle. DISCOVERY_TIMEOUT 60 PROPERTIES ENVIRONMENT "${leak_options}")
endif()
