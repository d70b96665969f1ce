/// motion_switcher.h - the service that programs ask to have the robot's own motion control leave its motors to them.
///
/// Requests and answers are those of unitree_api: a number of the caller's own, the number of the call, and JSON. Calls: 1001 CheckMode,
/// 1002 SelectMode, 1003 ReleaseMode. Source: unitree_sdk2py/comm/motion_switcher and unitree_sdk2py/idl/unitree_api of
/// github.com/unitreerobotics/unitree_sdk2_python. Codes of refusals are not published for this service: theirs here is the vendor's 3203,
/// "server has no such call" (unitree_sdk2py/rpc/internal.py).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "murosimf/dds/cdr.h"

namespace murosimf::dds::unitree {

struct Request {
  std::int64_t id = 0, call = 0;
  bool no_reply = false;
  std::string parameter;  ///< JSON
};

struct Answer {
  std::int64_t id = 0, call = 0;
  std::int32_t code = 0;  ///< 0: success
  std::string data;       ///< JSON
};

/// Nothing: it is no such message.
[[nodiscard]] std::optional<Request> read_request(std::span<const std::uint8_t> bytes);
void write_answer(CdrWriter& to, const Answer& answer);

/// `stands`: whether the robot's own motion control has the motors; the call may change it.
[[nodiscard]] Answer switch_motion(const Request& request, bool& stands);

}  // namespace murosimf::dds::unitree
