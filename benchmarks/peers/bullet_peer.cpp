/// murosimf_peer_bullet - Bullet's multi-bodies in a race. Joints have coordinates; rotors and dry friction are left out, since there a
/// joint has neither. A servo is a motor that brings the joint to the velocity at which ours would move without load, as far as its
/// limit goes: it does not give way as ours does.
#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "benchmarks/peers/peer.h"

namespace {

using peers::Description, peers::Link, peers::Shape, peers::Start;

btVector3 vector(const peers::Vector& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}
btQuaternion quaternion(const peers::Quaternion& q) {  // x y z w there
  return {static_cast<btScalar>(q[1]), static_cast<btScalar>(q[2]), static_cast<btScalar>(q[3]),
          static_cast<btScalar>(q[0])};
}

btVector3 principal(const Link& link) {
  const auto& I = link.inertia;
  if (std::max({std::abs(I[3]), std::abs(I[4]), std::abs(I[5])}) > 1e-9) {
    throw std::runtime_error("link '" + link.joint + "' has products of inertia, which this peer leaves out");
  }
  return vector({I[0], I[1], I[2]});
}

class Bullet final : public peers::Engine {
 public:
  Bullet(const Description& description, const std::string& setting)
      : description_(description),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, btScalar(-9.81)});
    world_.getSolverInfo().m_numIterations = setting == "50 iterations" ? 50 : 10;
    if (description_.robots.size() > 30) throw std::runtime_error("more than 30 robots: there is a bit for each");
    add_static(keep(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0))), btTransform::getIdentity());
    for (const Shape& shape : description_.statics) {
      add_static(make(shape), btTransform(quaternion(shape.rotation), vector(shape.position)));
    }
    for (const Start& start : description_.robots) add_robot(start);
  }
  ~Bullet() override {  // the world does not own what it has, and looks at it when it goes
    for (auto& motor : motors_) world_.removeMultiBodyConstraint(motor.get());
    for (auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    for (auto& robot : robots_) world_.removeMultiBody(robot.get());
  }

  void set_targets(std::span<const double> targets) override {
    const double h = description_.step;
    for (std::size_t k = 0; k < motors_.size(); ++k) {
      const Link& link = description_.links[k % description_.joints() + 1];
      motors_[k]->setVelocityTarget(0, 1);
      motors_[k]->setPositionTarget(static_cast<btScalar>(targets[k]),
                                    static_cast<btScalar>(h * link.gain / (h * link.gain + link.damping)));
    }
  }
  void step() override { world_.stepSimulation(static_cast<btScalar>(description_.step), 0); }

  peers::View view() override {
    peers::View view;
    for (const auto& robot : robots_) {
      const btTransform base = robot->getBaseWorldTransform();
      const btVector3 origin = base * (-vector(description_.links[0].center));
      peers::View::Robot shown{{origin.x(), origin.y(), origin.z()}, base.getBasis()[2][2], {}};
      for (int i = 0; i < robot->getNumLinks(); ++i) shown.joints.push_back(robot->getJointPos(i));
      view.robots.push_back(std::move(shown));
    }
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) count(*dispatcher_.getManifoldByIndexInternal(i), view);
    return view;
  }

 private:
  static constexpr int static_bit = 1 << 30;

  static void count(const btPersistentManifold& manifold, peers::View& view) {
    view.contacts += manifold.getNumContacts();  // the solver has those that do not touch yet, too
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      view.depth = std::max(view.depth, -static_cast<double>(manifold.getContactPoint(k).getDistance()));
    }
  }

  btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape) {
    shapes_.push_back(std::move(shape));
    return shapes_.back().get();
  }
  btCollisionShape* make(const Shape& shape) {
    const auto a = static_cast<btScalar>(shape.size[0]);
    if (shape.kind == "sphere") return keep(std::make_unique<btSphereShape>(a));
    if (shape.kind == "capsule")
      return keep(std::make_unique<btCapsuleShapeZ>(a, static_cast<btScalar>(2 * shape.size[1])));
    return keep(std::make_unique<btBoxShape>(vector(shape.size)));
  }
  btCollisionShape* make(const Link& link) {
    auto compound = std::make_unique<btCompoundShape>();
    for (const Shape& shape : link.shapes) {
      const btVector3 center = vector(shape.position) - vector(link.center);
      compound->addChildShape(btTransform(quaternion(shape.rotation), center), make(shape));
    }
    return keep(std::move(compound));
  }

  void add_collider(std::unique_ptr<btCollisionObject> collider, int group, int mask) {
    collider->setFriction(static_cast<btScalar>(std::sqrt(description_.friction)));  // there the pair has the product
    world_.addCollisionObject(collider.get(), group, mask);
    colliders_.push_back(std::move(collider));
  }
  void add_static(btCollisionShape* shape, const btTransform& place) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shape);
    object->setWorldTransform(place);
    add_collider(std::move(object), static_bit, ~static_bit);
  }

  void add_robot(const Start& start) {
    const auto& links = description_.links;
    const int joints = static_cast<int>(description_.joints());
    auto robot =
        std::make_unique<btMultiBody>(joints, static_cast<btScalar>(links[0].mass), principal(links[0]), false, false);
    for (int i = 0; i < joints; ++i) {
      const Link& link = links[static_cast<std::size_t>(i) + 1];
      const btVector3 pivot = vector(link.offset) - vector(links[static_cast<std::size_t>(link.parent)].center);
      robot->setupRevolute(i, static_cast<btScalar>(link.mass), principal(link), link.parent - 1,
                           quaternion(link.rotation).inverse(), vector(link.axis), pivot, vector(link.center), true);
    }
    robot->finalizeMultiDof();
    robot->setLinearDamping(0);
    robot->setAngularDamping(0);
    robot->setHasSelfCollision(false);
    const btTransform base(quaternion(start.rotation), vector(start.position));
    robot->setBaseWorldTransform(btTransform(base.getRotation(), base * vector(links[0].center)));
    for (int i = 0; i < joints; ++i)
      robot->setJointPos(i, static_cast<btScalar>(start.joints[static_cast<std::size_t>(i)]));
    world_.addMultiBody(robot.get());
    const int bit = 1 << robots_.size();
    for (int i = -1; i < joints; ++i) add_link(*robot, i, bit);
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    robot->forwardKinematics(turns, places);
    robot->updateCollisionObjectWorldTransforms(turns, places);
    robots_.push_back(std::move(robot));
  }

  void add_link(btMultiBody& robot, int i, int bit) {
    const Link& link = description_.links[static_cast<std::size_t>(i + 1)];
    if (!link.shapes.empty()) {
      auto collider = std::make_unique<btMultiBodyLinkCollider>(&robot, i);
      collider->setCollisionShape(make(link));
      if (i < 0)
        robot.setBaseCollider(collider.get());
      else
        robot.getLink(i).m_collider = collider.get();
      add_collider(std::move(collider), bit, ~bit);
    }
    if (i < 0) return;
    const auto impulse = static_cast<btScalar>(link.limit * description_.step);
    motors_.push_back(std::make_unique<btMultiBodyJointMotor>(&robot, i, btScalar(0), impulse));
    world_.addMultiBodyConstraint(motors_.back().get());
  }

  const Description& description_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> colliders_;
  std::vector<std::unique_ptr<btMultiBody>> robots_;
  std::vector<std::unique_ptr<btMultiBodyJointMotor>> motors_;
};

}  // namespace

int main(int count, char** arguments) {
  const std::string version = std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
  const std::string name = "Bullet " + version + (sizeof(btScalar) == sizeof(float) ? " (float)" : "");
  return peers::race(count, arguments, name, {"10 iterations", "50 iterations"},
                     [](const Description& description, const peers::Options& options) {
                       return std::make_unique<Bullet>(description, options.setting);
                     });
}
