/// bayer.h - raw pictures: behind its filters, every pixel of a color sensor sees one color only.
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

/// Colors of the first two pixels of the first row, then of the second row. Source: Bayer, US patent 3971065 (1976).
enum class BayerPattern { rggb, bggr, grbg, gbrg };

[[nodiscard]] const std::vector<std::string_view>& bayer_patterns();
/// Throws SetupError if there is none of this name.
[[nodiscard]] BayerPattern bayer_pattern(std::string_view name);

/// Of each pixel the color that its filter lets through. Pictures have the same size.
void make_mosaic(const ColorImage& picture, BayerPattern pattern, GrayImage& mosaic) noexcept;

}  // namespace murosimf::imaging
