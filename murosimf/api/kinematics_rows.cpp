// include/murosimf/kinematics.h: rows of joint positions through the kernels of multibody/.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/kinematics.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf {

namespace api {

struct KinematicsInside {
  ModelPtr model;
  std::string robot;  ///< for messages
};

namespace {

/// A robot with its base at the origin, for a sequence of rows of joint positions.
class Posture {
 public:
  explicit Posture(const Model& model)
      : model_(model),
        q_(static_cast<std::size_t>(model.size())),
        v_(q_),
        r_(q_.size()),
        R_(q_.size()),
        links_(model.tree().links.size()) {}

  [[nodiscard]] std::size_t joints() const { return model_.joints().size(); }
  [[nodiscard]] const std::vector<multibody::LinkMotion<double>>& links() const { return links_; }

  /// Velocities can be left out where only places are needed.
  void take(std::span<const double> q, std::span<const double> v = {}) {
    MUROSIMF_ASSERT(q.size() == joints() && (v.empty() || v.size() == joints()));
    spread(q, q_);
    if (!v.empty()) spread(v, v_);
    multibody::poses<double>(model_.tree(), q_, r_, R_);
    multibody::link_motions<double>(model_.tree(), r_, R_, {}, v_, links_);
  }

  /// Pose in the base's frame.
  [[nodiscard]] Transformd pose(const FixedObject& object) const {
    MUROSIMF_ASSERT(object.link >= 0 && static_cast<std::size_t>(object.link) < links_.size());
    const auto link = static_cast<std::size_t>(model_.tree().links[static_cast<std::size_t>(object.link)].object);
    return {r_[link] + R_[link] * object.offset, R_[link] * object.turn};
  }

  /// Index of a joint's link.
  [[nodiscard]] std::size_t link_of(std::size_t joint) const {
    MUROSIMF_ASSERT(joint < model_.joints().size());
    const auto object = static_cast<std::size_t>(model_.joints()[joint]);
    return static_cast<std::size_t>(model_.tree().link_of[object]);
  }

 private:
  /// Copies a row by joint to a row by object.
  void spread(std::span<const double> row, std::span<double> by_object) const {
    for (std::size_t i = 0; i < row.size(); ++i) by_object[static_cast<std::size_t>(model_.joints()[i])] = row[i];
  }

  const Model& model_;
  std::vector<double> q_, v_;  // by object
  std::vector<Vec3d> r_;
  std::vector<Mat3d> R_;
  std::vector<multibody::LinkMotion<double>> links_;
};

/// Number of rows. Throws InputError.
std::size_t rows_of(const KinematicsInside& inside, std::span<const double> numbers, std::string_view what) {
  const std::size_t joints = inside.model->joints().size();
  const std::size_t rows = joints == 0 ? 0 : numbers.size() / joints;
  check_row(numbers, rows * joints, fmt::format("{} of '{}', in rows of {} joints,", what, inside.robot, joints));
  return rows;
}

/// Calls use(posture, row) for each row of q.
template <class Use>
void for_rows(const KinematicsInside& inside, std::span<const double> q, const Use& use) {
  const std::size_t rows = rows_of(inside, q, "q");
  Posture posture(*inside.model);
  for (std::size_t row = 0; row < rows; ++row) {
    posture.take(q.subspan(row * posture.joints(), posture.joints()));
    use(posture, row);
  }
}

FixedObject placement(const KinematicsInside& inside, std::string_view object) {
  if (const auto found = inside.model->find_object(object)) return inside.model->placement(*found);
  throw_unknown(fmt::format("object of '{}'", inside.robot), object, inside.model->object_names());
}

}  // namespace
}  // namespace api

