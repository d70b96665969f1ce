/// bus_layout.h - which servo on a robot's bus moves which joint.
///
/// Without a file: all joints in their order, ids from 1 on. The file is a table (CSV) with one row for each servo; joints that it
/// does not name have none on the bus:
///
///     joint,id,servo,direction,zero [deg]
///     j_neck,19,mx28_2,1,0
///     j_head,20,mx28_2,-1,15
///
/// `joint` and `id` are needed. `servo`: a control table, or a file with one ("mine.toml"); that of the joint's servo if it is not given. `direction`: -1 if the servo
/// turns the other way round. `zero`: the joint's angle at the servo's position 2048.
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
  bool own_type = false;  ///< the table is that of the simulated servo: their voltages mean the same
};

/// Ids are below this one in either protocol.
inline constexpr int first_no_id = 253;

/// Tables for servos of the MX series are those of `protocol`; others know 2.0 only. A servo of an unknown type is an MX-28.
[[nodiscard]] std::vector<ServoPlace> usual_layout(const Model& model, dynamixel::Protocol protocol);

/// Throws SetupError with file:line:column.
[[nodiscard]] std::vector<ServoPlace> read_layout(const std::filesystem::path& file, const Model& model,
                                                  dynamixel::Protocol protocol);

}  // namespace murosimf::serial
