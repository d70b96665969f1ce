#include "murosimf/sensors/camera_model.h"

#include <array>
#include <tuple>

#include "murosimf/imaging/shared_value.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

using LensKey = std::tuple<std::string, int, int, std::array<double, 6>, std::vector<double>>;

LensKey key_of(const imaging::LensSpec& lens, double resolution) {
  return {lens.model,
          lens.width,
          lens.height,
          {lens.fx, lens.fy, lens.cx, lens.cy, lens.skew, resolution},
          lens.coefficients};
}

std::shared_ptr<const imaging::LensMap> shared_map(const imaging::LensSpec& lens, double resolution) {
  return imaging::shared_value<imaging::LensMap>(key_of(lens, resolution),
                                                 [&] { return imaging::LensMap(imaging::Lens(lens), resolution); });
}

Perspective perspective_of(const imaging::ViewWindow& window, const Vec3d& eye, const Mat3d& axes,
                           const imaging::Rows& rows) {
  Perspective perspective;
  perspective.eye = eye;
  MUROSIMF_ASSERT(rows.count >= 0);
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

/// Axes that turn with `rate` [rad/s], `ahead` [s] later.
Mat3d turned(const Mat3d& axes, const Vec3d& rate, double ahead) {
  const double size = norm(rate);
  return size * ahead == 0 ? axes : rotation((1 / size) * rate, size * ahead) * axes;
}

/// Gives an image the size of the lens's picture: images are swapped, and new ones are empty.
template <class Pixel>
imaging::Image<Pixel>& sized(imaging::Image<Pixel>& image, const imaging::LensSpec& lens) {
  if (image.width() != lens.width || image.height() != lens.height)
    image = imaging::Image<Pixel>(lens.width, lens.height);
  return image;
}

}  // namespace

RandomStream pixel_stream(std::uint64_t seed, const std::string& robot, const std::string& camera) {
  // a stream of its own: other sensors keep their random numbers
  return {seed, robot + "/" + camera + "/pixels"};
}

std::shared_ptr<const std::string> shared_fold_warning(const imaging::LensSpec& lens) {
  return imaging::shared_value<std::string>(key_of(lens, 1), [&] { return imaging::Lens(lens).fold_warning(); });
}

CameraModel::CameraModel(const CameraSpec& spec, const RandomStream& noise)
    : spec_(spec), noise_({spec.shot_noise, spec.read_noise}, noise) {
  if (!spec_.mosaic.empty()) pattern_ = with_context("mosaic", [&] { return imaging::bayer_pattern(spec_.mosaic); });
}

void CameraModel::open() {
  imaging::ImageNoise::make_tables();  // here and not while stepping
  map_ = shared_map(spec_.lens, spec_.resolution);
  // a plain lens is drawn straight into the picture, without a map
  if (!map_->plain()) windows_ = Windows(map_->views());
  if (spec_.exposure_time > 0 && spec_.layers.color) mean_.emplace(spec_.lens.width, spec_.lens.height);
  if (spec_.blur > 0) blur_.emplace(spec_.blur, spec_.lens.width, spec_.lens.height);
  // parts of the model that change nothing are left out
  if (spec_.exposure != 1) exposure_.emplace(spec_.exposure);
  if (spec_.vignetting > 0) vignette_.emplace(spec_.vignetting, spec_.lens.width, spec_.lens.height);
  if (norm(spec_.white_balance - Vec3d{1, 1, 1}) > 0) white_balance_.emplace(spec_.white_balance);
}

void CameraModel::take(ViewSource& source, const CameraMotion& motion, std::uint64_t number,
                       CameraPicture& picture) noexcept {
  fit(spec_.layers.color, picture.view.color);
  fit(spec_.layers.depth, picture.view.depth);
  fit(spec_.layers.labels, picture.view.labels);
  fit(pattern_.has_value(), picture.mosaic);
  expose(source, motion, picture.view);
  if (spec_.layers.color) develop(number, picture.view.color, picture.mosaic);
}

/// Images that are swapped out of the frame are empty the first time.
template <class Pixel>
void CameraModel::fit(bool wanted, imaging::Image<Pixel>& image) const {
  if (wanted) imaging::fit(image, spec_.lens.width, spec_.lens.height);
}

