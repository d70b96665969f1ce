#include "murosimf/sensors/camera_frame.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

std::string column_name(std::string_view camera) { return "frame." + std::string(camera); }

/// `name` must outlive the use of the descriptor; columns keep a copy.
Property<CameraFrame> property_of(const std::string& name) {
  return {{name, "-", "-", "last picture of a camera", Scope::sensor}};
}

template <class Pixel, class Add>
void add_pixels(Hasher& hasher, const imaging::Image<Pixel>& image, const Add& add) {
  hasher.add(static_cast<std::uint64_t>(image.width()));
  hasher.add(static_cast<std::uint64_t>(image.height()));
  for (const Pixel& pixel : image.pixels()) add(pixel);
}

void check_known(const Entity& entity, std::string_view camera) {
  std::vector<std::string_view> names;
  for (const CameraFrame* frame : frames_of(entity)) {
    if (frame->info->name == camera) return;
    names.push_back(frame->info->name);
  }
  if (names.empty()) throw SetupError(fmt::format("'{}' has no camera '{}', nor any other", entity.name(), camera));
  throw SetupError(fmt::format("'{}': {}", entity.name(), unknown_name("camera", camera, names)));
}

CameraFrame& frame_of(Entity& entity, std::string_view camera) {
  check_known(entity, camera);
  const std::string name = column_name(camera);
  return entity.column(property_of(name)).values[0];
}

}  // namespace

void append_hash(Hasher& hasher, const CameraFrame& frame) {
  hasher.add(static_cast<std::uint64_t>(frame.time.count()));
  hasher.add(frame.number);
  add_pixels(hasher, frame.color, [&](const imaging::Rgb& p) {
    hasher.add(static_cast<std::uint64_t>(p.red) << 16 | static_cast<std::uint64_t>(p.green) << 8 | p.blue);
  });
  add_pixels(hasher, frame.mosaic, [&](std::uint8_t p) { hasher.add(static_cast<std::uint64_t>(p)); });
  add_pixels(hasher, frame.depth, [&](float p) { hasher.add(static_cast<double>(p)); });
  add_pixels(hasher, frame.labels, [&](std::uint16_t p) { hasher.add(static_cast<std::uint64_t>(p)); });
}

void state(StateArchive& archive, CameraFrame& frame) {
  archive(frame.time, frame.number, frame.color, frame.mosaic, frame.depth, frame.labels);
}

std::uint64_t hash_of(const CameraFrame& frame) {
  Hasher hasher;
  append_hash(hasher, frame);
  return hasher.value();
}

CameraFrame& write_frame(Setup& setup, CameraInfo info) {
  for (const CameraFrame* other : frames_of(setup.entity())) {
    if (other->info->name == info.name) {
      throw SetupError(fmt::format("'{}' has two cameras called '{}'", setup.entity().name(), info.name));
      // names are unique per entity: the column is found by its name
    }
  }
  const std::string name = column_name(info.name);
  CameraFrame& frame = setup.write(property_of(name))[0];
  frame.info = std::make_shared<const CameraInfo>(std::move(info));
  // a shared pointer: readers in other threads keep the description that they have
  return frame;
}

const CameraFrame& read_frame(Setup& setup, std::string_view camera) {
  check_known(setup.entity(), camera);
  const std::string name = column_name(camera);
  (void)setup.read(property_of(name));
  return want_frames(setup.entity(), camera);
}

const CameraFrame& want_frames(Entity& entity, std::string_view camera) {
  CameraFrame& frame = frame_of(entity, camera);
  // cameras draw only on request: pictures cost more than all else
  frame.wanted = true;
  if (frame.heed) frame.heed();
  return frame;
}

CameraFrame& offer_frames(Entity& entity, std::string_view camera) {
  CameraFrame& frame = frame_of(entity, camera);
  frame.offered = true;
  if (frame.heed) frame.heed();
  return frame;
}

std::vector<const CameraFrame*> frames_of(const Entity& entity) {
  std::vector<const CameraFrame*> frames;
  for (const auto& [name, column] : entity.columns()) {
    if (column->info().scope != Scope::sensor || column->type() != typeid(CameraFrame)) continue;
    const CameraFrame& frame = static_cast<const Column<CameraFrame>&>(*column).values[0];
    // a column whose camera has been removed has no description
    if (frame.info) frames.push_back(&frame);
  }
  return frames;
}

}  // namespace murosimf::sensors
