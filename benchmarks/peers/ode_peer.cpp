/// murosimf_peer_ode - ODE in a race. Bodies have six coordinates each, which hinges hold together; rotors are left out, since there a joint
/// has no inertia of its own, and so is dry friction. A servo is the motor of a hinge whose compliance, 1 / (h gain + damping),
/// makes it an implicit spring and damper; its limit holds for the sum of both.
#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/peers/ode_frame.h"
#include "benchmarks/peers/peer.h"

namespace {

using peers::Description, peers::Frame, peers::inside, peers::Link, peers::Shape, peers::Start;

struct Robot {
  std::vector<dBodyID> bodies;
  std::vector<dJointID> hinges;  // of links 1 and on
};

class Ode final : public peers::Engine {
 public:
  Ode(const Description& description, const std::string& setting)
      : description_(description),
        world_(dWorldCreate()),
        space_(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ)),
        contacts_(dJointGroupCreate(0)),
        exact_(setting == "worldstep") {
    dRandSetSeed(1);  // quickstep shuffles its rows
    dWorldSetGravity(world_, 0, 0, -9.81);
    if (!exact_) dWorldSetQuickStepNumIterations(world_, setting == "quickstep 50" ? 50 : 20);
    dCreatePlane(space_, 0, 0, 1, 0);
    for (const Shape& shape : description_.statics) place(make(shape, space_), shape);
    for (const Start& start : description_.robots) add_robot(start);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;
  ~Ode() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void set_targets(std::span<const double> targets) override { targets_ = targets; }

  void step() override {
    drive();
    count_ = 0;
    depth_ = 0;
    dSpaceCollide(space_, this, &Ode::near);
    if (exact_)
      dWorldStep(world_, description_.step);
    else
      dWorldQuickStep(world_, description_.step);
    dJointGroupEmpty(contacts_);
  }

  peers::View view() override {
    peers::View view;
    view.contacts = count_;
    view.depth = depth_;
    for (const Robot& robot : robots_) {
      const Frame base = base_of(robot);
      const double* R = dBodyGetRotation(robot.bodies[0]);
      peers::View::Robot shown{{base.r[0], base.r[1], base.r[2]}, R[10], {}};
      for (dJointID hinge : robot.hinges) {
        shown.joints.push_back(dJointGetHingeAngle(hinge));
        dVector3 a, b;
        dJointGetHingeAnchor(hinge, a);
        dJointGetHingeAnchor2(hinge, b);
        view.gap = std::max(view.gap, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
      }
      view.robots.push_back(std::move(shown));
    }
    return view;
  }

 private:
  static dGeomID make(const Shape& shape, dSpaceID space) {
    if (shape.kind == "sphere") return dCreateSphere(space, shape.size[0]);
    if (shape.kind == "capsule") return dCreateCapsule(space, shape.size[0], 2 * shape.size[1]);
    return dCreateBox(space, 2 * shape.size[0], 2 * shape.size[1], 2 * shape.size[2]);
  }
  static void place(dGeomID geom, const Shape& shape) {
    const dQuaternion q{shape.rotation[0], shape.rotation[1], shape.rotation[2], shape.rotation[3]};
    dGeomSetPosition(geom, shape.position[0], shape.position[1], shape.position[2]);
    dGeomSetQuaternion(geom, q);
  }

  /// The origin of a body is its center of mass, that of a link is not.
  Frame base_of(const Robot& robot) const {
    Frame base{};
    std::copy_n(dBodyGetPosition(robot.bodies[0]), 3, base.r);
    std::copy_n(dBodyGetQuaternion(robot.bodies[0]), 4, base.q);
    const peers::Vector& c = description_.links[0].center;
    return inside(base, {-c[0], -c[1], -c[2]}, {1, 0, 0, 0});
  }

  dBodyID add_body(const Link& link, const Frame& frame, dSpaceID space) {
    dBodyID body = dBodyCreate(world_);
    dMass mass;
    const auto& I = link.inertia;
    dMassSetParameters(&mass, link.mass, 0, 0, 0, I[0], I[1], I[2], I[3], I[4], I[5]);
    dBodySetMass(body, &mass);
    const Frame center = inside(frame, link.center, {1, 0, 0, 0});
    dBodySetPosition(body, center.r[0], center.r[1], center.r[2]);
    dBodySetQuaternion(body, frame.q);
    for (const Shape& shape : link.shapes) {
      dGeomID geom = make(shape, space);
      dGeomSetBody(geom, body);
      const auto& p = shape.position;
      const dQuaternion q{shape.rotation[0], shape.rotation[1], shape.rotation[2], shape.rotation[3]};
      dGeomSetOffsetPosition(geom, p[0] - link.center[0], p[1] - link.center[1], p[2] - link.center[2]);
      dGeomSetOffsetQuaternion(geom, q);
    }
    return body;
  }

  void add_robot(const Start& start) {
    Robot robot;
    dSpaceID space = dSimpleSpaceCreate(space_);
    // as the model is at joint positions 0: there a hinge of ODE takes its zero; then moved to where the robot starts
    const auto straight = frames(description_.links, start, false), bent = frames(description_.links, start, true);
    for (std::size_t i = 0; i < description_.links.size(); ++i) {
      const Link& link = description_.links[i];
      robot.bodies.push_back(add_body(link, straight[i], space));
      if (link.parent < 0) continue;
      dJointID hinge = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge, robot.bodies[i], robot.bodies[static_cast<std::size_t>(link.parent)]);
      dJointSetHingeAnchor(hinge, straight[i].r[0], straight[i].r[1], straight[i].r[2]);
      const Frame tip = inside(straight[i], link.axis, {1, 0, 0, 0});
      dJointSetHingeAxis(hinge, tip.r[0] - straight[i].r[0], tip.r[1] - straight[i].r[1], tip.r[2] - straight[i].r[2]);
      dJointSetHingeParam(hinge, dParamFMax, link.limit);
      dJointSetHingeParam(hinge, dParamCFM, compliance(link));
      robot.hinges.push_back(hinge);
    }
    for (std::size_t i = 0; i < bent.size(); ++i) {
      const Frame center = inside(bent[i], description_.links[i].center, {1, 0, 0, 0});
      dBodySetPosition(robot.bodies[i], center.r[0], center.r[1], center.r[2]);
      dBodySetQuaternion(robot.bodies[i], bent[i].q);
    }
    robots_.push_back(std::move(robot));
  }

  double compliance(const Link& link) const { return 1 / (description_.step * link.gain + link.damping); }

  void drive() {
    std::size_t k = 0;
    for (const Robot& robot : robots_) {
      for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
        const Link& link = description_.links[i + 1];
        const double error = targets_[k++] - dJointGetHingeAngle(robot.hinges[i]);
        dJointSetHingeParam(robot.hinges[i], dParamVel, link.gain * error * compliance(link));
      }
    }
  }

