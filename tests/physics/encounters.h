/// encounters.h - bodies that meet: how deep they overlap, asked from geometry alone, and a pitch with goals.
#pragma once

#include <algorithm>

#include "murosimf/collision/queries.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene_file/field.h"
#include "tests/physics/rig.h"

namespace murosimf::test {

/// How deep [m] two entities, or a body of one, overlap; 0 if they do not.
class Overlap {
 public:
  Overlap(const World& world, const collision::BodyRef& a, const collision::BodyRef& b) : scene_(world), a_(a), b_(b) {}
  double now() {
    scene_.refresh();
    const auto found = scene_.distance(a_, b_);
    return found ? std::max(0.0, -found->distance) : 0;
  }

 private:
  collision::QueryScene scene_;
  collision::BodyRef a_, b_;
};

/// [N s]
inline Vec3d linear_momentum(Entity& e) { return e.base().get(properties::total_mass) * Rig::velocity(e); }

/// A rig whose ground is the field of 2008, with both goals.
struct Pitch : Rig {
  explicit Pitch(double rate_hz = 1000, int threads = 1) : Rig(0.8, 0, rate_hz, threads) {
    materials = MaterialTable::standard();
    ground = &simulation.world().add("field", scene_file::field_model(size, "carpet"));
  }
  /// A box of the goal at x > 0.
  [[nodiscard]] scene_file::GoalBox goal_box(std::string_view name) const {
    for (const scene_file::GoalBox& box : scene_file::goal_boxes(size, 1)) {
      if (box.name == name) return box;
    }
    throw SetupError("no such box");
  }
  [[nodiscard]] collision::BodyRef body_of(const std::string& name) const {
    return {ground, ground->model().object_index(name)};
  }

  const scene_file::FieldSize& size = scene_file::kid_size_2008;
};

}  // namespace murosimf::test
