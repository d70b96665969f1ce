// What a Booster's service does for each request. Numbers and bodies: LocoApiId and the parameters' to_json_str of the vendor's SDK 1.6.3.
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/dds/booster/booster_software.h"
#include "murosimf/math/quaternion.h"

namespace murosimf::dds::booster {
namespace {

enum Request : std::int64_t {
  change_mode = 2000,
  move = 2001,
  rotate_head = 2004,
  wave_hand = 2005,
  lie_down = 2007,
  get_up = 2008,
  get_frame_transform = 2011,
  get_mode = 2017,
  get_status = 2018,
  get_robot_info = 2022,
  shoot = 2024,
  get_up_with_mode = 2025,
  upper_body_custom_control = 2030,
  reset_odometry = 2031,
  visual_kick = 2038,
  rotate_head_with_time = 2043,
};

/// A whole number from a body; nothing: there is none.
std::optional<std::int64_t> whole(const RpcParameters& given, std::string_view name) {
  const std::optional<double> number = given.find(name);
  constexpr double most = 1e9;
  if (!number || !(std::abs(*number) <= most)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

constexpr double fastest = 100;  // [m/s, rad/s] as of motion.velocity

}  // namespace

void BoosterSoftware::handle_requests() {
  handle_modes();
  handle_motions();
  handle_questions();
}

void BoosterSoftware::handle_modes() {
  handlers_[change_mode] = [this](const RpcParameters& given) -> RpcAnswer {
    const auto mode = whole(given, "mode");
    if (!mode) return {Status::bad_request};
    const Mode before = modes_.mode();
    const Status status = modes_.change(*mode);
    if (modes_.mode() != before) {  // commands of another mode are over
      commands_.clear();
      upper_body_ = false;
    }
    return {status};
  };
  const auto rise = [this](std::int64_t mode) {
    const bool lay = modes_.lies();
    const Status status = modes_.get_up(mode, sensing_.posture());
    // after lie_down the engine waits for a motion get_up_*, and takes that of the side it lies on
    if (status == Status::success && lay && !motions_.play("get_up_front")) return RpcAnswer{Status::refused};
    return RpcAnswer{status};
  };
  handlers_[get_up] = [rise](const RpcParameters&) { return rise(static_cast<std::int64_t>(Mode::walking)); };
  handlers_[get_up_with_mode] = [rise](const RpcParameters& given) -> RpcAnswer {
    const auto mode = whole(given, "mode");
    return mode ? rise(*mode) : RpcAnswer{Status::bad_request};
  };
  handlers_[lie_down] = [this](const RpcParameters&) -> RpcAnswer {
    if (modes_.uses_motions() && !modes_.rises() && !modes_.lies() && !motions_.play("lie_down"))
      return {Status::refused};
    return {modes_.lie_down()};
  };
  handlers_[upper_body_custom_control] = [this](const RpcParameters& given) -> RpcAnswer {
    const auto start = whole(given, "start");
    if (!start) return {Status::bad_request};
    if (!modes_.uses_motions()) return {Status::conflict};
    upper_body_ = *start != 0;
    commands_.clear();
    return {};
  };
}

void BoosterSoftware::handle_motions() {
  handlers_[move] = [this](const RpcParameters& given) -> RpcAnswer {
    const auto x = given.find("vx"), y = given.find("vy"), turn = given.find("vyaw");
    if (!x || !y || !turn) return {Status::bad_request};
    if (std::abs(*x) > fastest || std::abs(*y) > fastest || std::abs(*turn) > fastest) return {Status::bad_request};
    return {modes_.move({*x, *y, *turn})};
  };
  handlers_[rotate_head] =
      handlers_[rotate_head_with_time] = [this](const RpcParameters& given) { return turn_head(given); };
  handlers_[wave_hand] = [this](const RpcParameters& given) { return wave(given); };
  handlers_[shoot] = [this](const RpcParameters&) -> RpcAnswer {
    if (!modes_.walks()) return {Status::conflict};
    return {motions_.kick() ? Status::success : Status::refused};
  };
  handlers_[visual_kick] = [this](const RpcParameters& given) { return kick_what_is_seen(given); };
}

/// Parameters: hand_index (0 left, 1 right) and hand_action (0 open, 1 close). Closing has nothing to do: the arm is down again after the motion.
RpcAnswer BoosterSoftware::wave(const RpcParameters& given) {
  if (!modes_.walks() && (modes_.mode() != Mode::prepare || modes_.rises() || modes_.lies())) return {Status::conflict};
  if (whole(given, "hand_action").value_or(0) != 0) return {};
  const bool left = whole(given, "hand_index").value_or(1) == 0;
  return {motions_.play(left ? "wave_left" : "wave_right") ? Status::success : Status::refused};
}

/// Where no message of rt/kick_ball says where the ball is, it kicks ahead, and follows the next one.
RpcAnswer BoosterSoftware::kick_what_is_seen(const RpcParameters& given) {
  const auto start = whole(given, "start");
  if (!start) return {Status::bad_request};
  if (*start == 0) return visual_kick_.stop(), motions_.drop_kick(), RpcAnswer{};
  if (!modes_.walks()) return {Status::conflict};
  if (!motions_.can_kick()) return {Status::refused};
  if (!visual_kick_.start(cycle_)) (void)motions_.kick();
  return {};
}

std::string BoosterSoftware::robot_info() const {
  const std::string model(joints_.order->model);
  return nlohmann::json{{"name", name_},        {"nickname", name_},      {"version", "simulated"}, {"model", model},
                        {"serial_number", "0"}, {"edition", "simulated"}, {"region", "Global"}}
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Parameters: pitch, yaw [rad], and time_millis if it has one.
RpcAnswer BoosterSoftware::turn_head(const RpcParameters& given) {
  const auto pitch = given.find("pitch"), yaw = given.find("yaw");
  constexpr double longest = 600;  // [s]
  const double duration = 1e-3 * given.find("time_millis").value_or(0);
  if (!pitch || !yaw || !(duration >= 0 && duration <= longest)) return {Status::bad_request};
  if (!modes_.uses_motions() || modes_.rises() || modes_.lies()) return {Status::conflict};
  head_.go({low_level_.target(0), low_level_.target(1)}, {*yaw, *pitch}, duration);
  return {};
}

/// Pose of `dst` in the frame `src`: in which of both directions the real robot answers is not published.
RpcAnswer BoosterSoftware::frame_transform(const RpcParameters& given) const {
  const auto of = whole(given, "dst"), in = whole(given, "src");
  if (!of || !in) return {Status::bad_request};
  const std::optional<Transformd> pose = frames_.pose(*of, *in, sensing_.motors());
  if (!pose) return {Status::bad_request};
  const Quaterniond turn = from_matrix(pose->orientation);
  const Vec3d& place = pose->position;
  return {{},
          fmt::format("{{\"position\":{{\"x\":{},\"y\":{},\"z\":{}}},"
                      "\"orientation\":{{\"x\":{},\"y\":{},\"z\":{},\"w\":{}}}}}",
                      place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w)};
}

void BoosterSoftware::handle_questions() {
  handlers_[get_frame_transform] = [this](const RpcParameters& given) { return frame_transform(given); };
  handlers_[get_mode] = [this](const RpcParameters&) -> RpcAnswer {
    return {{}, fmt::format("{{\"mode\":{}}}", static_cast<int>(modes_.mode()))};
  };
  handlers_[get_status] = [this](const RpcParameters&) -> RpcAnswer {
    return {{},
            fmt::format("{{\"current_mode\":{},\"current_body_control\":{},\"current_actions\":[]}}",
                        static_cast<int>(modes_.mode()), modes_.body_control())};
  };
  handlers_[get_robot_info] = [this](const RpcParameters&) -> RpcAnswer { return {{}, robot_info()}; };
  handlers_[reset_odometry] = [this](const RpcParameters& given) -> RpcAnswer {
    sensing_.set_odometer({given.find("x").value_or(0), given.find("y").value_or(0), given.find("theta").value_or(0)});
    return {};
  };
}

}  // namespace murosimf::dds::booster
