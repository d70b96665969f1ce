#include "murosimf/robot_formats/mjcf/mjcf_frame.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr std::array ways{"quat", "axisangle", "euler", "xyaxes", "zaxis"};

Vec3d unit(const MjcfAttributes& attributes, std::string_view name, const Vec3d& v) {
  const double length = norm(v);
  if (!(length > 1e-12)) {
    attributes.source(name).fail(fmt::format("{} '{}' has no direction", name, attributes.text(name)));
  }
  return (1.0 / length) * v;
}

Mat3d from_axis_angle(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto a = attributes.numbers("axisangle", 4, 4);
  return rotation(unit(attributes, "axisangle", {a[0], a[1], a[2]}),
                  a[3] * compiler.units_of(attributes.source("axisangle")).angle_unit);
}

Mat3d from_euler(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto angles = attributes.numbers("euler", 3, 3);
  const MjcfUnits& units = compiler.units_of(attributes.source("euler"));
  Mat3d turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = units.euler_sequence[i];
    const double angle = angles[i] * units.angle_unit;
    const int axis = std::tolower(letter);
    const Mat3d step = axis == 'x' ? rotation_x(angle) : axis == 'y' ? rotation_y(angle) : rotation_z(angle);
    // Lower case: about the axes that the earlier turns have moved; upper case: about the fixed ones.
    turn = std::islower(letter) ? turn * step : step * turn;
  }
  return turn;
}

Mat3d from_xy_axes(const MjcfAttributes& attributes) {
  const auto a = attributes.numbers("xyaxes", 6, 6);
  const Vec3d x = unit(attributes, "xyaxes", {a[0], a[1], a[2]});
  // The y axis need not be exactly perpendicular in the file.
  const Vec3d y = unit(attributes, "xyaxes", tangential(Vec3d{a[3], a[4], a[5]}, x));
  return {x, y, cross(x, y)};
}

bool is_euler_sequence(const std::string& text) {
  return text.size() == 3 && text.find_first_not_of("xyzXYZ") == std::string::npos;
}

void read_mass_rules(const MjcfAttributes& attributes, MjcfCompiler& compiler) {
  compiler.least_mass = attributes.number("boundmass", compiler.least_mass);
  compiler.least_inertia = attributes.number("boundinertia", compiler.least_inertia);
  compiler.total_mass = std::max(0.0, attributes.number("settotalmass", compiler.total_mass));
  if (const auto groups = attributes.numbers("inertiagrouprange", 2, 2); !groups.empty()) {
    compiler.first_group = groups[0];
    compiler.last_group = groups[1];
  }
  if (attributes.has("balanceinertia")) {
    compiler.balance_inertia = attributes.choice("balanceinertia", {"false", "true"}) == "true";
  }
}

}  // namespace

MjcfCompiler read_compiler(const files::XmlElement& root) {
  MjcfCompiler compiler;
  // Several compiler elements (of includes) add up; later ones precede.
  for (const files::XmlElement& element : root.children("compiler")) {
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    if (attributes.has("angle") && attributes.choice("angle", {"degree", "radian"}) == "radian") {
      compiler.units.angle_unit = 1.0;
    }
    if (attributes.has("eulerseq")) compiler.units.euler_sequence = attributes.text("eulerseq");
    if (!is_euler_sequence(compiler.units.euler_sequence)) {
      element.fail(
          fmt::format("eulerseq '{}' must be three letters out of x y z X Y Z", compiler.units.euler_sequence));
    }
    if (attributes.has("autolimits"))
      compiler.units.auto_limits = attributes.choice("autolimits", {"true", "false"}) == "true";
    if (attributes.has("inertiafromgeom")) {
      const auto choice = attributes.choice("inertiafromgeom", {"auto", "true", "false"});
      compiler.inertia_from_geom = choice == "auto"   ? InertiaFromGeom::if_missing
                                   : choice == "true" ? InertiaFromGeom::always
                                                      : InertiaFromGeom::never;
    }
    compiler.mesh_folder = attributes.text("meshdir", attributes.text("assetdir", compiler.mesh_folder));
    compiler.picture_folder = attributes.text("texturedir", attributes.text("assetdir", compiler.picture_folder));
    if (attributes.has("strippath")) compiler.strip_path = attributes.choice("strippath", {"false", "true"}) == "true";
    read_mass_rules(attributes, compiler);
    if (attributes.text("coordinate", "local") != "local") {
      element.fail("only coordinate=\"local\" is supported; save the file anew with MuJoCo");
    }
  }
  return compiler;
}

Mat3d read_quaternion(const MjcfAttributes& attributes, std::string_view name) {
  const auto q = attributes.numbers(name, 4, 4);
  if (q.empty()) return {};
  const Quaterniond quaternion{q[0], q[1], q[2], q[3]};
  if (!(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 1e-24)) {
    attributes.source(name).fail(fmt::format("{} of length zero has no direction; write 1 0 0 0 for no turn", name));
  }
  return to_matrix(normalized(quaternion));
}

Mat3d read_orientation(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto count = std::ranges::count_if(ways, [&](const char* way) { return attributes.has(way); });
  if (count > 1) attributes.element().fail("two orientations; keep one of quat, axisangle, euler, xyaxes, zaxis");
  if (attributes.has("quat")) return read_quaternion(attributes, "quat");
  if (attributes.has("axisangle")) return from_axis_angle(attributes, compiler);
  if (attributes.has("euler")) return from_euler(attributes, compiler);
  if (attributes.has("xyaxes")) return from_xy_axes(attributes);
  if (attributes.has("zaxis")) return turn_of_z(unit(attributes, "zaxis", attributes.vector("zaxis", {})));
  return {};
}

Mat3d turn_of_z(const Vec3d& axis) {
  MUROSIMF_ASSERT(norm(axis) > 0);
  const Vec3d z = (1.0 / norm(axis)) * axis;
  const Vec3d across = cross(Vec3d{0, 0, 1}, z);
  const double sine = norm(across);
  // From z to -z every axis across is equally short; MuJoCo takes x.
  if (sine < 1e-12) return z.z > 0 ? Mat3d{} : rotation_x(pi);
  return rotation((1.0 / sine) * across, std::atan2(sine, z.z));
}

bool is_limited(const MjcfAttributes& attributes, std::string_view flag, std::string_view range,
                const MjcfCompiler& compiler) {
  const auto choice = attributes.choice(flag, {"auto", "true", "false"});
  const bool limited = choice == "true" || (choice == "auto" && attributes.has(range) &&
                                            compiler.units_of(attributes.source(range)).auto_limits);
  if (!limited) return false;
  const auto limits = attributes.numbers(range, 2, 2);
  if (limits.empty()) attributes.element().fail(fmt::format("{} is true, but there is no {}; add it", flag, range));
  // A class may set a range that an element takes back by equal ends.
  if (choice == "auto" && limits[0] == limits[1]) return false;
  if (limits[0] >= limits[1]) {
    attributes.source(range).fail(fmt::format("{} '{}' must go from lower to higher", range, attributes.text(range)));
  }
  return true;
}

}  // namespace murosimf::robot_formats::mjcf
