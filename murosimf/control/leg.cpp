#include "murosimf/control/leg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/properties.h"

namespace murosimf::control {
namespace {

constexpr double tolerance = 1e-6;  // [m], [1]

struct Axis {
  const char* joint;
  Vec3d direction;
};
constexpr std::array<Axis, 6> axes{{{"hip yaw", {0, 0, 1}},
                                    {"hip roll", {1, 0, 0}},
                                    {"hip pitch", {0, 1, 0}},
                                    {"knee", {0, 1, 0}},
                                    {"ankle pitch", {0, 1, 0}},
                                    {"ankle roll", {1, 0, 0}}}};

[[noreturn]] void refuse(const Model& model, const std::string& why) {
  throw SetupError(fmt::format("model '{}' has no leg that can be walked with: {}", model.name(), why));
}

/// Links from the base (excluded) to the sole.
std::vector<const Link*> joints_to(const Model& model, int sole) {
  std::vector<const Link*> links;
  const Tree& tree = model.tree();
  for (int l = tree.link_of[sole]; l > 0; l = tree.links[l].parent) links.insert(links.begin(), &tree.links[l]);
  return links;
}

bool vanishes(const Vec3d& v) { return norm(v) < tolerance; }
bool points_down(const Vec3d& v) { return std::hypot(v.x, v.y) < tolerance && v.z < 0; }

}  // namespace

Leg find_leg(const Model& model, int sole) {
  const auto links = joints_to(model, sole);
  if (links.size() != 6) refuse(model, fmt::format("{} joints between the base and its sole, not 6", links.size()));
  Leg leg;
  for (std::size_t i = 0; i < 6; ++i) {
    const Link& link = *links[i];
    const std::string& name = model.objects()[link.object].name;
    const double along = dot(link.axis, axes[i].direction);
    if (link.kind != LinkKind::revolute || link.turned || std::abs(std::abs(along) - 1) > tolerance) {
      refuse(model, fmt::format("'{}' is not a hinge about ({} {} {}) as the {} must be", name, axes[i].direction.x,
                                axes[i].direction.y, axes[i].direction.z, axes[i].joint));
    }
    leg.joints[i] = link.object;
    leg.signs[i] = along > 0 ? 1 : -1;
  }
  if (!vanishes(links[1]->offset) || !vanishes(links[2]->offset)) refuse(model, "its hip axes do not intersect");
  if (!points_down(links[3]->offset)) refuse(model, "its knee is not straight below its hip");
  if (!points_down(links[4]->offset)) refuse(model, "its ankle is not straight below its knee");
  if (!vanishes(links[5]->offset)) refuse(model, "its ankle axes do not intersect");
  leg.hip = links[0]->offset;
  leg.thigh = -links[3]->offset.z;
  leg.shin = -links[4]->offset.z;
  leg.ankle_height = -model.placement(sole).offset.z;
  return leg;
}

std::array<Leg, 2> find_legs(const Model& model) {
  const auto soles = model.having(properties::sole);
  if (soles.size() != 2) refuse(model, fmt::format("it has {} soles, not 2", soles.size()));
  std::array<Leg, 2> legs{find_leg(model, soles[0]), find_leg(model, soles[1])};
  if (legs[0].hip.y < legs[1].hip.y) std::swap(legs[0], legs[1]);
  return legs;
}

}  // namespace murosimf::control
