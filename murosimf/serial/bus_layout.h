/// bus_layout.h - assignment of the servos on a robot's bus to its joints.
///
/// Without a file: all joints in their order, ids from 1 on. The file is a table (CSV) with one row for each servo; joints that are
/// missing in it have no servo on the bus:
///
///     joint,id,servo,direction,zero [deg]
///     j_neck,19,mx28_2,1,0
///     j_head,20,mx28_2,-1,15
///
/// `joint` and `id` are required. `servo`: a control table, or a file with one ("mine.toml"); default: that of the joint's servo. `direction`: -1 if the servo
/// turns in the opposite direction. `zero`: the joint's angle at the servo's position 2048.
#pragma once

#include <filesystem>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/serial/dynamixel/control_table.h"

namespace murosimf::serial {

struct ServoPlace {
  std::size_t joint = 0;  ///< among the model's joints
  std::uint8_t id = 0;
  const dynamixel::ControlTable* table = nullptr;
  double direction = 1;
  double zero = 0;        ///< [rad]
  bool own_type = false;  ///< the table is that of the simulated servo, so voltages are comparable
};

/// Ids are below this value in either protocol.
inline constexpr int first_no_id = 253;

/// Tables for servos of the MX series are those of `protocol`; others exist for 2.0 only. A servo of an unknown type is an MX-28.
[[nodiscard]] std::vector<ServoPlace> usual_layout(const Model& model, dynamixel::Protocol protocol);

/// Throws SetupError with file:line:column.
[[nodiscard]] std::vector<ServoPlace> read_layout(const std::filesystem::path& file, const Model& model,
                                                  dynamixel::Protocol protocol);

}  // namespace murosimf::serial
