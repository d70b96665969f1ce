#include "murosimf/render/software/samples.h"

#include "murosimf/math/assert.h"

namespace murosimf::render::software {

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

void Samples::average(const imaging::ColorImage& fine, int first_row, int rows, imaging::ColorImage& into) const {
  const int count = across_ * down_;
  const auto mean = [&](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
  for (int v = first_row; v < first_row + rows; ++v) {
    for (int u = 0; u < into.width(); ++u) {
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
