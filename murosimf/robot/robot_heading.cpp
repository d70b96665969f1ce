#include "murosimf/robot/robot_heading.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_soles.h"

namespace murosimf::robot {
namespace {

using robot_formats::BodyDescription;
using robot_formats::FrameDescription;
using robot_formats::RobotDescription;

constexpr double least_distance = 0.01;  // [m] between hips, so that their axis has a direction
constexpr double backward = 0.01;        // [m] behind the ankle: no foot has its middle there

/// Exact, so that numbers do not change by rounding.
Mat3d quarter_turns(int count) {
  MUROSIMF_ASSERT(count >= 0 && count < 4);
  constexpr std::array<Vec3d, 4> ahead{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
  const auto k = static_cast<std::size_t>(count);
  return {ahead[k], ahead[(k + 1) % 4], {0, 0, 1}};
}

/// Quarters of a turn about z, 0 to 3, that turn x nearest to a direction.
int quarters_to(double x, double y) { return (static_cast<int>(std::lround(std::atan2(y, x) / (pi / 2))) + 4) % 4; }

/// From the base, which is not included, to the foot.
std::vector<std::size_t> path_to(const RobotDescription& description, std::size_t foot) {
  MUROSIMF_ASSERT(foot < description.bodies.size());
  std::vector<std::size_t> path;
  for (auto body = static_cast<int>(foot); body > 0; body = description.bodies[body].parent)
    path.insert(path.begin(), static_cast<std::size_t>(body));
  return path;
}

struct Leg {
  Vec3d hip, ankle;  ///< [m] anchors of the first and last joint, in the frame of the base
  Vec3d foot;        ///< [m] middle of its sole
};

/// Nothing without own joints, or without a bottom.
std::optional<Leg> leg_of(const RobotDescription& description, const std::vector<std::size_t>& path,
                          std::size_t shared) {
  const auto places = body_places(description);
  std::vector<Vec3d> anchors;
  for (std::size_t i = shared; i < path.size(); ++i) {
    MUROSIMF_ASSERT(shared <= path.size());
    for (const robot_formats::JointDescription& joint : description.bodies[path[i]].joints)
      anchors.push_back(places[path[i]].position + places[path[i]].orientation * joint.anchor);
  }
  if (anchors.empty()) return std::nullopt;
  const auto sole = sole_under(description, path.back(), "");
  if (!sole) return std::nullopt;
  const Transformd& foot = places[path.back()];
  return Leg{anchors.front(), anchors.back(), foot.position + foot.orientation * sole->place.position};
}

/// By the name of the foot, or else of a sole on it.
Side side_of_foot(const BodyDescription& foot) {
  Side side = side_of(foot.name);
  for (const FrameDescription& frame : foot.frames) {
    if (side == Side::unknown && frame.box) side = side_of(frame.name);
  }
  return side;
}

/// Left one first; nothing if names do not show it.
std::optional<std::array<std::size_t, 2>> named_feet(const RobotDescription& description, const RobotConfig& table) {
  const auto feet = bodies_with_soles(description, table);
  if (feet.size() != 2) return std::nullopt;
  const std::size_t a = *feet.begin(), b = *feet.rbegin();
  const Side side_a = side_of_foot(description.bodies[a]), side_b = side_of_foot(description.bodies[b]);
  if (side_a == Side::left && side_b == Side::right) return std::array{a, b};
  if (side_a == Side::right && side_b == Side::left) return std::array{b, a};
  return std::nullopt;
}

void turn_base(RobotDescription& description, const Mat3d& forward) {
  // Objects in the frame of the base keep their places in the world: they are turned back in the frame.
  const Transformd back{{}, transpose(forward)};
  BodyDescription& base = description.bodies[0];
  base.solid = robot_formats::moved(base.solid, {}, back.orientation);
  base.place.orientation = base.place.orientation * forward;
  for (robot_formats::ShapeDescription& shape : base.shapes) {
    const Transformd there = back * shape.placed.place();
    shape.placed.position = there.position;
    shape.placed.orientation = there.orientation;
  }
  for (robot_formats::VisualDescription& visual : base.visuals) visual.place = back * visual.place;
  for (FrameDescription& frame : base.frames) frame.place = back * frame.place;
  for (BodyDescription& body : description.bodies) {
    if (body.parent == 0) body.place = back * body.place;
  }
  for (robot_formats::SensorDescription& sensor : description.sensors) {
    if (sensor.frame == base.name) sensor.place = back * sensor.place;
  }
  for (robot_formats::KeyframeDescription& key : description.keyframes) {
    key.base.orientation = key.base.orientation * forward;
  }
}

/// A rectangle is the same after each quarter of a turn, with length and width swapped.
void turn_soles(RobotDescription& description, std::size_t foot) {
  const Mat3d at = body_places(description)[foot].orientation;
  for (FrameDescription& frame : description.bodies[foot].frames) {
    if (!frame.box) continue;
    const Mat3d& axes = frame.place.orientation;
    const Vec3d forward = transposed_times(at * axes, Vec3d{1, 0, 0});
    const int quarters = quarters_to(forward.x, forward.y);
    frame.place.orientation = axes * quarter_turns(quarters);
    if (quarters % 2 == 1) std::swap(frame.box->half_length, frame.box->half_width);
  }
}

std::string line(const RobotDescription& description, const std::string& message) {
  return fmt::format("{}: {}", description.bodies[0].where, message);
}

}  // namespace

void face_forward(RobotDescription& description, const RobotConfig& table) {
  const auto feet = description.fixed_base ? std::nullopt : named_feet(description, table);
  if (!feet) return;
  const auto left_path = path_to(description, (*feet)[0]), right_path = path_to(description, (*feet)[1]);
  std::size_t shared = 0;
  // Bodies on both ways, such as a torso, are no parts of the legs.
  while (shared < left_path.size() && shared < right_path.size() && left_path[shared] == right_path[shared]) ++shared;
  const auto left = leg_of(description, left_path, shared), right = leg_of(description, right_path, shared);
  if (!left || !right) return;
  const Vec3d sideways = left->hip - right->hip;
  if (std::hypot(sideways.x, sideways.y) < least_distance) return;
  const int quarters = quarters_to(sideways.y, -sideways.x);
  if (quarters == 0) return;
  MUROSIMF_ASSERT(quarters >= 0 && quarters < 4);
  const Mat3d forward = quarter_turns(quarters);
  const double ahead = dot(left->foot - left->ankle + right->foot - right->ankle, forward.x) / 2;
  constexpr std::array directions{"x", "y", "-x", "-y"};
  const char* direction = directions[static_cast<std::size_t>(quarters)];
  if (ahead < -backward) {
    description.warnings.push_back(line(
        description,
        fmt::format("by names of left and right the robot faces {}, by its feet it does not; it is taken to face x",
                    direction)));
    return;
  }
  turn_base(description, forward);
  for (const std::size_t foot : *feet) turn_soles(description, foot);
  description.notes.push_back(
      line(description,
           fmt::format("by names of left and right the robot faces {} of its base '{}': here the base is turned, "
                       "so that x is forward",
                       direction, description.bodies[0].name)));
}

}  // namespace murosimf::robot
