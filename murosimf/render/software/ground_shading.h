/// ground_shading.h - the ground in a picture: floor, field, lines and the dark places below what stands on it.
#pragma once

#include <span>
#include <vector>

#include "murosimf/render/contact_shadows.h"
#include "murosimf/render/software/coverage.h"
#include "murosimf/render/software/patterns.h"
#include "murosimf/render/software/pixel_rays.h"
#include "murosimf/render/software/shadow_map.h"
#include "murosimf/render/stroke_pieces.h"

namespace murosimf::render::software {

/// Colors [1, sRGB] of a row of pixels; rows are longer than the picture, so that groups fit in.
struct RowColors {
  void resize(int width) {
    for (auto* row : {&red, &green, &blue, &pile, &lit}) row->resize(static_cast<std::size_t>(width + 2 * pixel_lanes));
  }
  [[nodiscard]] Floats3 load(int u) const {
    return {load_lanes<Floats>(red.data() + u), load_lanes<Floats>(green.data() + u),
            load_lanes<Floats>(blue.data() + u)};
  }
  void store(int u, const Floats3& colors) {
    store_lanes(colors.x, red.data() + u);
    store_lanes(colors.y, green.data() + u);
    store_lanes(colors.z, blue.data() + u);
  }
  std::vector<float> red, green, blue;
  std::vector<float> pile, lit;  ///< where the ground is seen: height of the pile; share of the lamp's light
};

/// Columns of a row in which something of that number may be seen.
struct RowPart {
  int number = 0, first = 0, last = 0;
};

struct PicturePoint {
  float u = 0, v = 0;  ///< [px]
};

/// Parts of all rows of a picture.
class RowParts {
 public:
  void begin(int height);
  /// Adds a convex outline, a pixel larger to all sides. Parts behind the eye are cut off.
  void add(int number, const PixelRays& rays, std::span<const Vec3d> outline, const PixelBox& within);
  [[nodiscard]] std::span<const RowPart> of(int v) const { return rows_[static_cast<std::size_t>(v)]; }

 private:
  std::vector<std::vector<RowPart>> rows_;
  std::vector<PicturePoint> points_;
};

class GroundShading {
 public:
  explicit GroundShading(std::vector<StrokePiece> strokes) : strokes_(std::move(strokes)) {}

  /// Finds what is in these rows of a picture. `shadows`: null if none are cast.
  void begin(const PixelRays& rays, const PixelBox& within, std::vector<ContactShadow> contacts,
             const ShadowLookup* shadows);
  /// The colors of a row, where the ground is not hidden by what has a number. Others stay as they are.
  void paint(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
             RowColors& colors) const;
  /// Marks pixels of the row that are covered by more than half by lines.
  void mark_lines(const PixelRays& rays, int v, const std::int32_t* numbers, std::uint16_t label,
                  std::span<std::uint16_t> labels) const;

  /// The pixels that show the ground if nothing is before it; per_z is that of the ground.
  [[nodiscard]] static Ints is_there(const RowRays& rays, const GroundPlaces& places, const Floats& per_z) {
    if (all(per_z > rays.near_ground)) return all_lanes(-1);
    constexpr auto reach = static_cast<float>(floor_reach);
    return (per_z > 0) & (magnitude(places.x - rays.around_x) <= reach) &
           (magnitude(places.y - rays.around_y) <= reach);
  }

 private:
  void paint_area(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
                  RowColors& colors) const;
  void paint_strokes(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
                     RowColors& colors) const;
  void paint_contacts(const PixelRays& rays, int v, const std::int32_t* numbers, RowColors& colors) const;

  std::vector<StrokePiece> strokes_;
  std::vector<ContactShadow> contacts_;
  RowParts stroke_parts_, contact_parts_;
  const ShadowLookup* shadows_ = nullptr;
};

}  // namespace murosimf::render::software