void CameraModel::expose(ViewSource& source, const CameraMotion& motion, View& picture) noexcept {
  if (!mean_) {
    MUROSIMF_ASSERT(map_);
    look_at_all_rows(source, motion, 0, spec_.layers, picture);
    return;
  }
  mean_->clear();
  for (int i = 0; i < spec_.motion_samples; ++i) {
    // samples in the middle of equal parts of the exposure: their mean is that of the whole time
    // depth and labels are those of the first instant: they cannot be averaged
    const Layers layers{spec_.layers.color, spec_.layers.depth && i == 0, spec_.layers.labels && i == 0};
    look_at_all_rows(source, motion, spec_.exposure_time * (i + 0.5) / spec_.motion_samples, layers, picture);
    mean_->add(picture.color);
  }
  mean_->write(picture.color);
}

void CameraModel::look_at_all_rows(ViewSource& source, const CameraMotion& motion, double ahead, const Layers& layers,
                                   View& picture) noexcept {
  const int height = spec_.lens.height, bands = spec_.readout_time > 0 ? spec_.readout_bands : 1;
  MUROSIMF_ASSERT(bands > 0);
  for (int band = 0; band < bands; ++band) {
    // whole rows: every row belongs to exactly one band
    const int first = height * band / bands, count = height * (band + 1) / bands - first;
    const double read = spec_.readout_time * (first + 0.5 * count) / height;
    look(source, motion, {first, count}, ahead + read, layers, picture);
  }
}

void CameraModel::look(ViewSource& source, const CameraMotion& motion, const imaging::Rows& rows, double ahead,
                       const Layers& layers, View& picture) noexcept {
  // positions are extrapolated: the motion within a picture is nearly uniform
  const Vec3d eye = motion.position + ahead * motion.velocity;
  const Mat3d axes = turned(motion.orientation, motion.angular_velocity, ahead) * optical_axes;
  // a wide lens needs several views, each a perspective
  for (std::size_t i = 0; i < map_->views().size(); ++i) {
    const imaging::Rows needed = map_->plain() ? rows : map_->needed(i, rows);
    if (needed.count == 0) continue;  // this view shows none of the rows
    const Perspective perspective = perspective_of(map_->views()[i], eye, axes, needed);
    if (map_->plain()) {
      source.draw(perspective, layers, ahead, picture);
    } else {
      windows_.draw(source, perspective, layers, ahead, i);
    }
  }
  if (map_->plain()) return;
  if (layers.color) map_->apply(windows_.colors, sized(picture.color, spec_.lens), rows);
  if (layers.depth) map_->apply(windows_.depths, sized(picture.depth, spec_.lens), rows);
  if (layers.labels) map_->apply(windows_.labels, sized(picture.labels, spec_.lens), rows);
}

CameraModel::Windows::Windows(std::span<const imaging::ViewWindow> windows) {
  for (const imaging::ViewWindow& window : windows) {
    colors.emplace_back(window.width, window.height);
    depths.emplace_back(window.width, window.height);
    labels.emplace_back(window.width, window.height);
  }
}

void CameraModel::Windows::draw(ViewSource& source, const Perspective& perspective, const Layers& layers, double ahead,
                                std::size_t i) noexcept {
  MUROSIMF_ASSERT(i < colors.size() && i < depths.size() && i < labels.size());
  View view{std::move(colors[i]), std::move(depths[i]), std::move(labels[i])};
  source.draw(perspective, layers, ahead, view);
  colors[i] = std::move(view.color);
  depths[i] = std::move(view.depth);
  labels[i] = std::move(view.labels);
}

void CameraModel::develop(std::uint64_t number, imaging::ColorImage& color, imaging::GrayImage& mosaic) noexcept {
  // in the order of a camera: optics, exposure, sensor, its electronics, filter
  if (blur_) blur_->apply(color);
  if (vignette_) vignette_->apply(color);
  if (exposure_) exposure_->apply(color);
  if (spec_.shot_noise > 0 || spec_.read_noise > 0) noise_.apply(color, number);
  if (white_balance_) white_balance_->apply(color);
  if (pattern_) imaging::make_mosaic(color, *pattern_, sized(mosaic, spec_.lens));
}

}  // namespace murosimf::sensors