inline namespace v0 {

Kinematics Robot::kinematics() const {
  const Entity& entity = scene_->entity(number_);
  return Kinematics(std::make_shared<api::KinematicsInside>(api::KinematicsInside{entity.model_ptr(), entity.name()}));
}

std::size_t Kinematics::joints() const { return inside_->model->joints().size(); }
double Kinematics::mass() const { return inside_->model->tree().mass; }

std::vector<Pose> Kinematics::poses(std::span<const double> q, std::string_view object) const {
  const FixedObject at = api::placement(*inside_, object);
  std::vector<Pose> poses;
  api::for_rows(*inside_, q, [&](const api::Posture& posture, std::size_t) {
    const Transformd pose = posture.pose(at);
    poses.push_back({api::vector_of(pose.position), api::rotation_of(pose.orientation)});
  });
  return poses;
}

std::vector<Vector3> Kinematics::centers_of_mass(std::span<const double> q) const {
  std::vector<Vector3> centers;
  api::for_rows(*inside_, q, [&](const api::Posture& posture, std::size_t) {
    Vec3d first;
    for (const auto& link : posture.links()) first += link.inertia.first;
    centers.push_back(api::vector_of((1 / mass()) * first));
  });
  return centers;
}

std::vector<double> Kinematics::jacobians(std::span<const double> q, std::string_view object) const {
  const FixedObject at = api::placement(*inside_, object);
  const Tree& tree = inside_->model->tree();
  const std::size_t n = joints();
  std::vector<double> all;
  api::for_rows(*inside_, q, [&](const api::Posture& posture, std::size_t row) {
    all.resize((row + 1) * 6 * n);
    const Vec3d r = posture.pose(at).position;
    std::vector<bool> carries(tree.links.size());  // whether the link moves the object
    for (int link = at.link; link >= 0; link = tree.links[static_cast<std::size_t>(link)].parent) {
      carries[static_cast<std::size_t>(link)] = true;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (!carries[posture.link_of(i)]) continue;
      const Twistd& axis = posture.links()[posture.link_of(i)].axis;  // about the base's origin
      const Vec3d v = axis.v + cross(axis.w, r);
      const double column[] = {v.x, v.y, v.z, axis.w.x, axis.w.y, axis.w.z};
      for (std::size_t k = 0; k < 6; ++k) all[row * 6 * n + k * n + i] = column[k];
    }
  });
  return all;
}

std::vector<double> Kinematics::mass_matrices(std::span<const double> q) const {
  const std::size_t links = inside_->model->tree().links.size(), size = 6 + joints();
  std::vector<RigidInertia<double>> composite(links);
  std::vector<double> by_link((links + 5) * (links + 5)), all;
  api::for_rows(*inside_, q, [&](const api::Posture& posture, std::size_t) {
    multibody::mass_matrix(inside_->model->tree(), posture.links(), composite, by_link);
    // the kernel's columns: six of the base, which is link 0, then one for each further link
    const auto place = [&](std::size_t i) { return i < 6 ? i : 5 + posture.link_of(i - 6); };
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) all.push_back(by_link[place(i) * (links + 5) + place(j)]);
    }
  });
  return all;
}

std::vector<double> Kinematics::inverse_dynamics(std::span<const double> q, std::span<const double> v,
                                                 std::span<const double> a, const Vector3& gravity) const {
  const std::size_t rows = api::rows_of(*inside_, q, "q"), n = joints();
  api::check_row(v, q.size(), "v");
  api::check_row(a, q.size(), "a");
  api::check_finite(gravity, "gravity");
  const std::size_t links = inside_->model->tree().links.size();
  api::Posture posture(*inside_->model);
  std::vector<double> acceleration(links), torque(links), all;
  std::vector<Wrenchd> external(links), force(links);
  const Twistd base{{}, -1.0 * api::vec(gravity)};
  for (std::size_t row = 0; row < rows; ++row) {
    posture.take(q.subspan(row * n, n), v.subspan(row * n, n));
    for (std::size_t i = 0; i < n; ++i) acceleration[posture.link_of(i)] = a[row * n + i];
    multibody::inverse_dynamics<double>(inside_->model->tree(), posture.links(), base, acceleration, external, force,
                                        torque);
    for (std::size_t i = 0; i < n; ++i) all.push_back(torque[posture.link_of(i)]);
  }
  return all;
}

}  // namespace v0
}  // namespace murosimf
