/// normals.h - directions of surfaces from depths.
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/imaging/lens.h"

namespace murosimf::dataset {

/// Rays of all pixels of a lens, with z = 1; zero where the lens sees nothing or beyond 90 degrees. Takes up to a second per megapixel.
[[nodiscard]] imaging::Image<Vec3d> rays_of(const imaging::Lens& lens);

/// Unit normals in the optical frame (x right, y down, z forward), toward the camera, as colors 127.5 (n + 1); black where nothing is. From
/// neighbors of the same label, the nearer ones: exact on planes.
[[nodiscard]] imaging::ColorImage normals_of(const imaging::DepthImage& depth, const imaging::LabelImage& labels,
                                             const imaging::Image<Vec3d>& rays);

}  // namespace murosimf::dataset
