/// pitch.h - a small world with bodies of every kind, for tests of questions about where they are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/world/world.h"
#include "tests/fixtures.h"

namespace murosimf::fixtures {

/// All shapes in the world, for a walk over all of them.
struct InWorld {
  const Entity* entity;
  int object, index;
  Shape shape;
  Transformd at;
};

/// Two robots with one shape of each kind on every limb, two balls, and a field with a plane, a wall and a sign that
/// does not collide.
class Pitch {
 public:
  Pitch() {
    Chain field;
    PlacedShape sign = placed(Box{{9, 9, 9}});
    sign.collides = false;
    field.base("field").with(properties::shapes,
                             {placed(Plane{}), sign, placed(Box{{0.05, 2, 0.3}}, {2, 0, 0.3}, rotation_z(0.2))});
    world.add("field", std::make_shared<const Model>("field", field));
    const auto robot = std::make_shared<const Model>(robot_of_all_shapes());
    const auto ball = std::make_shared<const Model>(fixtures::ball_model(0.1, 0.4));
    for (const char* name : {"red", "blue"}) world.add(name, robot);
    for (const char* name : {"ball", "spare"}) world.add(name, ball);
    for (const auto& entity : world.entities()) {
      if (entity->name() == "field") continue;  // it has no poses: it stands where its model says
      entity->column(properties::position);
      entity->column(properties::orientation);
    }
  }

  static Model robot_of_all_shapes() {
    Chain chain;
    chain.base("trunk").with(properties::shapes, {placed(Box{{0.1, 0.1, 0.1}})});
    int n = 0;
    for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
      chain.translation({0, 0, 0.2}).revolute("joint_" + std::to_string(n++), {1, 0, 0});
      chain.with(properties::shapes, {placed(shape, {0, 0.1, 0}, rotation_x(0.4)), placed(Sphere{0.03}, {0.2, 0, 0})});
    }
    return Model("stack", chain);
  }

  void shake(Dice& dice) {
    for (const auto& entity : world.entities()) {
      if (!entity->find(properties::position)) continue;
      auto& r = entity->column(properties::position).values;
      auto& R = entity->column(properties::orientation).values;
      std::vector<double> q(r.size());
      for (double& angle : q) angle = dice.uniform(-2, 2);
      r[0] = dice.vector(1) + Vec3d{0, 0, 1};
      R[0] = dice.turn();
      multibody::poses<double>(entity->model().tree(), q, std::span<Vec3d>(r), std::span<Mat3d>(R));
    }
  }

  [[nodiscard]] std::vector<InWorld> all() const {
    std::vector<InWorld> result;
    for (const auto& entity : world.entities()) {
      const auto* r = entity->find(properties::position);
      const auto* R = entity->find(properties::orientation);
      for (const int object : entity->model().bodies()) {
        const Transformd body = r ? Transformd{r->values[object], R->values[object]} : Transformd{};
        int index = 0;
        for (const PlacedShape& shape : *entity->model().find(properties::shapes, object)) {
          const Transformd at = body * shape.place();
          if (shape.collides) result.push_back({entity.get(), object, index, shape.shape, at});
          ++index;
        }
      }
    }
    return result;
  }

  World world;
};

}  // namespace murosimf::fixtures
