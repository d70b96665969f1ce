#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "arrays.h"
#include "module.h"
#include "murosimf/error.h"
#include "pictures.h"
#include "sensor_refs.h"

namespace murosimf::python {
namespace {

/// Name, unit, labels, first number and their count.
using Output = std::tuple<std::string, std::string, std::vector<std::string>, std::size_t, std::size_t>;

std::vector<Output> outputs_of(const SensorRef& ref) {
  std::vector<Output> outputs;
  for (const SensorOutput& output : ref.sensor.outputs()) {
    outputs.emplace_back(output.name, output.unit, output.labels, output.begin, output.size);
  }
  return outputs;
}

/// Live.
Array<const double> values_of(SensorRef& ref) {
  const Look look(*ref.state);
  const std::span<const double> values = ref.sensor.values();
  return shown<const double>(values.data(), {values.size()}, ref.state);
}

void keep(SensorRef& ref, std::size_t most) {
  const Use use(*ref.state);
  ref.state->histories.insert_or_assign({ref.robot, ref.sensor.name()}, SensorHistory(ref.sensor, most));
}

/// (n, 1 + values), time first. Throws Error: none is kept.
Array<double> history(SensorRef& ref) {
  const Use use(*ref.state);
  const auto found = ref.state->histories.find({ref.robot, ref.sensor.name()});
  if (found == ref.state->histories.end()) {
    throw Error("samples of sensor '" + ref.sensor.name() + "' are not kept: keep(1000) begins");
  }
  found->second.look();
  const std::size_t rows = found->second.size();
  return array_of(found->second.numbers(), {rows, 1 + ref.sensor.values().size()});
}

nb::tuple picture_of(CameraRef& ref) {
  Image image = [&] {
    const Look look(*ref.state);
    return ref.camera.picture();
  }();
  return layers_of(std::move(image));
}

}  // namespace

void bind_sensors(nb::module_& module) {
  nb::class_<SensorRef>(module, "Sensor")
      .def_prop_ro("name", [](const SensorRef& ref) { return ref.sensor.name(); })
      .def_prop_ro("type", [](const SensorRef& ref) { return ref.sensor.type(); })
      .def_prop_ro("frame", [](const SensorRef& ref) { return ref.sensor.frame(); })
      .def_prop_ro("period", [](const SensorRef& ref) { return ref.sensor.period(); })
      .def("outputs", &outputs_of)
      .def("time",
           [](SensorRef& ref) {
             const Look look(*ref.state);
             return ref.sensor.time();
           })
      .def("samples",
           [](SensorRef& ref) {
             const Look look(*ref.state);
             return ref.sensor.samples();
           })
      .def("values", &values_of)
      .def("keep", &keep, nb::arg("samples"))
      .def("history", &history);
  nb::class_<CameraRef>(module, "Camera")
      .def_prop_ro("name", [](const CameraRef& ref) { return ref.camera.name(); })
      .def_prop_ro("period", [](const CameraRef& ref) { return ref.camera.period(); })
      .def("labels", [](const CameraRef& ref) { return ref.camera.labels(); })
      .def("time",
           [](CameraRef& ref) {
             const Look look(*ref.state);
             return ref.camera.time();
           })
      .def("pictures",
           [](CameraRef& ref) {
             const Look look(*ref.state);
             return ref.camera.pictures();
           })
      .def("picture", &picture_of);
}

}  // namespace murosimf::python
