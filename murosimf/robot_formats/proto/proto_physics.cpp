#include "murosimf/robot_formats/proto/proto_physics.h"

#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr double usual_density = 1000;  // [kg/m^3] where the file has neither mass nor density

std::optional<SymMat3d> read_inertia(const Node& physics) {
  const Field* field = physics.find("inertiaMatrix");
  if (!field || field->empty()) return std::nullopt;
  const auto& I = field->numbers;
  if (I.size() != 6) {
    physics.fail(fmt::format("inertiaMatrix has {} numbers; write Ixx Iyy Izz, Ixy Ixz Iyz", I.size()), field);
  }
  MUROSIMF_ASSERT(I.size() == 6);
  if (!(I[0] > 0 && I[1] > 0 && I[2] > 0)) physics.fail("moments of inertia must be more than 0", field);
  return SymMat3d{I[0], I[1], I[2], I[3], I[4], I[5]};
}

double read_mass(const Node& physics, double volume) {
  MUROSIMF_ASSERT(!(volume < 0));
  const double mass = physics.number("mass", -1), density = physics.number("density", usual_density);
  if (mass >= 0) return mass;  // -1, the default, stands for "by density"
  if (mass != -1) physics.fail(fmt::format("mass {} kg is negative; correct it", mass), physics.find("mass"));
  if (density < 0) physics.fail("Physics has neither mass nor density; write one of them");
  if (volume == 0)
    physics.fail("Physics has a density, but its Solid has no boundingObject with a volume; write its mass");
  return density * volume;
}

void check_inertia(const Node& physics, const SymMat3d& inertia, ProtoLog& log) {
  const Vec3d moments = robot_formats::principal_moments(inertia);
  if (moments.x >= 0 && !robot_formats::breaks_triangle_inequality(moments)) return;
  log.warn(physics.where,
           fmt::format("no solid body has the principal moments {:.4g} {:.4g} {:.4g} kg m^2: two of them "
                       "must not be less than the third",
                       moments.x, moments.y, moments.z));
}

}  // namespace

robot_formats::MassProperties read_physics(const Node& physics,
                                           const std::vector<robot_formats::MassProperties>& bounding, ProtoLog& log) {
  if (physics.type != "Physics") physics.fail(fmt::format("{} stands where Physics should", physics.type));
  log.check_fields(physics);
  if (physics.child("damping")) log.unused(physics.where, "Physics.damping", "damping of Physics is not used");
  const robot_formats::MassProperties all = robot_formats::combined(bounding);
  const auto inertia = read_inertia(physics);
  robot_formats::MassProperties solid;
  solid.mass = read_mass(physics, all.mass);
  solid.center = physics.vector("centerOfMass", all.center);
  if (inertia) {
    check_inertia(physics, *inertia, log);
    solid.inertia = *inertia;
  } else if (all.mass > 0) {
    // The shape's inertia at density 1, scaled to the mass.
    solid.inertia = (solid.mass / all.mass) * all.inertia;
  } else if (solid.mass > 0) {
    log.note(physics.where, "Solids with mass and without inertiaMatrix and boundingObject are points");
  }
  return solid;
}

}  // namespace murosimf::robot_formats::proto
