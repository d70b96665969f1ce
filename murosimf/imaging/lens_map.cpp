#include "murosimf/imaging/lens_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

// fixed point: interpolation in whole numbers is exact and the same on every machine
constexpr int steps = 256;  // of a pixel: places between pixels are that fine
static_assert(std::endian::native == std::endian::little, "colors are read as numbers, red in the lowest byte");

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

/// Two pixels and two bytes of the next one.
std::uint64_t bytes_at(const Rgb* pixel) noexcept {
  std::uint64_t bytes;
  std::memcpy(&bytes, pixel, sizeof bytes);
  return bytes;
}

/// The mean of two times four bytes, each in 16 bits of a number; `share` of 256 of the second.
std::uint64_t blended(std::uint64_t a, std::uint64_t b, std::uint64_t share) noexcept {
  constexpr std::uint64_t low_bytes = 0x00ff00ff00ff00ff, half = 0x0080008000800080;
  return (a * (steps - share) + b * share + half) >> 8 & low_bytes;
}

/// Rows are averaged first, then what is left of the place with what is right of it. Bytes of a row are
/// r g b r g b: every second one, from the first and from the second on, makes room for products.
Rgb mean(const Rgb* above, const Rgb* below, std::uint64_t x, std::uint64_t y) noexcept {
  constexpr std::uint64_t low_bytes = 0x00ff00ff00ff00ff;
  const std::uint64_t a = bytes_at(above), b = bytes_at(below);
  const std::uint64_t red_blue_green = blended(a & low_bytes, b & low_bytes, y);            // r0 b0 g1
  const std::uint64_t green_red_blue = blended(a >> 8 & low_bytes, b >> 8 & low_bytes, y);  // g0 r1 b1
  const std::uint64_t left = (red_blue_green & 0xffffffff) | green_red_blue << 32;          // r0 b0 g0, and more
  const std::uint64_t right = (green_red_blue >> 16 & 0xffffffff) | (red_blue_green & 0xffff00000000);  // r1 b1 g1
  const std::uint64_t color = blended(left & 0xffffffffffff, right, x);
  return {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 32),
          static_cast<std::uint8_t>(color >> 16)};
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
      const auto width = static_cast<std::size_t>(view.width());
      const Tap* taps = taps_.data();
      const std::size_t end = start + static_cast<std::size_t>(run.end);
      for (std::size_t k = start + static_cast<std::size_t>(run.first); k < end; ++k) {
        const Tap tap = taps[k];
        const Pixel* above = from + tap.offset;
        *to++ = look(k, tap, above, above + width);
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

}  // namespace murosimf::imaging
