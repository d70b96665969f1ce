#include <array>
#include <cstdint>
#include <string>

#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "handles.h"
#include "module.h"

namespace murosimf::python {
namespace {

using Triple = std::array<double, 3>;
using Quadruple = std::array<double, 4>;

/// (rows,), (rows, n) or (rows, n, m): sides of length 1 at the end are left out.
Array<double> view(EntityRef& ref, const std::string& property) {
  const Use use(*ref.state);
  if (!ref.handle.present()) throw Error("'" + ref.handle.name() + "' has left the scene: enter() brings it back");
  const PropertyView seen = ref.handle.view(property);
  const std::size_t shape[] = {seen.rows, seen.shape[0], seen.shape[1]};
  const std::int64_t strides[] = {seen.strides[0], seen.strides[1], seen.strides[2]};
  const std::size_t sides = shape[2] > 1 ? 3 : shape[1] > 1 ? 2 : 1;
  return Array<double>(seen.data, sides, shape, keeping(seen.keeps), strides);
}

std::pair<Triple, Quadruple> pose(EntityRef& ref, const std::string& object) {
  const Use use(*ref.state);
  const Pose pose = object.empty() ? ref.handle.pose() : ref.handle.pose(object);
  const Rotation& turned = pose.orientation;
  return {array_of(pose.position), {turned.w, turned.x, turned.y, turned.z}};
}

std::pair<Triple, Triple> velocity(EntityRef& ref, const std::string& object) {
  const Use use(*ref.state);
  const Velocity velocity = object.empty() ? ref.handle.velocity() : ref.handle.velocity(object);
  return {array_of(velocity.linear), array_of(velocity.angular)};
}

void set_pose(EntityRef& ref, const Triple& position, const Quadruple& quaternion) {
  const Use use(*ref.state);
  ref.handle.set_pose({vector_of(position), {quaternion[0], quaternion[1], quaternion[2], quaternion[3]}});
}

void set_velocity(EntityRef& ref, const Triple& linear, const Triple& angular) {
  const Use use(*ref.state);
  ref.handle.set_velocity({vector_of(linear), vector_of(angular)});
}

void push(EntityRef& ref, const std::string& object, const Triple& force, double duration, const Triple& moment) {
  const Use use(*ref.state);
  ref.handle.push(object, vector_of(force), duration, vector_of(moment));
}

}  // namespace

void bind_entities(nb::module_& module) {
  nb::class_<EntityRef>(module, "Entity")
      .def_prop_ro("name", [](const EntityRef& ref) { return ref.handle.name(); })
      .def("objects", [](const EntityRef& ref) { return ref.handle.objects(); })
      .def("present",
           [](EntityRef& ref) {
             const Use use(*ref.state);
             return ref.handle.present();
           })
      .def("frozen",
           [](EntityRef& ref) {
             const Use use(*ref.state);
             return ref.handle.frozen();
           })
      .def("begun",
           [](EntityRef& ref) {
             const Look look(*ref.state);
             return ref.state->scene.nanoseconds() > 0;
           })
      .def("pose", &pose, nb::arg("object"))
      .def("velocity", &velocity, nb::arg("object"))
      .def("set_pose", &set_pose, nb::arg("position"), nb::arg("quaternion"))
      .def("set_velocity", &set_velocity, nb::arg("linear"), nb::arg("angular"))
      .def(
          "place",
          [](EntityRef& ref, const Triple& position, double heading) {
            const Use use(*ref.state);
            ref.handle.place(vector_of(position), heading);
          },
          nb::arg("position"), nb::arg("heading"))
      .def("push", &push, nb::arg("object"), nb::arg("force"), nb::arg("duration"), nb::arg("moment"))
      .def("contact_law",
           [](EntityRef& ref) {
             const Use use(*ref.state);
             return ref.handle.contact_law();
           })
      .def(
          "set_contact_law",
          [](EntityRef& ref, const std::string& law) {
            const Use use(*ref.state);
            ref.handle.set_contact_law(law);
          },
          nb::arg("law"))
      .def(
          "get",
          [](EntityRef& ref, const std::string& object, const std::string& property) {
            const Use use(*ref.state);
            return array_of(ref.handle.get(object, property));
          },
          nb::arg("object"), nb::arg("property"))
      .def(
          "set",
          [](EntityRef& ref, const std::string& object, const std::string& property, const Numbers& values) {
            const Use use(*ref.state);
            ref.handle.set(object, property, span_of(values));
          },
          nb::arg("object"), nb::arg("property"), nb::arg("values"))
      .def(
          "unit",
          [](EntityRef& ref, const std::string& object, const std::string& property) {
            const Use use(*ref.state);
            return ref.handle.unit(object, property);
          },
          nb::arg("object"), nb::arg("property"))
      .def(
          "properties",
          [](EntityRef& ref, const std::string& object) {
            const Use use(*ref.state);
            return ref.handle.properties(object);
          },
          nb::arg("object"))
      .def("view", &view, nb::arg("property"));
}

}  // namespace murosimf::python
