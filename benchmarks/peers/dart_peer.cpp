/// murosimf_peer_dart - DART in a race. Joints have coordinates; rotors and dry friction are left out: a joint has no inertia of its own
/// there, and its friction doubles the time. A servo is one of DART's, which brings the joint to the velocity at which ours would move
/// without load, as far as its limit goes: it does not give way as ours does. (Springs and dampers of DART's joints are implicit, but its
/// contacts do not know of them: a robot that stands on these leans by 0.1 rad.) Its own collision detector is the fastest and knows
/// spheres and boxes only: capsules are boxes here.
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/config.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include <algorithm>

#include "benchmarks/peers/peer.h"

namespace {

using peers::Description, peers::Link, peers::Shape, peers::Start;

Eigen::Vector3d vector(const peers::Vector& v) { return {v[0], v[1], v[2]}; }

Eigen::Isometry3d frame(const peers::Vector& position, const peers::Quaternion& q) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = vector(position);
  T.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  return T;
}

class Dart final : public peers::Engine {
 public:
  explicit Dart(const Description& description) : description_(description), world_(dart::simulation::World::create()) {
    world_->setTimeStep(description_.step);
    world_->setGravity({0, 0, -9.81});
    world_->getConstraintSolver()->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
    add_statics();
    for (const Start& start : description_.robots) add_robot(start);
  }

  void set_targets(std::span<const double> targets) override { targets_ = targets; }
  void step() override {
    drive();
    world_->step();
  }

  peers::View view() override {
    peers::View view;
    for (const auto& robot : robots_) {
      const Eigen::Isometry3d& base = robot->getBodyNode(0)->getWorldTransform();
      const Eigen::Vector3d r = base.translation();
      peers::View::Robot shown{{r.x(), r.y(), r.z()}, base.linear()(2, 2), {}};
      for (std::size_t i = 1; i <= description_.joints(); ++i)
        shown.joints.push_back(robot->getJoint(i)->getPosition(0));
      view.robots.push_back(std::move(shown));
    }
    for (const auto& contact : world_->getLastCollisionResult().getContacts()) {
      ++view.contacts;
      view.depth = std::max(view.depth, contact.penetrationDepth);
    }
    return view;
  }

 private:
  void drive() {
    std::size_t k = 0;
    for (const auto& robot : robots_) {
      for (std::size_t i = 1; i <= description_.joints(); ++i) {
        const Link& link = description_.links[i];
        const double error = targets_[k++] - robot->getJoint(i)->getPosition(0);
        robot->getJoint(i)->setCommand(0, link.gain * error / (description_.step * link.gain + link.damping));
      }
    }
  }

  static dart::dynamics::ShapePtr make(const Shape& shape) {
    const auto& s = shape.size;
    if (shape.kind == "sphere") return std::make_shared<dart::dynamics::SphereShape>(s[0]);
    if (shape.kind == "box") return std::make_shared<dart::dynamics::BoxShape>(2 * vector(s));
    return std::make_shared<dart::dynamics::BoxShape>(Eigen::Vector3d(2 * s[0], 2 * s[0], 2 * (s[0] + s[1])));
  }

  void add_shape(dart::dynamics::BodyNode& body, const Shape& shape) const {
    auto* node = body.createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(make(shape));
    node->setRelativeTransform(frame(shape.position, shape.rotation));
    node->getDynamicsAspect()->setFrictionCoeff(description_.friction);
    node->getDynamicsAspect()->setRestitutionCoeff(0);
  }

  void add_statics() {
    const auto ground = dart::dynamics::Skeleton::create("ground");
    auto& body = *ground->createJointAndBodyNodePair<dart::dynamics::WeldJoint>().second;
    constexpr double half_size = 20, half_height = 0.1;  // [m]; neither detector knows planes well
    add_shape(body, {"box", {half_size, half_size, half_height}, {0, 0, -half_height}, {1, 0, 0, 0}});
    for (const Shape& shape : description_.statics) add_shape(body, shape);
    ground->setMobile(false);
    world_->addSkeleton(ground);
  }

  void set_joint(dart::dynamics::Joint& joint, const Link& link) const {
    joint.setTransformFromParentBodyNode(frame(link.offset, link.rotation));
    joint.setActuatorType(dart::dynamics::Joint::SERVO);
    joint.setForceLowerLimit(0, -link.limit);
    joint.setForceUpperLimit(0, link.limit);
  }

  dart::dynamics::BodyNode* add_link(dart::dynamics::Skeleton& robot, const Link& link) const {
    // names that are taken are said so in lines of standard output
    const dart::dynamics::BodyNode::Properties named(dart::dynamics::BodyNode::AspectProperties("link " + link.joint));
    if (link.parent < 0) return robot.createJointAndBodyNodePair<dart::dynamics::FreeJoint>(nullptr, {}, named).second;
    dart::dynamics::RevoluteJoint::Properties properties;
    properties.mName = link.joint;
    properties.mAxis = vector(link.axis);
    auto* parent = robot.getBodyNode(static_cast<std::size_t>(link.parent));
    const auto [joint, body] =
        robot.createJointAndBodyNodePair<dart::dynamics::RevoluteJoint>(parent, properties, named);
    set_joint(*joint, link);
    return body;
  }

  void add_robot(const Start& start) {
    const auto robot = dart::dynamics::Skeleton::create("robot" + std::to_string(robots_.size()));
    for (const Link& link : description_.links) {
      auto& body = *add_link(*robot, link);
      const auto& I = link.inertia;
      body.setInertia(dart::dynamics::Inertia(link.mass, vector(link.center),
                                              (Eigen::Matrix3d() << I[0], I[3], I[4],  //
                                               I[3], I[1], I[5],                       //
                                               I[4], I[5], I[2])
                                                  .finished()));
      for (const Shape& shape : link.shapes) add_shape(body, shape);
    }
    robot->getJoint(0)->setPositions(
        dart::dynamics::FreeJoint::convertToPositions(frame(start.position, start.rotation)));
    for (std::size_t i = 1; i <= description_.joints(); ++i) robot->getJoint(i)->setPosition(0, start.joints[i - 1]);
    world_->addSkeleton(robot);
    robots_.push_back(robot);
  }

  const Description& description_;
  dart::simulation::WorldPtr world_;
  std::vector<dart::dynamics::SkeletonPtr> robots_;
  std::span<const double> targets_;
};

}  // namespace

int main(int count, char** arguments) {
  return peers::race(count, arguments, "DART " DART_VERSION, {"usual"},
                     [](const Description& description, const peers::Options&) {
                       return std::make_unique<Dart>(description);
                     });
}
