/// sensor_files.h - a small robot with sensors, in an own folder for every test.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot/robot_reader.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot::sensor_files {

using robot_formats::urdf::urdf_files::test_folder;
using robot_formats::urdf::urdf_files::write;

/// A base with a site `imu`, and an arm with a joint `elbow` and a site of the joint's name.
inline std::string robot_xml(const std::string& sensors = "") {
  const std::string mass = "<inertial mass='1' pos='0.1 0 0' diaginertia='1 1 1'/>";
  return "<mujoco model='r'><worldbody><body name='base'><freejoint/>" + mass +
         "<site name='imu' pos='0 0 0.1'/><body name='arm' pos='0 0 1'><joint name='elbow' axis='0 1 0'/>" + mass +
         "<site name='elbow' pos='0 0 0.2'/></body></body></worldbody>\n<actuator><motor name='m' joint='elbow' "
         "ctrlrange='-1 1'/><motor name='geared' joint='elbow' gear='3' ctrlrange='-1 1'/></actuator>\n<sensor>" +
         sensors + "</sensor></mujoco>";
}

/// Reads the robot with a TOML file beside it.
inline RobotFile read_with(const std::string& toml, const std::string& sensors = "",
                           const robot_formats::ReaderOptions& options = {}) {
  write("robot.toml", toml);
  return read_robot(write("robot.xml", robot_xml(sensors)), options);
}

inline const sensors::SensorSpec& sensor_of(const RobotFile& robot, const std::string& name) {
  for (const sensors::SensorSpec& spec : robot.sensors) {
    if (spec.name == name) return spec;
  }
  throw std::out_of_range("no sensor " + name);
}

}  // namespace murosimf::robot::sensor_files
