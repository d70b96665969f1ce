#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include <array>
#include <string>
#include <vector>

#include "arrays.h"
#include "handles.h"
#include "kinematics_ref.h"
#include "module.h"

namespace murosimf::python {
namespace {

/// Many rows take long: other threads of Python go on meanwhile.
template <class Compute>
auto unlocked(const Compute& compute) {
  const nb::gil_scoped_release released;
  return compute();
}

/// (rows, 7): position, then quaternion, w first.
Array<double> poses(const KinematicsRef& ref, const Numbers& q, const std::string& object) {
  std::vector<double> rows;
  for (const auto& [at, turned] : unlocked([&] { return ref.kinematics.poses(span_of(q), object); })) {
    rows.insert(rows.end(), {at.x, at.y, at.z, turned.w, turned.x, turned.y, turned.z});
  }
  const std::size_t count = rows.size() / 7;
  return array_of(std::move(rows), {count, 7});
}

Array<double> centers_of_mass(const KinematicsRef& ref, const Numbers& q) {
  std::vector<double> rows;
  for (const Vector3& at : unlocked([&] { return ref.kinematics.centers_of_mass(span_of(q)); }))
    rows.insert(rows.end(), {at.x, at.y, at.z});
  const std::size_t count = rows.size() / 3;
  return array_of(std::move(rows), {count, 3});
}

}  // namespace

void bind_kinematics(nb::module_& module) {
  nb::class_<KinematicsRef>(module, "Kinematics")
      .def("joints", [](const KinematicsRef& ref) { return ref.kinematics.joints(); })
      .def("mass", [](const KinematicsRef& ref) { return ref.kinematics.mass(); })
      .def("poses", &poses, nb::arg("q"), nb::arg("object"))
      .def("centers_of_mass", &centers_of_mass, nb::arg("q"))
      .def(
          "jacobians",
          [](const KinematicsRef& ref, const Numbers& q, const std::string& object) {
            return array_of(unlocked([&] { return ref.kinematics.jacobians(span_of(q), object); }));
          },
          nb::arg("q"), nb::arg("object"))
      .def(
          "mass_matrices",
          [](const KinematicsRef& ref, const Numbers& q) {
            return array_of(unlocked([&] { return ref.kinematics.mass_matrices(span_of(q)); }));
          },
          nb::arg("q"))
      .def(
          "inverse_dynamics",
          [](const KinematicsRef& ref, const Numbers& q, const Numbers& v, const Numbers& a,
             const std::array<double, 3>& gravity) {
            return array_of(unlocked([&] {
              return ref.kinematics.inverse_dynamics(span_of(q), span_of(v), span_of(a), vector_of(gravity));
            }));
          },
          nb::arg("q"), nb::arg("v"), nb::arg("a"), nb::arg("gravity"));
}

}  // namespace murosimf::python
