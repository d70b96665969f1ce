#include "murosimf/sensors/camera.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <fmt/format.h>

#include "murosimf/imaging/shared_value.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {
namespace {

std::vector<Output> outputs() {
  return {{"position", "m", {"x", "y", "z"}},
          {"orientation", "1", {"w", "x", "y", "z"}},
          {"intrinsics", "px", {"fx", "fy", "cx", "cy"}},
          {"mounting_error", "rad", {"roll", "pitch", "yaw"}}};
}

using LensKey = std::tuple<std::string, int, int, std::array<double, 6>, std::vector<double>>;

LensKey key_of(const imaging::LensSpec& lens, double resolution) {
  return {lens.model,
          lens.width,
          lens.height,
          {lens.fx, lens.fy, lens.cx, lens.cy, lens.skew, resolution},
          lens.coefficients};
}

/// Looking for folds turns the lens round for thousands of pixels.
std::shared_ptr<const std::string> shared_fold_remark(const imaging::LensSpec& lens) {
  return imaging::shared_value<std::string>(key_of(lens, 1), [&] { return imaging::Lens(lens).fold_remark(); });
}

std::shared_ptr<const imaging::LensMap> shared_map(const imaging::LensSpec& lens, double resolution) {
  return imaging::shared_value<imaging::LensMap>(key_of(lens, resolution),
                                                 [&] { return imaging::LensMap(imaging::Lens(lens), resolution); });
}

CameraInfo info_of(const SensorSpec& spec, const CameraSpec& camera, const Mounting& mounting, Duration period,
                   const std::vector<Entity*>& moving_entities) {
  const Mat3d turn = transpose(true_orientation(spec)) * spec.orientation;  // takes the error back
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
  return info;
}

Perspective perspective_of(const imaging::ViewWindow& window, const Vec3d& eye, const Mat3d& axes,
                           const imaging::Rows& rows) {
  Perspective perspective;
  perspective.eye = eye;
  perspective.axes = axes * window.axes;
  perspective.left = window.left;
  perspective.right = window.right;
  perspective.top = window.top;
  perspective.bottom = window.bottom;
  perspective.width = window.width;
  perspective.height = window.height;
  perspective.first_row = rows.first;
  perspective.rows = rows.count;
  return perspective;
}

/// What turns with `rate` [rad/s], a little later.
Mat3d turned(const Mat3d& axes, const Vec3d& rate, double ahead) {
  const double size = norm(rate);
  return size * ahead == 0 ? axes : rotation((1 / size) * rate, size * ahead) * axes;
}

/// With the size of the lens's picture: pictures take turns, and those that were never drawn have none yet.
template <class Pixel>
imaging::Image<Pixel>& sized(imaging::Image<Pixel>& image, const imaging::LensSpec& lens) {
  if (image.width() != lens.width || image.height() != lens.height)
    image = imaging::Image<Pixel>(lens.width, lens.height);
  return image;
}

}  // namespace

Camera::Camera(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, outputs()),
      spec_(camera_spec(spec)),
      mounting_error_(spec.mounting_error),
      mounting_(setup, spec),
      find_source_(surroundings.view_source),
      frame_(write_frame(setup, info_of(spec, spec_, mounting_, reading().info->period, surroundings.moving_entities))),
      noise_({spec_.shot_noise, spec_.read_noise},
             RandomStream(surroundings.seed, setup.entity().name() + "/" + spec.name + "/pixels")),
      on_the_way_(most_on_the_way()),
      fold_remark_(shared_fold_remark(frame_.info->lens.spec())) {
  read_motion_of_all(setup, surroundings);
  if (!spec_.mosaic.empty()) pattern_ = with_context("mosaic", [&] { return imaging::bayer_pattern(spec_.mosaic); });
  frame_.wanted = spec_.always_on;
}

/// It gets a label.
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
}

std::string Camera::remark(const LevelTraits&) const { return *fold_remark_; }

void Camera::start() {
  frame_.time = Duration{};
  frame_.number = 0;
  source_ = frame_.wanted && find_source_ ? find_source_() : nullptr;
  if (!source_) return;
  imaging::ImageNoise::make_tables();
  map_ = shared_map(spec_.lens, spec_.resolution);
  if (!map_->plain()) windows_ = Windows(map_->views());
  if (spec_.exposure_time > 0 && spec_.layers.color) mean_.emplace(spec_.lens.width, spec_.lens.height);
  if (spec_.blur > 0) blur_.emplace(spec_.blur, spec_.lens.width, spec_.lens.height);
  if (spec_.exposure != 1) exposure_.emplace(spec_.exposure);
}

void Camera::measure(std::span<double> values) noexcept {
  const Vec3d p = mounting_.position();
  const Quaterniond q = from_matrix(mounting_.orientation());
  const imaging::LensSpec& lens = spec_.lens;
  const Vec3d& e = mounting_error_;
  const std::array<double, 14> all{p.x,     p.y,     p.z,     q.w,     q.x, q.y, q.z,
                                   lens.fx, lens.fy, lens.cx, lens.cy, e.x, e.y, e.z};
  std::copy(all.begin(), all.end(), values.begin());
}

