#include "murosimf/io/start_overlaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "murosimf/collision/compound.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/geometry/collide.h"
#include "murosimf/model/properties.h"

namespace murosimf::io {
namespace {

constexpr double deepest_contact = 5e-3;  // [m] feet and balls sink in by less than 1 mm

/// An entity where it stands. Volumes are worked out if somebody comes near.
struct Standing {
  explicit Standing(const Entity& of) : entity(&of) {
    if (const auto* place = of.find(properties::position)) r = place->values;
    if (const auto* attitude = of.find(properties::orientation)) R = attitude->values;
    if (!r.empty() && !R.empty()) return;
    for (const geometry::Pose& pose : collision::rest_poses(of.model())) {
      r.push_back(pose.position);
      R.push_back(pose.orientation);
    }
  }

  const Entity* entity;
  std::vector<Vec3d> r;  ///< [m] of its objects
  std::vector<Mat3d> R;
  double reach = 0;  ///< [m] about its base
  bool moves = true;
  std::optional<collision::Compound> compound;
};

collision::Compound& compound_where(Standing& standing) {
  if (!standing.compound) {
    standing.compound.emplace(standing.entity->model(),
                              collision::CompoundOptions{.structured = !standing.entity->model().joints().empty()});
    standing.compound->refit(standing.r, standing.R);
  }
  return *standing.compound;
}

struct ObjectPair {
  int a = 0, b = 0;
};

double depth_of(const geometry::Manifold& manifold) {
  double depth = 0;
  for (int i = 0; i < manifold.count; ++i) depth = std::max(depth, manifold.points[i].depth);
  return depth;
}

/// The first bodies that are found in each other.
std::optional<ObjectPair> first_overlap(Standing& one, Standing& other) {
  const collision::Compound &a = compound_where(one), &b = compound_where(other);
  std::optional<ObjectPair> found;
  const auto test = [&](int i, int j) {
    const collision::CollidingShape &first = a.shapes()[i], &second = b.shapes()[j];
    geometry::Manifold manifold;
    if (geometry::collide(first.placed.shape, a.pose(i, one.r, one.R), second.placed.shape, b.pose(j, other.r, other.R),
                          manifold) &&
        depth_of(manifold) > deepest_contact) {
      found = ObjectPair{first.object, second.object};
    }
    return !found;
  };
  // kinds of shapes count on what stands still; between movers everything touches (model/shape.h)
  if (other.moves) {
    (void)collision::for_pairs(a, b, test);
  } else {
    (void)collision::for_pairs(a, b, collision::only_touching(a, b, test));
  }
  return found;
}

std::string name_in(const Standing& standing, int object) { return standing.entity->model().objects()[object].name; }

std::string overlap_line(const Standing& one, const Standing& other, const ObjectPair& objects) {
  return fmt::format("{} and {} overlap at the start ('{}' is in '{}'): contact pushes them apart", one.entity->name(),
                     other.entity->name(), name_in(one, objects.a), name_in(other, objects.b));
}

/// [m] above the plane z = 0.
double lowest_of(const Standing& standing) {
  double lowest = std::numeric_limits<double>::infinity();
  const collision::GroundPlane ground;
  for (const auto& shape : collision::ground_shapes(standing.entity->model())) {
    if (!may_touch(shape.placed, ground)) continue;
    lowest =
        std::min(lowest, collision::lowest_point(shape, standing.r[shape.object], standing.R[shape.object], ground));
  }
  return lowest;
}

bool are_near(const Standing& a, const Standing& b) { return norm(a.r[0] - b.r[0]) <= a.reach + b.reach; }

}  // namespace

std::vector<std::string> start_overlaps(const Entity& field, std::span<Entity* const> movers) {
  std::vector<std::string> lines;
  std::map<const Model*, double> reaches;
  std::vector<Standing> standing;
  standing.reserve(movers.size() + 1);
  for (const Entity* mover : movers) standing.emplace_back(*mover);
  standing.emplace_back(field).moves = false;
  for (Standing& s : standing) {
    const auto [known, is_new] = reaches.try_emplace(&s.entity->model(), 0);
    if (is_new) known->second = collision::farthest_reach(s.entity->model());
    s.reach = known->second;
  }
  for (std::size_t i = 0; i < movers.size(); ++i) {
    for (std::size_t j = i + 1; j < standing.size(); ++j) {
      if (!are_near(standing[i], standing[j])) continue;
      if (const auto found = first_overlap(standing[i], standing[j])) {
        lines.push_back(overlap_line(standing[i], standing[j], *found));
      }
    }
    if (const double lowest = lowest_of(standing[i]); lowest < -deepest_contact) {
      lines.push_back(fmt::format("{} is in the ground by {:.0f} mm at the start: contact pushes it out",
                                  movers[i]->name(), -1e3 * lowest));
    }
  }
  return lines;
}

}  // namespace murosimf::io
