#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "handles.h"
#include "kinematics_ref.h"
#include "module.h"
#include "python_controller.h"
#include "sensor_refs.h"

namespace murosimf::python {
namespace {

JointArrays& joints_of(RobotRef& ref) {
  {
    const Look look(*ref.state);  // in a controller, too: there they are known
    if (JointArrays* known = ref.state->known_joints(ref.robot.name())) return *known;
  }
  const Use use(*ref.state);
  return ref.state->joints(ref.robot.name());
}

/// (joints,), live.
template <class Number>
Array<Number> shown_row(RobotRef& ref, JointArrays::Row& row) {
  return shown<Number>(row.values.data(), {row.values.size()}, ref.state);
}

/// Name, unit, lower and upper end.
std::vector<std::tuple<std::string, std::string, double, double>> joint_infos(RobotRef& ref) {
  const Look look(*ref.state);
  std::vector<std::tuple<std::string, std::string, double, double>> infos;
  for (const JointInfo& joint : ref.robot.joints())
    infos.emplace_back(joint.name, joint.unit, joint.lower, joint.upper);
  return infos;
}

void set_controller(RobotRef& ref, nb::handle start, nb::handle step, double rate) {
  const Use use(*ref.state);
  if (step.is_none()) return ref.robot.set_controller(nullptr);
  ref.robot.set_controller(std::make_shared<PythonController>(*ref.state, ref.robot.name(), start, step), rate);
}

CameraRef camera(RobotRef& ref, const std::string& name) {
  const Use use(*ref.state);
  ref.state->threads = true;  // what draws cannot be used in a forked child
  return {ref.state, ref.robot.camera(name)};
}

}  // namespace

void bind_robots(nb::module_& module) {
  nb::class_<RobotRef, EntityRef>(module, "Robot")
      .def("level",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.level();
           })
      .def(
          "set_level",
          [](RobotRef& ref, const std::string& level) {
            const Use use(*ref.state);
            const nb::gil_scoped_release unlocked;
            ref.robot.set_level(level);
          },
          nb::arg("level"))
      .def("joints", &joint_infos)
      .def("joint_position", [](RobotRef& ref) { return shown_row<double>(ref, joints_of(ref).position); })
      .def("joint_velocity", [](RobotRef& ref) { return shown_row<double>(ref, joints_of(ref).velocity); })
      .def("joint_torque", [](RobotRef& ref) { return shown_row<const double>(ref, joints_of(ref).torque); })
      .def("joint_target", [](RobotRef& ref) { return shown_row<double>(ref, joints_of(ref).target); })
      .def(
          "set_command",
          [](RobotRef& ref, double forward, double left, double turning) {
            const Use use(*ref.state);
            ref.robot.set_command(forward, left, turning);
          },
          nb::arg("forward"), nb::arg("left"), nb::arg("turning"))
      .def("motions",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.motions();
           })
      .def(
          "play",
          [](RobotRef& ref, const std::string& motion) {
            const Use use(*ref.state);
            ref.robot.play(motion);
          },
          nb::arg("motion"))
      .def("falls",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.falls();
           })
      .def("fallen",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.fallen();
           })
      .def("sensors",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.sensors();
           })
      .def(
          "sensor",
          [](RobotRef& ref, const std::string& name) {
            const Look look(*ref.state);
            return SensorRef{ref.state, ref.robot.sensor(name), ref.robot.name()};
          },
          nb::arg("name"))
      .def("cameras",
           [](RobotRef& ref) {
             const Use use(*ref.state);
             return ref.robot.cameras();
           })
      .def("camera", &camera, nb::arg("name"))
      .def("set_controller", &set_controller, nb::arg("start").none(), nb::arg("step").none(), nb::arg("rate"))
      .def("kinematics", [](RobotRef& ref) {
        const Use use(*ref.state);
        return KinematicsRef{ref.robot.kinematics()};
      });
}

}  // namespace murosimf::python
