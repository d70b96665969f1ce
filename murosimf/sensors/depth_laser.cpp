#include "murosimf/sensors/depth_laser.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {
namespace {

// wider views would waste most pixels at their borders
constexpr double widest_row = 80 * pi / 180;  // [rad]
constexpr double pixels_per_ray = 8;
constexpr int fewest_pixels = 256, most_pixels = 8192;
constexpr double same_surface = 0.05;  // [1] by which depths of neighbors may differ

/// A picture of one row that looks at the angle `middle` of the fan and reaches to `half` on both sides [rad].
Perspective row_at(double middle, double half, int width) {
  Perspective row;
  row.axes.z = {std::cos(middle), std::sin(middle), 0};
  row.axes.x = {std::sin(middle), -std::cos(middle), 0};
  row.axes.y = {0, 0, -1};
  row.right = std::tan(half) * (1 + 4.0 / width);  // neighbors of the last rays, too
  row.left = -row.right;
  row.bottom = (row.right - row.left) / width / 2;  // the middle of its pixels is the plane
  row.top = -row.bottom;
  row.width = width;
  row.height = 1;
  row.finest = true;
  return row;
}

}  // namespace

DepthLaser::DepthLaser(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {laser_ranges(spec)}),
      robot_(setup.entity()),
      mounting_(setup, spec),
      range_(laser_range(spec)),
      find_source_(surroundings.view_source) {
  read_motion_of_all(setup, surroundings);
  const auto [count, first, fov] = laser_sector(spec);
  const auto rows = static_cast<std::size_t>(std::max(1.0, std::ceil(fov / widest_row)));
  const double sector = fov / static_cast<double>(rows);
  const double rays = count / static_cast<double>(rows);
  const int width = std::clamp(static_cast<int>(pixels_per_ray * rays), fewest_pixels, most_pixels);
  for (std::size_t i = 0; i < rows; ++i) {
    rows_.push_back(row_at(first + (static_cast<double>(i) + 0.5) * sector, std::max(0.5 * sector, 0.01), width));
    rows_.back().without = &robot_;
  }
  const collision::Fan fan(count, first, fov);
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const double angle = count < 2 ? 0 : fov * static_cast<double>(i) / (count - 1);
    const auto row = sector > 0 ? std::min(rows - 1, static_cast<std::size_t>(angle / sector)) : 0;
    const Vec3d seen = transposed_times(rows_[row].axes, fan.direction(i));
    const double u = (seen.x / seen.z - rows_[row].left) / (rows_[row].right - rows_[row].left) * width - 0.5;
    taps_.push_back({row, u, 1 / seen.z});
  }
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  for (const Perspective& row : rows_) views_.push_back({{}, imaging::DepthImage(row.width, 1, unknown), {}});
}

void DepthLaser::start() { source_ = find_source_ ? find_source_() : nullptr; }

void DepthLaser::look() noexcept {
  const Mat3d axes = mounting_.orientation();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Perspective row = rows_[i];
    row.eye = mounting_.position();
    row.axes = axes * row.axes;
    source_->draw(row, {.color = false, .depth = true, .labels = false}, 0, views_[i]);
  }
}

void DepthLaser::measure(std::span<double> values) noexcept {
  if (!source_) {
    std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  look();
  for (std::size_t i = 0; i < taps_.size(); ++i) {
    const Tap& tap = taps_[i];
    const auto row = std::as_const(views_[tap.row].depth).row(0);
    const auto left = static_cast<std::size_t>(tap.u);
    const double a = row[left], b = row[left + 1], share = tap.u - static_cast<double>(left);
    const bool together = std::abs(a - b) < same_surface * std::min(a, b);
    const double z = together ? 1 / ((1 - share) / a + share / b) : share < 0.5 ? a : b;
    values[i] = z * tap.stretch;
  }
  present(values);
}

void DepthLaser::present(std::span<double> values) noexcept {
  for (double& distance : values) distance = range_.shown(distance);
}

}  // namespace murosimf::sensors
