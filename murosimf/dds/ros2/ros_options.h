/// ros_options.h - options of a robot with the controller 'ros2'.
#pragma once

namespace murosimf::dds::ros2 {

struct RosOptions {
  bool walk = true;      ///< cmd_vel moves it by the motion engine; false: joints alone are commanded
  double timeout = 0.5;  ///< [s] after which a cmd_vel that is not renewed is over
};

}  // namespace murosimf::dds::ros2