  static void near(void* self, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b))
      dSpaceCollide2(a, b, self, &Ode::near);
    else
      static_cast<Ode*>(self)->collide(a, b);
  }

  void collide(dGeomID a, dGeomID b) {
    constexpr int most = 8;
    dContact contacts[most];
    dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (!body_a && !body_b) return;
    const int found = dCollide(a, b, most, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < found; ++i) {
      contacts[i].surface.mode = dContactApprox1;
      contacts[i].surface.mu = description_.friction;
      dJointAttach(dJointCreateContact(world_, contacts_, &contacts[i]), body_a, body_b);
      depth_ = std::max(depth_, contacts[i].geom.depth);
    }
    count_ += found;
  }

  const Description& description_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  bool exact_;
  std::vector<Robot> robots_;
  std::span<const double> targets_;
  int count_ = 0;     // of the last step
  double depth_ = 0;  // [m] likewise
};

}  // namespace

int main(int count, char** arguments) {
  dInitODE2(0);
  const int result = peers::race(count, arguments, "ODE " dODE_VERSION, {"quickstep 20", "quickstep 50", "worldstep"},
                                 [](const Description& description, const peers::Options& options) {
                                   return std::make_unique<Ode>(description, options.setting);
                                 });
  dCloseODE();
  return result;
}
