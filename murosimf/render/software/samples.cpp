#include "murosimf/render/software/samples.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::render::software {
namespace {

constexpr float smooth = 0.9F;  // [1] cosine between normals of one smooth surface

/// Both belong to one piece, and face about the same direction; or both are only looked at.
bool are_alike(const SurfaceBuffer& buffer, std::int32_t a, std::int32_t b) {
  if (a == b || (a < 0 && b < 0)) return true;
  if (a <= 0 || b <= 0) return false;
  const Surface &one = buffer.surfaces()[static_cast<std::size_t>(a)],
                &other = buffer.surfaces()[static_cast<std::size_t>(b)];
  if (one.piece != other.piece) return false;
  float both = 0, square = 0, other_square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float x = one.normal[k].value, y = other.normal[k].value;
    both += x * y;
    square += x * x;
    other_square += y * y;
  }
  return both > 0 && both * both > smooth * smooth * square * other_square;
}

}  // namespace

Samples::Samples(int count) : across_(count >= 8 ? 4 : count >= 2 ? 2 : 1), down_(count >= 4 ? 2 : 1) {
  MUROSIMF_ASSERT(across_ * down_ == count);
}

sensors::Perspective Samples::enlarged(const sensors::Perspective& view) const {
  sensors::Perspective fine = view;
  fine.width *= across_;
  fine.height *= down_;
  fine.first_row *= down_;
  fine.rows *= down_;
  return fine;
}

/// Of the pixel whose first sample is (u, v).
bool Samples::is_alike(const SurfaceBuffer& fine, int u, int v) const {
  const std::int32_t first = fine.numbers(v)[u];
  for (int row = 0; row < down_; ++row) {
    const std::int32_t* numbers = fine.numbers(v + row) + u;
    for (int i = 0; i < across_; ++i) {
      if (!are_alike(fine, first, numbers[i])) return false;
    }
  }
  return true;
}

void Samples::leave_out_what_is_alike(SurfaceBuffer& fine) const {
  const PixelBox& box = fine.box();
  for (int v = box.top; v <= box.bottom; v += down_) {
    for (int u = box.left; u <= box.right; u += pixel_lanes) leave_out_group(fine, u, v);
  }
}

/// Of the pixels whose samples begin at (u, v); a group has all samples of some pixels.
void Samples::leave_out_group(SurfaceBuffer& fine, int u, int v) const {
  const std::int32_t first = fine.numbers(v)[u];
  Ints same = all_lanes(-1);
  for (int i = 0; i < down_; ++i) same &= load_lanes<Ints>(fine.numbers(v + i) + u) == first;
  if (all(same)) {
    for (int i = 0; i < down_; ++i) store_lanes(all_lanes(left_out), fine.numbers(v + i) + u);
    return;
  }
  for (int at = u; at < std::min(u + pixel_lanes, fine.box().right + 1); at += across_) {
    if (!is_alike(fine, at, v)) continue;
    for (int i = 0; i < down_; ++i) std::fill_n(fine.numbers(v + i) + at, across_, left_out);
  }
}

void Samples::average(const SurfaceBuffer& samples, const imaging::ColorImage& fine, int first_row, int rows,
                      imaging::ColorImage& into) const {
  const int count = across_ * down_;
  const auto mean = [&](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
  for (int v = first_row; v < first_row + rows; ++v) {
    for (int u = 0; u < into.width(); ++u) {
      if (samples.numbers(v * down_)[u * across_] == left_out) continue;
      int red = 0, green = 0, blue = 0;
      for (int i = 0; i < count; ++i) {
        const imaging::Rgb& pixel = fine(u * across_ + i % across_, v * down_ + i / across_);
        red += pixel.red;
        green += pixel.green;
        blue += pixel.blue;
      }
      into(u, v) = {mean(red), mean(green), mean(blue)};
    }
  }
}

}  // namespace murosimf::render::software
