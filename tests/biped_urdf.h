/// biped_urdf.h - a made-up humanoid as other people's files have it: torques and no gains, no word of soles.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace murosimf::fixtures {

/// Lengths grow with `size`, masses with its cube, torques with its fourth power; at 1 it has 62.9 kg and legs of 0.82 m.
struct Biped {
  double size = 1;
  double torque = 180;      ///< [N m] of hips and knees, at size 1
  double ankle = 60;        ///< [N m] the same of the ankles
  bool waist = false;       ///< trunk above a hinge: the base is the trunk, the pelvis hangs below it
  std::string effort = "";  ///< of the left knee, instead
};

namespace biped_detail {

inline std::string link(const std::string& name, double mass, const double (&box)[3], const std::string& at, double s) {
  const double m = mass * s * s * s, x = box[0] * s, y = box[1] * s, z = box[2] * s;
  const std::string shape =
      fmt::format("<collision><origin xyz='{}'/><geometry><box size='{} {} {}'/></geometry></collision>", at, x, y, z);
  return fmt::format(
      "<link name='{}'><inertial><origin xyz='{}'/><mass value='{}'/><inertia ixx='{}' iyy='{}' izz='{}' ixy='0' "
      "ixz='0' "
      "iyz='0'/></inertial>{}</link>\n",
      name, at, m, m * (y * y + z * z) / 12, m * (x * x + z * z) / 12, m * (x * x + y * y) / 12,
      mass > 2 || name.ends_with("foot") ? shape : "");
}

inline std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                         const std::string& at, const std::string& axis, const std::string& range,
                         const std::string& effort) {
  return fmt::format(
      "<joint name='{}' type='revolute'><parent link='{}'/><child link='{}'/><origin xyz='{}'/><axis xyz='{}'/><limit "
      "{} "
      "effort='{}' velocity='14'/></joint>\n",
      name, parent, child, at, axis, range, effort);
}

inline std::string leg(const Biped& b, const std::string& side, double y) {
  const double s = b.size;
  const auto at = [&](double x, double up) { return fmt::format("{} 0 {}", x * s, up * s); };
  const auto strong = fmt::format("{}", b.torque * s * s * s * s), weak = fmt::format("{}", b.ankle * s * s * s * s);
  const auto n = [&](const char* part) { return side + part; };
  return link(n("_yaw"), 1.2, {.06, .06, .06}, "0 0 0", s) + link(n("_roll"), 1.2, {.06, .06, .06}, "0 0 0", s) +
         link(n("_thigh"), 7, {.1, .1, .3}, at(0, -.22), s) + link(n("_shin"), 4, {.08, .08, .36}, at(0, -.2), s) +
         link(n("_ankle"), .5, {.06, .06, .06}, "0 0 0", s) + link(n("_foot"), 1.3, {.23, .1, .03}, at(.045, -.06), s) +
         joint(n("_hip_yaw"), "pelvis", n("_yaw"), fmt::format("0 {} 0", y * s), "0 0 1", "lower='-.8' upper='.8'",
               strong) +
         joint(n("_hip_roll"), n("_yaw"), n("_roll"), "0 0 0", "1 0 0", "lower='-.6' upper='.6'", strong) +
         joint(n("_hip_pitch"), n("_roll"), n("_thigh"), "0 0 0", "0 1 0", "lower='-1.7' upper='1'", strong) +
         joint(n("_knee"), n("_thigh"), n("_shin"), at(0, -.41), "0 1 0", "lower='0' upper='2.2'",
               side == "l" && !b.effort.empty() ? b.effort : strong) +
         joint(n("_ankle_pitch"), n("_shin"), n("_ankle"), at(0, -.41), "0 1 0", "lower='-1' upper='.8'", weak) +
         joint(n("_ankle_roll"), n("_ankle"), n("_foot"), "0 0 0", "1 0 0", "lower='-.5' upper='.5'", weak);
}

}  // namespace biped_detail

inline std::string biped_urdf(const Biped& b) {
  using namespace biped_detail;
  const double s = b.size;
  const std::string trunk = link("trunk", 26, {.2, .3, .5}, fmt::format("0 0 {}", .3 * s), s);
  const std::string pelvis = link("pelvis", 6.5, {.16, .26, .1}, "0 0 0", s);
  const std::string limit = "lower='-.5' upper='.5'";
  std::string text = "<robot name='biped'>\n" + (b.waist ? trunk + pelvis : pelvis + trunk);
  text += b.waist ? joint("waist", "trunk", "pelvis", "0 0 0", "0 0 1", limit, "200")
                  : joint("waist", "pelvis", "trunk", "0 0 0", "0 0 1", limit, "200");
  return text + leg(b, "l", .1) + leg(b, "r", -.1) + "</robot>\n";
}

}  // namespace murosimf::fixtures
