/// image_png.h - pictures of cameras as PNG files, and what is no color made visible.
#pragma once

#include <string>

#include "murosimf/imaging/image.h"

namespace murosimf::render {

/// A PNG file, as bytes. Throws SetupError if this build has no pictures.
[[nodiscard]] std::string image_png(const sensors::ColorImage& image);

/// Near is bright, far is dark, nothing is black: linear in 1 / z from the nearest pixel on.
[[nodiscard]] sensors::ColorImage shown(const sensors::DepthImage& depth);
/// A color for each label, the same for the same label in all pictures.
[[nodiscard]] sensors::ColorImage shown(const sensors::LabelImage& labels);
/// A Bayer mosaic in shades of gray.
[[nodiscard]] sensors::ColorImage shown(const sensors::GrayImage& mosaic);

}  // namespace murosimf::render
