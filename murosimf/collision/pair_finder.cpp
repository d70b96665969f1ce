#include "murosimf/collision/pair_finder.h"

#include "murosimf/collision/contact_parameters.h"

namespace murosimf::collision {
namespace {

constexpr double fastest_walker = 3.0;  // [m/s] speed of an unpushable body's point that counts

/// The one of less mass; a model without any can only be moved kinematically and does not count.
const Model& lighter(const Model& a, const Model& b) {
  const double mass_a = a.tree().mass, mass_b = b.tree().mass;
  return mass_b > 0 && (mass_b < mass_a || mass_a == 0) ? b : a;
}

std::uint64_t key_of(int a, int b, std::size_t shape_a, std::size_t shape_b) {
  return static_cast<std::uint64_t>(a) << 48 | static_cast<std::uint64_t>(b) << 32 | shape_a << 16 | shape_b;
}

/// A kinematic robot may change its standing foot within a step: that must not shoot the ball.
Vec3d velocity_that_counts(const Mover& mover, int object, const Vec3d& arm) {
  const Vec3d v = mover.velocity_at(object, arm);
  const double speed = norm(v);
  return mover.can_be_pushed() || speed <= fastest_walker ? v : (fastest_walker / speed) * v;
}

void remember(PairSet& set) {
  auto old = set.previous.begin();
  for (PairContact& c : set.points) {
    while (old != set.previous.end() && old->key < c.key) ++old;
    if (old == set.previous.end() || old->key != c.key) continue;
    recall(*old, c);
  }
}

}  // namespace

PairFinder::PairFinder(const std::vector<Mover>& movers, const MaterialTable& materials, double gravity, double dt) {
  for (const Mover& mover : movers) {
    auto& kinds = kinds_of_shapes_.emplace_back();
    for (const GroundShape& shape : mover.shapes) kinds.push_back(kind_of(mover.model(), shape.placed.surface));
  }
  for (const Kind& a : kinds_) {
    for (const Kind& b : kinds_) {
      parameters_.push_back(
          contact_parameters(lighter(*a.model, *b.model), materials.find(a.surface, b.surface), gravity, dt));
    }
  }
}

std::size_t PairFinder::kind_of(const Model& model, const Surface& surface) {
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const Surface& known = kinds_[i].surface;
    if (kinds_[i].model == &model && known.material == surface.material && known.friction == surface.friction) return i;
  }
  kinds_.push_back({&model, surface});
  return kinds_.size() - 1;
}

void PairFinder::find(const std::vector<Mover>& movers, PairSet& set) {
  set.previous.swap(set.points);
  set.points.clear();
  for (int a = 0; a < static_cast<int>(movers.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(movers.size()); ++b) {
      const Mover &first = movers[a], &second = movers[b];
      if (first.entity->frozen() || second.entity->frozen()) continue;
      if (!first.can_be_pushed() && !second.can_be_pushed()) continue;
      const Vec3d way = first.r[0] - second.r[0];
      const double near = first.reach + second.reach;
      if (dot(way, way) < near * near) find_between(movers, a, b, set);
    }
  }
  remember(set);
}

void PairFinder::place_shapes(const Mover& mover, std::vector<PlacedInWorld>& placed) {
  placed.clear();
  for (const GroundShape& shape : mover.shapes) {
    const int o = shape.object;
    placed.push_back(
        {&shape.placed.shape, mover.r[o] + mover.R[o] * shape.placed.position, mover.R[o] * shape.placed.orientation});
  }
}

void PairFinder::find_between(const std::vector<Mover>& movers, int a, int b, PairSet& set) {
  const Mover &first = movers[a], &second = movers[b];
  place_shapes(first, shapes_a_);
  place_shapes(second, shapes_b_);
  for (std::size_t i = 0; i < shapes_a_.size(); ++i) {
    for (std::size_t j = 0; j < shapes_b_.size(); ++j) {
      const Vec3d way = shapes_a_[i].position - shapes_b_[j].position;
      const double near = first.shapes[i].reach + second.shapes[j].reach;
      if (dot(way, way) > near * near || !can_touch(*shapes_a_[i].shape, *shapes_b_[j].shape)) continue;
      const auto touch = find_touch(shapes_a_[i], shapes_b_[j]);
      if (!touch) continue;
      PairContact c;
      c.object = first.shapes[i].object;
      c.object_b = second.shapes[j].object;
      c.a = a;
      c.b = b;
      c.key = key_of(a, b, i, j);
      c.surface = static_cast<std::uint32_t>(kinds_of_shapes_[a][i] * kinds_.size() + kinds_of_shapes_[b][j]);
      c.point = touch->point;
      c.normal = touch->normal;
      c.depth = touch->depth;
      c.arm_a = c.point - first.r[c.object];
      c.arm_b = c.point - second.r[c.object_b];
      c.velocity_a = velocity_that_counts(first, c.object, c.arm_a);
      c.velocity_b = velocity_that_counts(second, c.object_b, c.arm_b);
      c.velocity = c.velocity_a - c.velocity_b;
      set.points.push_back(c);
    }
  }
}

}  // namespace murosimf::collision
