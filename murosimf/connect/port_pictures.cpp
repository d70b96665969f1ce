#include "murosimf/connect/port_pictures.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

constexpr std::string_view color = "color", depth = "depth", labels = "labels";

std::vector<std::string> layers_of(const sensors::CameraInfo& camera) {
  std::vector<std::string> layers;
  for (const auto& [has, layer] :
       {std::pair(camera.has_color, color), {camera.has_depth, depth}, {camera.has_labels, labels}}) {
    if (has) layers.push_back(fmt::format("{}.{}", camera.name, layer));
  }
  return layers;
}

std::string format_of(std::string_view layer, const sensors::CameraInfo& camera) {
  if (layer == depth) return "32FC1";
  if (layer == labels) return "16UC1";
  return camera.mosaic.empty() ? "rgb8" : fmt::format("bayer_{}8", camera.mosaic);
}

template <class Pixel>
void show(const imaging::Image<Pixel>& image, murosimf_picture& picture) noexcept {
  picture.bytes = image.pixels().data();
  picture.size = image.pixels().size_bytes();
}

}  // namespace

const murosimf_picture* PortPictures::find(std::string_view name) {
  const auto known = [&] { return std::ranges::find(shown_, name, &Shown::name); };
  if (known() == shown_.end()) make(name);
  return &known()->picture;
}

void PortPictures::make(std::string_view name) {
  if (!setup_) {
    throw SetupError(
        fmt::format("the picture '{}' was not asked for when the robot was set up, so it cannot be now", name));
  }
  std::vector<std::string> layers;
  for (const sensors::CameraFrame* frame : sensors::frames_of(setup_->entity())) {
    for (std::string& layer : layers_of(*frame->info)) layers.push_back(std::move(layer));
  }
  if (layers.empty()) {
    throw SetupError(fmt::format("there is no picture '{}': {} has no camera", name, setup_->entity().name()));
  }
  if (std::ranges::find(layers, name) == layers.end()) {
    throw SetupError(unknown_name("picture", name, std::vector<std::string_view>(layers.begin(), layers.end())));
  }
  const std::size_t dot = name.rfind('.');
  const sensors::CameraFrame& frame = sensors::read_frame(*setup_, name.substr(0, dot));
  const std::string_view layer = name.substr(dot + 1);
  shown_.push_back({std::string(name), format_of(layer, *frame.info), std::string(layer), &frame, {}});
  murosimf_picture& picture = shown_.back().picture;
  picture.width = static_cast<std::uint32_t>(frame.info->lens.spec().width);
  picture.height = static_cast<std::uint32_t>(frame.info->lens.spec().height);
  picture.format = shown_.back().format.c_str();
  picture.period = seconds(frame.info->period);
}

void PortPictures::refresh() noexcept {
  for (Shown& shown : shown_) refresh(shown);
}

/// Pictures take turns in a camera's memory.
void PortPictures::refresh(Shown& shown) noexcept {
  const sensors::CameraFrame& frame = *shown.frame;
  murosimf_picture& picture = shown.picture;
  picture.time = frame.time.count();
  picture.number = frame.number;
  picture.bytes = nullptr;
  picture.size = 0;
  if (frame.number == 0) return;
  if (shown.layer == depth) return show(frame.depth, picture);
  if (shown.layer == labels) return show(frame.labels, picture);
  if (frame.info->mosaic.empty()) return show(frame.color, picture);
  show(frame.mosaic, picture);
}

}  // namespace murosimf::connect
