/// joint_wrench.h - sensor: force and moment through a joint or a weld, as a force-torque sensor in that place measures them.
///
/// The robot is cut at an object: a joint, or a body that is fixed to its parent. Everything behind the cut moves as its momentum p, L
/// shows, under gravity, contacts and pushes F_k, N_k on the bodies k behind it, and what its parent does to it at the sensor's place r:
///
///     f = (p(t) - p(t - h))/h - sum (m_k g + F_k)
///     n = (L(t) - L(t - h))/h - sum ((c_k - r) x m_k g + N_k + (r_k - r) x F_k)             L about r, c_k the centers of mass
///     p = sum m_k v_ck        L = sum (I_k w_k + (c_k - r) x m_k v_ck)
///
/// with h a step of the simulation: it is the mean over the step that ends at the sample, from velocities, so the same at every level
/// and for joints of every kind. Servo, spring and friction of the joint are in it, the inertia of its rotor is not. Before the first
/// step nothing moves and nothing touches. The wrench that is shown is that of the child on its parent, (-f, -n): a foot that carries
/// weight shows +z. With direction = "parent_to_child" it is (f, n). Both are in the axes of the sensor, or of the object `axes`.
///
/// kinematic_walking has no contact forces: the whole weight is taken to act in the middle of the sole that stands. At simplified_dynamics
/// joints jump to their targets, which their limbs' inertia shows.
/// Source: Newton and Euler; SDFormat documentation, "force_torque"; MuJoCo documentation, XML reference, "force".
#pragma once

#include <string>
#include <vector>

#include "murosimf/math/spatial.h"
#include "murosimf/model/feet.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/sensor_options.h"

namespace murosimf::sensors {

struct JointWrenchOptions {
  std::string behind{};  ///< object of the cut; empty: the joint or body that the sensor is mounted on
  std::string direction = "child_to_parent";  ///< or parent_to_child
  std::string axes{};                         ///< object in whose axes it is shown; empty: the sensor's own
};

[[nodiscard]] const OptionTable<JointWrenchOptions>& joint_wrench_options();

class JointWrench final : public Sensor {
 public:
  /// Throws SetupError: an unknown object, or nothing behind the cut.
  JointWrench(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

 private:
  /// Something with mass behind the cut.
  struct Part {
    int object = 0;
    double mass = 0;   // [kg]
    Vec3d center;      // [m] object axes
    SymMat3d inertia;  // [kg m^2] at the center, object axes
  };
  /// Linear and angular momentum, the latter about the world's origin.
  struct Momentum {
    Vec3d linear, angular;  // [N s], [N m s]
    void state(StateArchive& archive) { archive(linear, angular); }
  };

  void measure(std::span<double> values) noexcept override;
  void start() noexcept override { known_ = 0; }
  void memory(StateArchive& archive) override { archive(last_, known_); }

  void find_parts(int cut);
  [[nodiscard]] Momentum momentum() const noexcept;
  [[nodiscard]] Wrenchd outside_forces(const Vec3d& place) const noexcept;
  [[nodiscard]] Wrenchd carried_weight(const Vec3d& place) const noexcept;

  const Model& model_;
  Mounting mounting_;
  Mat3d axes_turn_;    // of the axes that it is shown in, to those of their link
  int axes_link_ = 0;  // object
  std::vector<Part> parts_;
  std::vector<int> bodies_;   // behind the cut, that feel forces
  std::vector<Foot> feet_;    // of the model
  std::vector<bool> behind_;  // by object
  Vec3d gravity_;             // [m/s^2]
  double period_;             // [s]
  double sign_;               // 1 for that of the parent on the child
  std::span<const Vec3d> r_, v_, w_;
  std::span<const Mat3d> R_;
  std::span<const Wrenchd> external_;
  std::span<const double> dynamic_, stance_foot_;
  Momentum last_;
  double known_ = 0;  // 1: last_ is that of the step before
};

}  // namespace murosimf::sensors