void Camera::taken(std::uint64_t sample) noexcept {
  if (!source_) return;
  Picture& picture = on_the_way_[sample % on_the_way_.size()];
  fit(spec_.layers.color, picture.view.color);
  fit(spec_.layers.depth, picture.view.depth);
  fit(spec_.layers.labels, picture.view.labels);
  fit(pattern_.has_value(), picture.mosaic);
  expose(picture.view);
  if (spec_.layers.color) develop(sample, picture.view.color, picture.mosaic);
}

/// Pictures on the way; all else is worked out for each of them.
void Camera::memory(StateArchive& archive) {
  for (Picture& picture : on_the_way_) {
    archive(picture.view.color, picture.view.depth, picture.view.labels, picture.mosaic);
  }
}

/// Images come back empty from the frame the first time.
template <class Pixel>
void Camera::fit(bool wanted, imaging::Image<Pixel>& image) const {
  if (wanted && image.empty()) image = imaging::Image<Pixel>(spec_.lens.width, spec_.lens.height);
}

void Camera::arrived(std::uint64_t sample) noexcept {
  if (!source_) return;
  Picture& picture = on_the_way_[sample % on_the_way_.size()];
  std::swap(pattern_ ? colors_behind_ : frame_.color, picture.view.color);
  std::swap(frame_.mosaic, picture.mosaic);
  std::swap(frame_.depth, picture.view.depth);
  std::swap(frame_.labels, picture.view.labels);
  frame_.time = reading().time;
  frame_.number = sample + 1;
}

void Camera::expose(View& picture) noexcept {
  if (!mean_) {
    look_at_all_rows(0, spec_.layers, picture);
    return;
  }
  mean_->clear();
  for (int i = 0; i < spec_.motion_samples; ++i) {
    // depths and labels are those of one instant
    const Layers layers{spec_.layers.color, spec_.layers.depth && i == 0, spec_.layers.labels && i == 0};
    look_at_all_rows(spec_.exposure_time * (i + 0.5) / spec_.motion_samples, layers, picture);
    mean_->add(picture.color);
  }
  mean_->write(picture.color);
}

void Camera::look_at_all_rows(double ahead, const Layers& layers, View& picture) noexcept {
  const int height = spec_.lens.height, bands = spec_.readout_time > 0 ? spec_.readout_bands : 1;
  for (int band = 0; band < bands; ++band) {
    const int first = height * band / bands, count = height * (band + 1) / bands - first;
    const double read = spec_.readout_time * (first + 0.5 * count) / height;
    look({first, count}, ahead + read, layers, picture);
  }
}

void Camera::look(const imaging::Rows& rows, double ahead, const Layers& layers, View& picture) noexcept {
  const Vec3d eye = mounting_.position() + ahead * mounting_.velocity();
  const Mat3d axes = turned(mounting_.orientation(), mounting_.angular_velocity(), ahead) * optical_axes;
  for (std::size_t i = 0; i < map_->views().size(); ++i) {
    const imaging::Rows needed = map_->plain() ? rows : map_->needed(i, rows);
    if (needed.count == 0) continue;
    const Perspective perspective = perspective_of(map_->views()[i], eye, axes, needed);
    if (map_->plain()) {
      source_->draw(perspective, layers, ahead, picture);
    } else {
      windows_.draw(*source_, perspective, layers, ahead, i);
    }
  }
  if (map_->plain()) return;
  if (layers.color) map_->apply(windows_.colors, sized(picture.color, spec_.lens), rows);
  if (layers.depth) map_->apply(windows_.depths, sized(picture.depth, spec_.lens), rows);
  if (layers.labels) map_->apply(windows_.labels, sized(picture.labels, spec_.lens), rows);
}

Camera::Windows::Windows(std::span<const imaging::ViewWindow> windows) {
  for (const imaging::ViewWindow& window : windows) {
    colors.emplace_back(window.width, window.height);
    depths.emplace_back(window.width, window.height);
    labels.emplace_back(window.width, window.height);
  }
}

void Camera::Windows::draw(ViewSource& source, const Perspective& perspective, const Layers& layers, double ahead,
                           std::size_t i) noexcept {
  View view{std::move(colors[i]), std::move(depths[i]), std::move(labels[i])};
  source.draw(perspective, layers, ahead, view);
  colors[i] = std::move(view.color);
  depths[i] = std::move(view.depth);
  labels[i] = std::move(view.labels);
}

void Camera::develop(std::uint64_t sample, imaging::ColorImage& color, imaging::GrayImage& mosaic) noexcept {
  if (blur_) blur_->apply(color);
  if (exposure_) exposure_->apply(color);
  if (spec_.shot_noise > 0 || spec_.read_noise > 0) noise_.apply(color, sample);
  if (pattern_) imaging::make_mosaic(color, *pattern_, sized(mosaic, spec_.lens));
}

}  // namespace murosimf::sensors
