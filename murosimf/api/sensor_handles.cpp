// include/murosimf/sensors.h.
#include "murosimf/math/assert.h"
#include "murosimf/sensors.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/api/images.h"
#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/reading.h"

namespace murosimf {

namespace api {

struct SensorInside {
  std::shared_ptr<SceneInside> scene;
  const sensors::Reading* reading = nullptr;
  std::vector<SensorOutput> outputs;
};

struct CameraInside {
  std::shared_ptr<SceneInside> scene;
  const sensors::CameraFrame* frame = nullptr;
};

namespace {

std::vector<SensorOutput> outputs_of(const sensors::Reading& reading) {
  std::vector<SensorOutput> outputs;
  std::size_t begin = 0;
  for (const sensors::Output& output : reading.info->outputs) {
    outputs.push_back({output.name, output.unit, output.labels, begin, output.size()});
    begin += output.size();
  }
  MUROSIMF_ASSERT(begin == reading.values.size());
  return outputs;
}

}  // namespace
}  // namespace api

inline namespace v0 {

std::vector<std::string> Robot::sensors() const {
  std::vector<std::string> names;
  for (const auto* reading : sensors::readings_of(scene_->entity(number_))) names.push_back(reading->info->name);
  return names;
}

Sensor Robot::sensor(std::string_view name) const {
  const sensors::Reading* reading = sensors::find_reading(scene_->entity(number_), name);
  if (!reading) {
    const std::vector<std::string> known = sensors();
    api::throw_unknown(fmt::format("sensor of '{}'", this->name()), name, {known.begin(), known.end()});
  }
  return Sensor(std::make_shared<api::SensorInside>(api::SensorInside{scene_, reading, api::outputs_of(*reading)}));
}

const std::string& Sensor::name() const { return inside_->reading->info->name; }
const std::string& Sensor::type() const { return inside_->reading->info->type; }
const std::string& Sensor::frame() const { return inside_->reading->info->frame; }
double Sensor::period() const { return seconds(inside_->reading->info->period); }
const std::vector<SensorOutput>& Sensor::outputs() const { return inside_->outputs; }
double Sensor::time() const { return seconds(inside_->reading->time); }
std::uint64_t Sensor::samples() const { return inside_->reading->samples; }
std::span<const double> Sensor::values() const { return inside_->reading->values; }

std::span<const double> Sensor::values(std::string_view output) const {
  std::vector<std::string_view> known;
  for (const SensorOutput& each : inside_->outputs) {
    if (each.name == output) return values().subspan(each.begin, each.size);
    known.emplace_back(each.name);
  }
  api::throw_unknown(fmt::format("output of sensor '{}'", name()), output, known);
}

std::vector<std::string> Robot::cameras() const {
  std::vector<std::string> names;
  for (const auto* frame : sensors::frames_of(scene_->entity(number_))) names.push_back(frame->info->name);
  return names;
}

Camera Robot::camera(std::string_view name) const {
  const std::vector<std::string> known = cameras();
  const auto place = std::ranges::find(known, name);
  if (place == known.end()) {
    api::throw_unknown(fmt::format("camera of '{}'", this->name()), name, {known.begin(), known.end()});
  }
  Entity& entity = scene_->entity(number_);
  (void)api::told([&] { return &sensors::want_frames(entity, name); });  // a handle requests drawing
  const auto* frame = sensors::frames_of(entity)[static_cast<std::size_t>(place - known.begin())];
  if (scene_->begun && !frame->draws) {
    throw InputError(fmt::format("camera '{}' of '{}' does not draw: nothing is drawn for cameras of this scene", name,
                                 this->name()));
  }
  return Camera(std::make_shared<api::CameraInside>(api::CameraInside{scene_, frame}));
}

const std::string& Camera::name() const { return inside_->frame->info->name; }
double Camera::period() const { return seconds(inside_->frame->info->period); }
const std::vector<std::string>& Camera::labels() const { return inside_->frame->info->labels; }
std::uint64_t Camera::pictures() const { return inside_->frame->number; }
double Camera::time() const { return seconds(inside_->frame->time); }

Image Camera::picture() const {
  const sensors::CameraFrame& frame = *inside_->frame;
  return api::image_of(frame.color, frame.mosaic, frame.depth, frame.labels);
}

}  // namespace v0
}  // namespace murosimf
