#include "murosimf/sensors/lens_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

constexpr int steps = 256;  // of a pixel: places between pixels are that fine

ViewWindow whole_picture(const LensSpec& spec) {
  return {.axes = {},
          .left = (-0.5 - spec.cx) / spec.fx,
          .right = (spec.width - 0.5 - spec.cx) / spec.fx,
          .top = (-0.5 - spec.cy) / spec.fy,
          .bottom = (spec.height - 0.5 - spec.cy) / spec.fy,
          .width = spec.width,
          .height = spec.height};
}

/// The union of two bands.
Rows joined(const Rows& a, const Rows& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const int first = std::min(a.first, b.first);
  return {first, std::max(a.first + a.count, b.first + b.count) - first};
}

/// Four bytes from a pixel on: its colors, and one of the next pixel's.
std::uint32_t bytes_at(const Rgb* pixel) noexcept {
  std::uint32_t bytes;
  std::memcpy(&bytes, pixel, sizeof bytes);
  return bytes;
}

/// Red and blue are averaged at once, in the halves of one number: 255 * 256 fits into 16 bits.
Rgb mean(const Rgb* above, const Rgb* below, std::uint32_t x, std::uint32_t y) noexcept {
  constexpr std::uint32_t odd = 0x00ff00ff, half = 0x00800080;
  const std::uint32_t w11 = x * y / steps, w01 = x - w11, w10 = y - w11, w00 = steps - x - w10;
  const std::uint32_t p00 = bytes_at(above), p01 = bytes_at(above + 1), p10 = bytes_at(below),
                      p11 = bytes_at(below + 1);
  const std::uint32_t outer = (p00 & odd) * w00 + (p01 & odd) * w01 + (p10 & odd) * w10 + (p11 & odd) * w11 + half;
  const auto middle = [](std::uint32_t p) { return p >> 8 & 0xffU; };
  const std::uint32_t green = middle(p00) * w00 + middle(p01) * w01 + middle(p10) * w10 + middle(p11) * w11 + steps / 2;
  return {static_cast<std::uint8_t>(outer >> 8), static_cast<std::uint8_t>(green >> 8),
          static_cast<std::uint8_t>(outer >> 24)};
}

/// 1 / z is linear on the picture of a plane.
float mean_depth(const float* above, const float* below, int x, int y) noexcept {
  const float a = above[0], b = above[1], c = below[0], d = below[1];
  const float least = std::min(std::min(a, b), std::min(c, d)), most = std::max(std::max(a, b), std::max(c, d));
  if (!(most <= 1.05F * least)) return (y < steps / 2 ? above : below)[x < steps / 2 ? 0 : 1];
  const float s = static_cast<float>(x) / steps, t = static_cast<float>(y) / steps;
  return 1 / ((1 - t) * ((1 - s) / a + s / b) + t * ((1 - s) / c + s / d));
}

}  // namespace

LensMap::LensMap(const Lens& lens, double resolution) : width_(lens.spec().width), height_(lens.spec().height) {
  if (!(resolution >= 0.1 && resolution <= 4)) {
    throw SetupError(fmt::format("the resolution of a lens's views is {}; it must be 0.1 to 4", resolution));
  }
  if (lens.plain() && resolution == 1) {
    views_ = {whole_picture(lens.spec())};
    return;
  }
  LensViews chosen = choose_views(lens, resolution);
  views_ = std::move(chosen.windows);
  look_up_all(chosen.places);
}

void LensMap::look_up_all(std::span<const ViewPlace> places) {
  taps_.reserve(places.size());
  if (views_.size() > 1) camera_z_.reserve(places.size());
  const auto width = static_cast<std::size_t>(width_);
  for (std::size_t first = 0; first < places.size(); first += width) add_row(places.subspan(first, width));
  first_run_.push_back(runs_.size());
}

