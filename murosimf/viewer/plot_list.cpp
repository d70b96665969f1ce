#include "murosimf/viewer/plot_list.h"

#include <algorithm>

namespace murosimf::viewer {
namespace {

void add_property(PlotRequest& request, const Inspection& seen) {
  const auto object = std::ranges::find(seen.objects, request.path, &ObjectValues::path);
  if (object == seen.objects.end()) return;
  const auto value = std::ranges::find(object->properties, request.property, &PropertyValue::name);
  if (value == object->properties.end()) return;
  request.plot.unit = value->unit;
  request.plot.add(seconds(seen.time), value->numbers);
}

void add_sensor(PlotRequest& request, const SensorState& sensor) {
  std::size_t first = 0;  // of the values of an output
  for (const sensors::Output& output : sensor.info->outputs) {
    if (sensor.samples > 0 && request.property == sensor.info->name + "." + output.name) {
      MUROSIMF_ASSERT(first + output.size() <= sensor.values.size());
      const auto begin = sensor.values.begin() + static_cast<std::ptrdiff_t>(first);
      request.plot.unit = output.unit;
      request.plot.add(sensor.time, {begin, begin + static_cast<std::ptrdiff_t>(output.size())});
    }
    first += output.size();
  }
}

}  // namespace

void PlotList::add(const SceneOutline& outline, const ObjectPath& path, const std::string& property, bool sensor) {
  for (const PlotRequest& request : requests_) {
    if (request.path == path && request.property == property && request.sensor == sensor) return;
  }
  const std::string whom = sensor ? outline.of(path.entity).name : outline.path_text(path);
  requests_.push_back({path, property, sensor, {whom + "." + property, {}, {}}});
}

void PlotList::remove(std::size_t number) {
  MUROSIMF_ASSERT(number < requests_.size());
  requests_.erase(requests_.begin() + static_cast<std::ptrdiff_t>(number));
}

void PlotList::remove_sensors() {
  std::erase_if(requests_, [](const PlotRequest& request) { return request.sensor; });
}

void PlotList::request(InspectionRequest& request) const {
  for (const PlotRequest& plot : requests_) {
    if (plot.sensor) {
      if (!request.sensors_of) request.sensors_of = plot.path.entity;
    } else if (std::ranges::find(request.objects, plot.path) == request.objects.end()) {
      request.objects.push_back(plot.path);
    }
  }
}

void PlotList::take(const Inspection& seen) {
  for (PlotRequest& request : requests_) {
    if (!request.sensor) {
      add_property(request, seen);
    } else if (seen.sensors_of == request.path.entity) {
      for (const SensorState& sensor : seen.sensors) add_sensor(request, sensor);
    }
  }
}

}  // namespace murosimf::viewer
