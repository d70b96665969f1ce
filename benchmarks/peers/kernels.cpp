/// murosimf_peer_kernels FOLDER --setting MuRoSimF --seconds 0.1 - what rigid-body algorithms cost on the robot of FOLDER, in ours, in eight
/// lanes, in Pinocchio. Prints processor time per call and robot [us], and the accelerations and torques that were found.
#include <cstdio>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/kernels.h"
#include "benchmarks/peers/options.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

constexpr double gravity = -9.81;

/// Ours on one robot (double) or eight equal ones (Pack8).
template <class S>
class Ours final : public peers::Kernels {
 public:
  explicit Ours(const Model& model, const peers::Description& description)
      : tree_(model.tree()),
        q_(static_cast<std::size_t>(model.size())),
        qd_(q_.size()),
        r_(q_.size()),
        R_(q_.size(), Mat3<S>{{S(1.0), S(0.0), S(0.0)}, {S(0.0), S(1.0), S(0.0)}, {S(0.0), S(0.0), S(1.0)}}),
        links_(tree_.links.size()),
        bodies_(links_.size()),
        force_(links_.size()),
        external_(links_.size()),
        qdd_(links_.size()),
        torque_(links_.size()) {
    const peers::KernelState state(description.joints());
    const auto& w = state.angular_velocity;
    w_ = {S(w[0]), S(w[1]), S(w[2])};
    for (std::size_t i = 1; i < links_.size(); ++i) {
      const auto object = static_cast<std::size_t>(tree_.links[i].object);
      q_[object] = S(state.q[i - 1]);
      qd_[object] = S(state.joint_velocity);
      qdd_[i] = S(state.joint_acceleration);
      bodies_[i].torque = S(state.torque[i - 1]);
      bodies_[i].added_inertia = S(description.links[i].armature);
    }
    if constexpr (std::is_same_v<S, double>) masses_.resize((links_.size() + 5) * (links_.size() + 5));
    composite_.resize(links_.size());
  }

  void kinematics() override { multibody::poses<S>(tree_, q_, r_, R_); }
  void inverse_dynamics() override {
    move();
    const Twist<S> up{{}, {S(0.0), S(0.0), S(-gravity)}};
    multibody::inverse_dynamics<S>(tree_, links_, up, qdd_, external_, force_, torque_);
  }
  void mass_matrix() override {
    move();
    if constexpr (std::is_same_v<S, double>) multibody::mass_matrix(tree_, links_, composite_, masses_);
  }
  void forward_dynamics() override {
    move();
    multibody::clear_loads<S>(bodies_);
    multibody::sweep_to_base<S>(tree_, links_, bodies_);
    const Wrench<S>& bias = bodies_[0].force;
    multibody::accelerate<S>(tree_, links_, bodies_, solve(bodies_[0].inertia, Wrench<S>{-bias.n, -bias.f}));
  }

  std::vector<double> accelerations() override {
    forward_dynamics();
    const Twist<S>& base = bodies_[0].acceleration;
    std::vector<double> result{first(base.w.x), first(base.w.y), first(base.w.z),
                               first(base.v.x), first(base.v.y), first(base.v.z) + gravity};
    for (std::size_t i = 1; i < bodies_.size(); ++i) result.push_back(first(bodies_[i].joint_acceleration));
    return result;
  }
  std::vector<double> torques() override {
    inverse_dynamics();
    std::vector<double> result;
    for (std::size_t i = 1; i < torque_.size(); ++i) result.push_back(first(torque_[i]));
    return result;
  }
  int robots() const override { return sizeof(S) / sizeof(double); }

 private:
  static double first(const S& value) {
    if constexpr (std::is_same_v<S, double>)
      return value;
    else
      return value.lane(0);
  }
  void move() {
    kinematics();
    multibody::link_motions<S>(tree_, r_, R_, w_, qd_, links_);
  }

  const Tree& tree_;
  std::vector<S> q_, qd_;
  Vec3<S> w_;
  std::vector<Vec3<S>> r_;
  std::vector<Mat3<S>> R_;
  std::vector<multibody::LinkMotion<S>> links_;
  std::vector<multibody::ArticulatedLink<S>> bodies_;
  std::vector<Wrench<S>> force_, external_;
  std::vector<S> qdd_, torque_;
  std::vector<double> masses_;
  std::vector<RigidInertia<double>> composite_;
};

/// [us] Processor time of a call and robot, over about `seconds`.
double time_of(peers::Kernels& kernels, void (peers::Kernels::*kernel)(), double seconds) {
  constexpr int calls = 1000;
  double took = 0;
  long count = 0;
  for (int i = 0; i < calls; ++i) (kernels.*kernel)();  // caches and clock rate
  while (took < seconds) {
    const double begin = peers::processor_seconds();
    for (int i = 0; i < calls; ++i) (kernels.*kernel)();
    took += peers::processor_seconds() - begin;
    count += calls;
  }
  return 1e6 * took / static_cast<double>(count * kernels.robots());
}

std::vector<std::string> settings() {
  std::vector<std::string> names{"MuRoSimF", "lanes"};
#ifdef MUROSIMF_PEER_PINOCCHIO
  names.emplace_back("Pinocchio");
#endif
  return names;
}

std::unique_ptr<peers::Kernels> make(const peers::Options& options, const Model& model,
                                     const peers::Description& description) {
  if (options.setting == "MuRoSimF") return std::make_unique<Ours<double>>(model, description);
  if (options.setting == "lanes") return std::make_unique<Ours<Pack8>>(model, description);
#ifdef MUROSIMF_PEER_PINOCCHIO
  return peers::pinocchio_kernels(description);
#else
  return nullptr;
#endif
}

nlohmann::json measure(const peers::Options& options) {
  const scene::Scene scene(options.folder / "scene.toml", {.cameras = false});
  const peers::Description description = peers::read_description(options.folder / "description.json");
  const auto kernels =
      make(options, scene.simulation().world().entity(scene.spec().robots.front().name).model(), description);
  nlohmann::json result{{"accelerations", kernels->accelerations()}, {"torques", kernels->torques()}};
  result["kinematics"] = time_of(*kernels, &peers::Kernels::kinematics, options.seconds);
  result["inverse dynamics"] = time_of(*kernels, &peers::Kernels::inverse_dynamics, options.seconds);
  if (options.setting != "lanes")
    result["mass matrix"] = time_of(*kernels, &peers::Kernels::mass_matrix, options.seconds);
  result["forward dynamics"] = time_of(*kernels, &peers::Kernels::forward_dynamics, options.seconds);
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const peers::Options options = peers::read_options({arguments, static_cast<std::size_t>(count)}, settings());
    std::printf("%s\n", measure(options).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "murosimf_peer_kernels: %s\n", error.what());
    return 1;
  }
}