void LensMap::add_row(std::span<const ViewPlace> places) {
  first_run_.push_back(runs_.size());
  std::vector<Rows> needed(views_.size());
  for (int u = 0; u < width_; ++u) {
    const ViewPlace& place = places[static_cast<std::size_t>(u)];
    if (u == 0 || runs_.back().view != place.view) runs_.push_back({u, u, place.view});
    runs_.back().end = u + 1;
    taps_.push_back(tap(place));
    if (views_.size() > 1) camera_z_.push_back(camera_z(place));
    if (place.view == ViewPlace::none) continue;
    const auto view = static_cast<std::size_t>(place.view);
    const auto row = static_cast<int>(taps_.back().offset / static_cast<std::uint32_t>(views_[view].width));
    needed[view] = joined(needed[view], {row, 2});
  }
  needed_.insert(needed_.end(), needed.begin(), needed.end());
}

LensMap::Tap LensMap::tap(const ViewPlace& place) const {
  if (place.view == ViewPlace::none) return {0, 0, 0};
  const ViewWindow& window = views_[static_cast<std::size_t>(place.view)];
  const Pixel pixel = window.pixel(place.x, place.y);
  const long u = std::lround(pixel.u * steps), v = std::lround(pixel.v * steps);
  return {static_cast<std::uint32_t>(v / steps * window.width + u / steps), static_cast<std::uint8_t>(u % steps),
          static_cast<std::uint8_t>(v % steps)};
}

float LensMap::camera_z(const ViewPlace& place) const {
  if (place.view == ViewPlace::none) return 1;
  const Mat3d& axes = views_[static_cast<std::size_t>(place.view)].axes;
  return static_cast<float>(axes.x.z * place.x + axes.y.z * place.y + axes.z.z);
}

Rows LensMap::needed(std::size_t view, const Rows& rows) const noexcept {
  if (plain()) return rows;
  Rows all;
  for (int row = rows.first; row < rows.first + rows.count; ++row) {
    all = joined(all, needed_[static_cast<std::size_t>(row) * views_.size() + view]);
  }
  return all;
}

/// `look` gets the index of a pixel of the picture, its tap, the pixel there in the view and the one below.
template <class Pixel, class Look>
void LensMap::look_up(std::span<const Image<Pixel>> views, Image<Pixel>& picture, const Rows& rows, const Pixel& blind,
                      const Look& look) const noexcept {
  for (int row = rows.first; row < rows.first + rows.count; ++row) {
    const auto target = picture.row(row);
    if (plain()) {
      std::ranges::copy(views[0].row(row), target.begin());
      continue;
    }
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    for (std::size_t i = first_run_[static_cast<std::size_t>(row)]; i < first_run_[static_cast<std::size_t>(row) + 1];
         ++i) {
      const Run& run = runs_[i];
      Pixel* to = target.data() + run.first;
      if (run.view == ViewPlace::none) {
        std::fill(to, target.data() + run.end, blind);
        continue;
      }
      const Image<Pixel>& view = views[static_cast<std::size_t>(run.view)];
      const Pixel* from = view.pixels().data();
      const std::size_t end = start + static_cast<std::size_t>(run.end);
      for (std::size_t k = start + static_cast<std::size_t>(run.first); k < end; ++k) {
        const Pixel* above = from + taps_[k].offset;
        *to++ = look(k, taps_[k], above, above + view.width());
      }
    }
  }
}

void LensMap::apply(std::span<const ColorImage> views, ColorImage& picture, const Rows& rows) const noexcept {
  look_up(views, picture, rows, Rgb{}, [](std::size_t, const Tap& tap, const Rgb* above, const Rgb* below) {
    return mean(above, below, tap.right, tap.below);
  });
}

void LensMap::apply(std::span<const DepthImage> views, DepthImage& picture, const Rows& rows) const noexcept {
  const auto look = [this](std::size_t k, const Tap& tap, const float* above, const float* below) {
    const float depth = mean_depth(above, below, tap.right, tap.below);
    return camera_z_.empty() || std::isinf(depth) ? depth : depth * camera_z_[k];
  };
  look_up(views, picture, rows, std::numeric_limits<float>::infinity(), look);
}

void LensMap::apply(std::span<const LabelImage> views, LabelImage& picture, const Rows& rows) const noexcept {
  const auto look = [](std::size_t, const Tap& tap, const std::uint16_t* above, const std::uint16_t* below) {
    return (tap.below < steps / 2 ? above : below)[tap.right < steps / 2 ? 0 : 1];
  };
  look_up(views, picture, rows, std::uint16_t{0}, look);
}

}  // namespace murosimf::sensors
