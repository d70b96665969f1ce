/// fcl_world.h - the shapes of a description's robots in FCL, moved as our entities move.
#pragma once

#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "benchmarks/peers/description.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/entity.h"

namespace peers {

using murosimf::Entity, murosimf::Mat3d, murosimf::Vec3d;

using Tree = fcl::DynamicAABBTreeCollisionManagerd;

inline std::shared_ptr<fcl::CollisionGeometryd> geometry(const Shape& shape) {
  const auto& s = shape.size;
  if (shape.kind == "sphere") return std::make_shared<fcl::Sphered>(s[0]);
  if (shape.kind == "capsule") return std::make_shared<fcl::Capsuled>(s[0], 2 * s[1]);
  return std::make_shared<fcl::Boxd>(2 * s[0], 2 * s[1], 2 * s[2]);
}

/// A shape of a robot in FCL, and where it is on its link.
struct Body {
  Body(const Shape& shape, int robot, int link) : object(geometry(shape)), robot(robot), link(link) {
    const auto& q = shape.rotation;
    place.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    place.translation() << shape.position[0], shape.position[1], shape.position[2];
    object.setUserData(this);
  }
  fcl::CollisionObjectd object;
  fcl::Transform3d place = fcl::Transform3d::Identity();
  int robot, link;
};

struct Found {
  fcl::CollisionRequestd request{8, true};
  int touching = 0;
};

/// Exact test of two shapes whose volumes overlap; FCL's callback.
inline bool test(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto& found = *static_cast<Found*>(data);
  const auto* first = static_cast<const Body*>(a->getUserData());
  const auto* second = static_cast<const Body*>(b->getUserData());
  if (first && second && first->robot == second->robot) return false;
  fcl::CollisionResultd result;
  fcl::collide(a, b, found.request, result);
  found.touching += result.isCollision();
  return false;
}

class FclWorld {
 public:
  FclWorld(const Description& description, bool tree_per_robot)
      : ground_(std::make_shared<fcl::Boxd>(2 * half_size, 2 * half_size, 2 * half_height)) {
    fcl::Transform3d low = fcl::Transform3d::Identity();
    low.translation().z() = -half_height;
    ground_.setTransform(low);
    ground_.computeAABB();
    ground_.setUserData(nullptr);  // FCL leaves it as it is
    for (std::size_t robot = 0; robot < description.robots.size(); ++robot) {
      if (trees_.empty() || tree_per_robot) trees_.push_back(std::make_unique<Tree>());
      for (std::size_t link = 0; link < description.links.size(); ++link) {
        for (const Shape& shape : description.links[link].shapes) {
          bodies_.push_back(std::make_unique<Body>(shape, static_cast<int>(robot), static_cast<int>(link)));
          trees_.back()->registerObject(&bodies_.back()->object);
        }
      }
    }
    for (auto& tree : trees_) tree->setup();
  }

  /// Pairs of shapes of different robots that touch.
  int robots(const std::vector<const Entity*>& entities) {
    for (auto& body : bodies_) move(*body, *entities[static_cast<std::size_t>(body->robot)]);
    for (auto& tree : trees_) tree->update();
    Found found;
    if (trees_.size() == 1) trees_[0]->collide(&found, &test);
    for (std::size_t a = 0; trees_.size() > 1 && a < trees_.size(); ++a) {
      for (std::size_t b = a + 1; b < trees_.size(); ++b) trees_[a]->collide(trees_[b].get(), &found, &test);
    }
    return found.touching;
  }
  int ground() {
    Found found;
    for (auto& tree : trees_) tree->collide(&ground_, &found, &test);
    return found.touching;
  }

 private:
  static constexpr double half_size = 20, half_height = 0.5;  // [m]; a half space has no volume for the trees

  static void move(Body& body, const Entity& entity) {
    const auto object =
        static_cast<std::size_t>(entity.model().tree().links[static_cast<std::size_t>(body.link)].object);
    const Vec3d& r = entity.find(murosimf::properties::position)->values[object];
    const Mat3d& R = entity.find(murosimf::properties::orientation)->values[object];
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.linear() << R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z;
    pose.translation() << r.x, r.y, r.z;
    body.object.setTransform(pose * body.place);
    body.object.computeAABB();
  }

  fcl::CollisionObjectd ground_;
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<std::unique_ptr<Tree>> trees_;
};

}  // namespace peers
