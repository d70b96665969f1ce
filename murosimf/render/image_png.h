/// image_png.h - pictures of cameras as PNG files, and depths, labels and mosaics as colors.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

/// A PNG file, as bytes. Throws SetupError if this build has no pictures. `title`: UTF-8, one line, at the top left.
[[nodiscard]] std::string image_png(const imaging::ColorImage& image, const std::string& title = {});

/// Near is bright, far is dark, no measurement is black: linear in 1 / z from the nearest pixel on.
[[nodiscard]] imaging::ColorImage shown(const imaging::DepthImage& depth);
/// A color for each label, the same for the same label in all pictures.
[[nodiscard]] imaging::ColorImage shown(const imaging::LabelImage& labels);
/// A Bayer mosaic in shades of gray.
[[nodiscard]] imaging::ColorImage shown(const imaging::GrayImage& mosaic);

}  // namespace murosimf::render
