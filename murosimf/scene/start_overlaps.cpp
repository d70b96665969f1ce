#include "murosimf/scene/start_overlaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "murosimf/collision/compound.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/geometry/collide.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene {
namespace {

constexpr double deepest_contact = 5e-3;  // [m] ordinary contact of feet and balls is below 1 mm
constexpr std::size_t most_pairs = 5;     // limit of listed pairs

/// Data shared by equal entities.
struct EntityKind {
  explicit EntityKind(const Model& model)
      : reach(collision::farthest_reach(model)), ground_shapes(collision::ground_shapes(model)) {}

  double reach;  ///< [m] of all shapes about the base
  std::vector<collision::GroundShape> ground_shapes;
  std::optional<collision::Compound> compound;  ///< made when another entity is near
};

/// An entity in its present pose.
struct Standing {
  Standing(const Entity& of, EntityKind& its_kind) : entity(&of), kind(&its_kind) {
    if (const auto* place = of.find(properties::position)) r = place->values;
    if (const auto* attitude = of.find(properties::orientation)) R = attitude->values;
    if (!r.empty() && !R.empty()) return;
    for (const Transformd& pose : collision::rest_poses(of.model())) {
      r.push_back(pose.position);
      R.push_back(pose.orientation);
    }
    MUROSIMF_ASSERT(!r.empty() && r.size() == R.size());
  }

  const Entity* entity;
  EntityKind* kind;
  std::vector<Vec3d> r;  ///< [m] of its objects
  std::vector<Mat3d> R;
  std::optional<collision::Compound> compound;
  bool moves = true;
};

/// Entities of the same kind share their shapes.
collision::Compound& compound_where(Standing& standing) {
  if (standing.compound) return *standing.compound;
  auto& shared = standing.kind->compound;
  if (!shared) {
    const Model& model = standing.entity->model();
    shared.emplace(model, collision::CompoundOptions{.structured = !model.joints().empty()});
  }
  standing.compound = shared;
  standing.compound->refit(standing.r, standing.R);
  return *standing.compound;
}

struct OverlapBodies {
  int a = 0, b = 0;
};

double depth_of(const geometry::Manifold& manifold) {
  double depth = 0;
  for (int i = 0; i < manifold.count; ++i) depth = std::max(depth, manifold.points[i].depth);
  return depth;
}

/// The first overlapping bodies found.
std::optional<OverlapBodies> first_overlap(Standing& one, Standing& other) {
  const collision::Compound &a = compound_where(one), &b = compound_where(other);
  std::optional<OverlapBodies> found;
  const auto test = [&](int i, int j) {
    const collision::CollidingShape &first = a.shapes()[i], &second = b.shapes()[j];
    geometry::Manifold manifold;
    if (geometry::collide(first.placed.shape, a.pose(i, one.r, one.R), second.placed.shape, b.pose(j, other.r, other.R),
                          manifold) &&
        depth_of(manifold) > deepest_contact) {
      found = OverlapBodies{first.object, second.object};
    }
    return !found;
  };
  // surface kinds matter for static bodies only; moving entities touch each other in any case (model/shape.h)
  if (other.moves) {
    (void)collision::for_pairs(a, b, test);
  } else {
    (void)collision::for_pairs(a, b, collision::only_touching(a, b, test));
  }
  return found;
}

std::string name_in(const Standing& standing, int object) { return standing.entity->model().objects()[object].name; }

std::string overlap_line(const Standing& one, const Standing& other, const OverlapBodies& objects) {
  return fmt::format("{} and {} overlap at the start ('{}' is in '{}'): contact pushes them apart", one.entity->name(),
                     other.entity->name(), name_in(one, objects.a), name_in(other, objects.b));
}

/// [m] Lowest point relative to the plane z = 0, if it can be below it.
double lowest_of(const Standing& standing) {
  const collision::GroundPlane ground;
  double lowest = std::numeric_limits<double>::infinity();
  if (standing.r[0].z > standing.kind->reach) return lowest;
  for (const auto& shape : standing.kind->ground_shapes) {
    if (!may_touch(shape.placed, ground)) continue;
    lowest =
        std::min(lowest, collision::lowest_point(shape, standing.r[shape.object], standing.R[shape.object], ground));
  }
  return lowest;
}

bool are_near(const Standing& a, const Standing& b) { return norm(a.r[0] - b.r[0]) <= a.kind->reach + b.kind->reach; }

/// All present entities; static ones last.
class Scenery {
 public:
  Scenery(const Entity& field, std::span<Entity* const> moving_entities) {
    // reserved: references to elements are kept while others are added
    standing_.reserve(moving_entities.size() + 1);
    for (const Entity* moving_entity : moving_entities) {
      if (moving_entity->present()) add(*moving_entity);
    }
    add(field).moves = false;
  }

  [[nodiscard]] std::vector<Standing>& standing() { return standing_; }

 private:
  Standing& add(const Entity& entity) {
    EntityKind& kind = kinds_.try_emplace(&entity.model(), entity.model()).first->second;
    return standing_.emplace_back(entity, kind);
  }

  std::map<const Model*, EntityKind> kinds_;
  std::vector<Standing> standing_;
};

/// Adds overlapping pairs, each once; only those of one entity, if given. At most `most_pairs`.
void add_overlaps(std::vector<Standing>& standing, const Entity* of, std::vector<std::string>& lines) {
  for (std::size_t i = 0; i + 1 < standing.size(); ++i) {
    for (std::size_t j = i + 1; j < standing.size(); ++j) {
      if (of && standing[i].entity != of && standing[j].entity != of) continue;
      if (!are_near(standing[i], standing[j])) continue;
      const auto found = first_overlap(standing[i], standing[j]);
      if (!found) continue;
      if (lines.size() == most_pairs) {
        lines.emplace_back("others overlap at the start, too");
        return;
      }
      lines.push_back(overlap_line(standing[i], standing[j], *found));
    }
  }
}

void add_sunken(const std::vector<Standing>& standing, const Entity* of, std::vector<std::string>& lines) {
  for (const Standing& one : standing) {
    if (of && one.entity != of) continue;
    const double lowest = one.moves ? lowest_of(one) : 0;
    if (lowest >= -deepest_contact) continue;
    lines.push_back(fmt::format("{} is in the ground by {:.0f} mm at the start: contact pushes it out",
                                one.entity->name(), -1e3 * lowest));
  }
}

std::vector<std::string> overlap_lines(const Entity* of, const Entity& field,
                                       std::span<Entity* const> moving_entities) {
  Scenery scenery(field, moving_entities);
  std::vector<std::string> lines;
  add_overlaps(scenery.standing(), of, lines);
  add_sunken(scenery.standing(), of, lines);
  return lines;
}

}  // namespace

std::vector<std::string> start_overlaps(const Entity& field, std::span<Entity* const> moving_entities) {
  return overlap_lines(nullptr, field, moving_entities);
}

std::vector<std::string> overlaps_of(const Entity& entity, const Entity& field,
                                     std::span<Entity* const> moving_entities) {
  return overlap_lines(&entity, field, moving_entities);
}

}  // namespace murosimf::scene
