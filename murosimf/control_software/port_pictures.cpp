#include "murosimf/control_software/port_pictures.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
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

std::size_t bytes_of_pixel(std::string_view layer, const sensors::CameraInfo& camera) {
  if (layer == depth) return sizeof(float);
  if (layer == labels) return sizeof(std::uint16_t);
  return camera.mosaic.empty() ? 3 : 1;
}

std::span<const std::byte> bytes_of(const sensors::CameraFrame& frame, std::string_view layer) {
  if (layer == depth) return std::as_bytes(frame.depth.pixels());
  if (layer == labels) return std::as_bytes(frame.labels.pixels());
  return frame.info->mosaic.empty() ? std::as_bytes(frame.color.pixels()) : std::as_bytes(frame.mosaic.pixels());
}

}  // namespace

const murosimf_picture* PortPictures::find(std::string_view name) {
  const auto known = [&] { return std::ranges::find(shown_, name, &Shown::name); };
  if (known() == shown_.end()) make(name);
  return &known()->row->shown_head<const murosimf_picture>();
}

/// Only while the robot is set up: cameras draw only what was requested.
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
  MUROSIMF_ASSERT(dot != std::string_view::npos);
  const sensors::CameraFrame& frame = sensors::read_frame(*setup_, name.substr(0, dot));
  const std::string_view layer = name.substr(dot + 1);
  const auto width = static_cast<std::uint32_t>(frame.info->lens.spec().width),
             height = static_cast<std::uint32_t>(frame.info->lens.spec().height);
  MUROSIMF_ASSERT(width > 0 && height > 0);
  const std::size_t bytes = bytes_of_pixel(layer, *frame.info) * width * height;
  const GuardedRow& row = rows_->add(std::string(name), fmt::format("{} bytes", bytes), sizeof(murosimf_picture), bytes,
                                     GuardedRow::Use::read);
  shown_.push_back({std::string(name), format_of(layer, *frame.info), std::string(layer), &frame, &row});
  auto& picture = row.head<murosimf_picture>();
  picture.width = width;
  picture.height = height;
  picture.format = shown_.back().format.c_str();
  picture.period = seconds(frame.info->period);
}

void PortPictures::refresh() noexcept {
  for (Shown& shown : shown_) refresh(shown);
}

void PortPictures::forget() noexcept {
  for (const Shown& shown : shown_) shown.row->head<murosimf_picture>().bytes = nullptr;
}

/// Pictures take turns in a camera's memory; a new one is copied once.
void PortPictures::refresh(Shown& shown) noexcept {
  const sensors::CameraFrame& frame = *shown.frame;
  auto& picture = shown.row->head<murosimf_picture>();
  const bool as_it_was =
      picture.number == frame.number && picture.time == frame.time.count() && picture.bytes != nullptr;
  picture.time = frame.time.count();
  picture.number = frame.number;
  if (as_it_was && frame.number != 0) return;
  picture.bytes = nullptr;
  picture.size = 0;
  if (frame.number == 0) return;
  const std::span<const std::byte> bytes = bytes_of(frame, shown.layer);
  std::ranges::copy(bytes, shown.row->body<std::byte>());
  picture.bytes = shown.row->shown_body<const std::byte>();
  picture.size = bytes.size();
}

}  // namespace murosimf::control_software
