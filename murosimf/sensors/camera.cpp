#include "murosimf/sensors/camera.h"

#include <algorithm>
#include <array>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {
namespace {

std::vector<Output> outputs() {
  return {{"position", "m", {"x", "y", "z"}},
          {"orientation", "1", {"w", "x", "y", "z"}},
          {"intrinsics", "px", {"fx", "fy", "cx", "cy"}},
          {"mounting_error", "rad", {"roll", "pitch", "yaw"}}};
}

CameraInfo info_of(const SensorSpec& spec, const CameraSpec& camera, const Mounting& mounting, Duration period,
                   const std::vector<Entity*>& moving_entities) {
  const Mat3d turn = transpose(true_orientation(spec)) * spec.orientation;  // removes the mounting error
  CameraInfo info{.name = spec.name, .lens = imaging::Lens(camera.lens), .period = period};
  info.link = mounting.link_object();
  info.position = mounting.position_on_link();
  info.orientation = mounting.orientation_on_link() * optical_axes;
  info.nominal = mounting.orientation_on_link() * turn * optical_axes;
  info.labels = {"background", "ground", "line", "goal"};
  for (const Entity* moving_entity : moving_entities) info.labels.push_back(moving_entity->name());
  info.has_color = camera.layers.color;
  info.has_depth = camera.layers.depth;
  info.has_labels = camera.layers.labels;
  info.mosaic = camera.mosaic;
  info.spec = std::make_shared<const CameraSpec>(camera);
  return info;
}

bool is_asked(const CameraFrame& frame) { return frame.wanted || (frame.offered && frame.asked); }

bool is_empty(const CameraPicture& picture) {
  const View& view = picture.view;
  return view.color.empty() && view.depth.empty() && view.labels.empty() && picture.mosaic.empty();
}

}  // namespace

Camera::Camera(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, outputs()),
      eye_(camera_spec(spec), pixel_stream(surroundings.seed, setup.entity().name(), spec.name)),
      mounting_error_(spec.mounting_error),
      mounting_(setup, spec),
      find_source_(surroundings.view_source),
      frame_(write_frame(setup,
                         info_of(spec, eye_.spec(), mounting_, reading().info->period, surroundings.moving_entities))),
      on_the_way_(most_on_the_way()),
      fold_warning_(shared_fold_warning(frame_.info->lens.spec())) {
  read_motion_of_all(setup, surroundings);
  frame_.wanted = eye_.spec().always_on;
  frame_.heed = [this] { heed(); };
}

/// The drawing begins with the next sample.
void Camera::heed() {
  wanted_ = wanted_ || frame_.wanted;
  offered_ = offered_ || frame_.offered;
  if (started_ && !source_) open();
}

void Camera::open() {
  source_ = (frame_.wanted || frame_.offered) && find_source_ ? find_source_() : nullptr;
  frame_.draws = source_ && is_asked(frame_);
  if (source_) eye_.open();
}

/// The new entity gets a label.
void Camera::entity_added(Setup& setup) {
  read_motion(setup);
  auto info = std::make_shared<CameraInfo>(*frame_.info);
  info->labels.push_back(setup.entity().name());
  frame_.info = std::move(info);
}

void Camera::entity_taken_back(const Entity& entity) noexcept {
  if (frame_.info->labels.back() != entity.name()) return;
  auto info = std::make_shared<CameraInfo>(*frame_.info);
  info->labels.pop_back();
  frame_.info = std::move(info);
  // labels of the pictures under way stay valid: only the last one is removed
}

std::string Camera::diagnostic(const LevelTraits&) const { return *fold_warning_; }

void Camera::start() {
  frame_.time = Duration{};
  frame_.number = 0;
  frame_.wanted = frame_.wanted || wanted_;
  frame_.offered = frame_.offered || offered_;
  started_ = true;
  open();
}

void Camera::measure(std::span<double> values) noexcept {
  const Vec3d p = mounting_.position();
  MUROSIMF_ASSERT(values.size() == 14);
  // the true pose, also if the nominal one has an error
  const Quaterniond q = from_matrix(mounting_.orientation());
  const imaging::LensSpec& lens = eye_.spec().lens;
  const Vec3d& e = mounting_error_;
  const std::array<double, 14> all{p.x,     p.y,     p.z,     q.w,     q.x, q.y, q.z,
                                   lens.fx, lens.fy, lens.cx, lens.cy, e.x, e.y, e.z};
  std::copy(all.begin(), all.end(), values.begin());
}

void Camera::taken(std::uint64_t sample) noexcept {
  if (!source_) return;  // no source of pictures: the other outputs are valid nevertheless
  MUROSIMF_ASSERT(!on_the_way_.empty());
  CameraPicture& picture = on_the_way_[sample % on_the_way_.size()];
  frame_.draws = is_asked(frame_);
  if (!frame_.draws) {
    picture = {};  // not one of before
    return;
  }
  const CameraMotion motion{mounting_.position(), mounting_.orientation(), mounting_.velocity(),
                            mounting_.angular_velocity()};
  eye_.take(*source_, motion, sample, picture);
}

/// Saves the pictures under way; all else is computed for each of them.
void Camera::memory(StateArchive& archive) {
  for (CameraPicture& picture : on_the_way_) {
    archive(picture.view.color, picture.view.depth, picture.view.labels, picture.mosaic);
  }
}

void Camera::arrived(std::uint64_t sample) noexcept {
  if (!source_) return;
  // swapped, not copied: memory of frame and picture is used in turns
  CameraPicture& picture = on_the_way_[sample % on_the_way_.size()];
  if (is_empty(picture)) return;  // it was not asked for
  std::swap(eye_.has_mosaic() ? colors_behind_ : frame_.color, picture.view.color);
  std::swap(frame_.mosaic, picture.mosaic);
  std::swap(frame_.depth, picture.view.depth);
  std::swap(frame_.labels, picture.view.labels);
  frame_.time = reading().time;
  // counted from 1: 0 means no picture yet
  frame_.number = sample + 1;
}

}  // namespace murosimf::sensors
