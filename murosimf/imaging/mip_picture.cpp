#include "murosimf/imaging/mip_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "murosimf/imaging/srgb.h"

namespace murosimf::imaging {
namespace {

/// Pixels of a side that a pixel of half as many covers, and how much of each.
struct Covered {
  int first = 0, count = 0;
  std::array<double, 3> share{};
};

/// `i`: of `half` pixels; an odd side has three to a pixel, of which it shares the outer ones with its neighbors.
Covered covered_by(int i, int half, int size) {
  const double width = static_cast<double>(size) / half, begin = i * width, end = begin + width;
  Covered covered;
  covered.first = static_cast<int>(begin);
  for (int k = covered.first; k < size && k < end && covered.count < 3; ++k)
    covered.share[static_cast<std::size_t>(covered.count++)] = std::min(end, k + 1.0) - std::max(begin, double{1} * k);
  return covered;
}

ColorImage half_of(const ColorImage& picture) {
  ColorImage half(std::max(1, picture.width() / 2), std::max(1, picture.height() / 2));
  const auto& light = light_table();
  for (int v = 0; v < half.height(); ++v) {
    const Covered rows = covered_by(v, half.height(), picture.height());
    for (int u = 0; u < half.width(); ++u) {
      const Covered columns = covered_by(u, half.width(), picture.width());
      std::array<double, 3> sum{};
      double area = 0;
      for (int j = 0; j < rows.count; ++j) {
        for (int i = 0; i < columns.count; ++i) {
          const double share = rows.share[static_cast<std::size_t>(j)] * columns.share[static_cast<std::size_t>(i)];
          const Rgb& pixel = picture(columns.first + i, rows.first + j);
          sum[0] += share * light[pixel.red];
          sum[1] += share * light[pixel.green];
          sum[2] += share * light[pixel.blue];
          area += share;
        }
      }
      const auto value = [&](double part) { return value_table()[static_cast<std::size_t>(std::lround(part / area))]; };
      half(u, v) = {value(sum[0]), value(sum[1]), value(sum[2])};
    }
  }
  return half;
}

}  // namespace

MipPicture mip_picture(ColorImage picture) {
  MUROSIMF_ASSERT(!picture.empty());
  MipPicture mip;
  mip.levels.push_back(std::move(picture));
  while (mip.levels.back().width() > 1 || mip.levels.back().height() > 1)
    mip.levels.push_back(half_of(mip.levels.back()));
  return mip;
}

}  // namespace murosimf::imaging
