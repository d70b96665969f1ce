/// robot_config.h - data that a robot file cannot have, from a TOML file of the same stem beside it.
///
///     [soles]                      # box sites at the bottoms of the feet, or the feet themselves
///     left = "l_sole"              # (a quadruped: front_left, front_right, hind_left, hind_right)
///     right = "r_sole"
///
///     [sole_sizes]                 # [m] length and width of soles, for files without box sites (URDF): the frame is in their middle
///     l_sole = [0.2, 0.1]
///
///     [frames]                     # other names for frames, bodies and joints
///     imu = "imu_link"
///     camera = "camera_optical_frame"
///
///     [joints]                     # other names for joints
///     LHipYaw = "Left_Hip_Yaw"
///
///     [rate_limits]                # [rad/s | m/s] largest rates of joints (URDF has them itself); 0: none
///     LHipYaw = 5.5
///
///     [rest_positions]             # [rad | m] where walks and motions hold joints that they do not move; 0 if not given
///     LHipYaw = 0.1
///
///     [linkages]                   # joints of loops that take targets: servos of the loops' other joints follow them
///     commanded = ["l_ankle_pitch", "l_ankle_roll"]
///
///     [surfaces]                   # materials of the pair table (model/material.h), by body
///     default = "plastic"
///     l_foot = "rubber"
///
///     [meshes]
///     part_per_group = ["torso"]   # meshes of OBJ files with convex parts as objects or groups
///
///     [walk]                       # numbers of the walk, instead of the computed ones (locomotion/walk_options.h)
///     lift = 0.03
///
///     [motions]                    # key-frame motions by purpose (docs/motions.md)
///     kick_right = "kick"
///
///     [balance]                    # numbers of the walk with feedback (locomotion/gait_feedback.h), and its table of steps (step_table_file.h)
///     step_at = 0.03
///     steps = "robot_steps.csv"
///
///     [sensors.imu]                # docs/robots.md, "Sensors"; murosimf/component_files/sensor_table.h
///     part = "mpu6050"
///
///     [servos.legs]                # SI units, on the output side of the gear (docs/robots.md, "Servos")
///     type = "mx64"                # a ready-made servo to start from: servos/mx64.toml, or a file beside this one
///     voltage = 14.8               # any number of it may be replaced; without a type, the law's needs must be there
///     joints = ["j_l_thigh", "j_r_thigh"]
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/component_files/sensor_table.h"
#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/locomotion/step_table.h"
#include "murosimf/model/option.h"
#include "murosimf/model/servo.h"
#include "murosimf/model/shape.h"

namespace murosimf::robot {

/// A name in the table, and its place: "robot.toml:3:8".
struct TableName {
  std::string name;
  std::string where;
};

struct TableServo {
  Servo servo;
  std::string where;
};

struct TableNumber {
  double number = 0;
  std::string where;
};

struct TableSole {
  Sole sole;
  std::string where;
};

struct TableMotion {
  locomotion::KeyframeMotion motion;
  std::string where;
};

struct RobotConfig {
  std::vector<TableName> soles;
  std::vector<std::string> sole_frames;               ///< where the soles are, once they are placed (role_inference.h)
  std::map<std::string, TableSole> sole_sizes;        ///< by frame, or body that is welded
  std::map<std::string, TableName> frames;            ///< frame, body or joint by its other name
  std::map<std::string, TableName> joints;            ///< joint by its other name
  std::map<std::string, TableNumber> rate_limits;     ///< [rad/s | m/s] by joint
  std::map<std::string, TableNumber> rest_positions;  ///< [rad | m] by joint
  std::vector<TableName> commanded;                   ///< joints of loops that take targets
  std::string default_surface;                        ///< empty: none
  std::map<std::string, TableName> surfaces;          ///< material by body
  std::map<std::string, TableServo> servos;           ///< by joint
  std::vector<TableName> part_per_group;              ///< meshes of several convex parts
  std::vector<component_files::SensorTable> sensors;  ///< that it makes, changes or removes
  OptionValues walk, balance;                  ///< numbers of the walk and of the one with feedback, by their names
  locomotion::StepTablePtr steps;              ///< null: none
  std::map<std::string, TableMotion> motions;  ///< by what they are for

  /// Material of a body: its own or the default.
  [[nodiscard]] const std::string& surface(const std::string& body) const;
};

/// Throws SetupError with file:line:column for unknown keys, values of a wrong type, impossible numbers, and motions that are missing
/// or have errors.
[[nodiscard]] RobotConfig read_robot_config(const std::filesystem::path& file);

/// The table beside a model file; an empty one if there is none.
[[nodiscard]] RobotConfig read_table_beside(const std::filesystem::path& model_file);

/// Names of a robot's parts.
struct RobotNames {
  std::vector<std::string> joints, bodies, frames, meshes;
};

/// Throws SetupError if the table names a joint, body, frame or mesh that the robot does not have.
void check_names(const RobotConfig& table, const RobotNames& names);

}  // namespace murosimf::robot
