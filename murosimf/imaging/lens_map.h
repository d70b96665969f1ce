/// lens_map.h - a picture through a lens, made of perspective views by looking every pixel up.
///
///     const LensMap map(lens);
///     for (const ViewWindow& view : map.views()) ...              // render each of them
///     map.apply(rendered, picture, 0, picture.height());
///
/// A map depends on the lens only: cameras with equal lenses can share one. Bands of rows can be made one by one, of
/// views rendered at different times: that is a rolling shutter.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/imaging/lens.h"
#include "murosimf/imaging/lens_views.h"

namespace murosimf::imaging {

/// Rows of a picture: `count` from `first`.
struct Rows {
  int first = 0, count = 0;
};

class LensMap {
 public:
  /// `resolution`: pixels of a view per pixel of the picture, where the lens is finest. More makes no sharper pictures.
  /// Throws SetupError if it is not 0.1 to 4. Takes about a second per megapixel.
  explicit LensMap(const Lens& lens, double resolution = 1);

  [[nodiscard]] std::span<const ViewWindow> views() const noexcept { return views_; }
  /// There is one view, and its pixels are those of the picture.
  [[nodiscard]] bool plain() const noexcept { return taps_.empty() && !views_.empty(); }
  [[nodiscard]] int width() const noexcept { return width_; }    ///< of the picture [px]
  [[nodiscard]] int height() const noexcept { return height_; }  ///< of the picture [px]
  /// The rows of a view that some rows of the picture are made of.
  [[nodiscard]] Rows needed(std::size_t view, const Rows& rows) const noexcept;

  /// Makes some rows of `picture` from the pictures of all views, which have the sizes that views() say; `picture` has
  /// the size of the lens. Colors are interpolated between four pixels, as sRGB. Without a ray: black.
  void apply(std::span<const ColorImage> views, ColorImage& picture, const Rows& rows) const noexcept;
  /// Depths of views are z in the view's frame; that of the picture is z in the camera's optical frame, so it is
  /// negative beyond 90 degrees from the axis. Interpolates 1 / z, which is exact on planes, where four neighbors
  /// differ by less than 5 %; takes the nearest one at edges. Without a ray: infinite.
  void apply(std::span<const DepthImage> views, DepthImage& picture, const Rows& rows) const noexcept;
  /// Labels of the nearest pixels. Without a ray: 0.
  void apply(std::span<const LabelImage> views, LabelImage& picture, const Rows& rows) const noexcept;

 private:
  /// Where one pixel of the picture comes from: a pixel of the view and its right, lower and lower right neighbors.
  struct Tap {
    std::uint32_t offset;       ///< of the upper left one, in pixels of the view
    std::uint8_t right, below;  ///< how far beyond it the place is [1/256 px]
  };
  /// Neighboring pixels of a row that come from one view, or from none.
  struct Run {
    int first, end, view;
  };

  void look_up_all(std::span<const ViewPlace> places);
  void add_row(std::span<const ViewPlace> places);
  [[nodiscard]] Tap tap(const ViewPlace& place) const;
  [[nodiscard]] float camera_z(const ViewPlace& place) const;
  template <class Pixel, class Look>
  void look_up(std::span<const Image<Pixel>> views, Image<Pixel>& picture, const Rows& rows, const Pixel& blind,
               const Look& look) const noexcept;

  int width_, height_;
  std::vector<ViewWindow> views_;
  std::vector<Tap> taps_;  ///< of all pixels, row by row; none if plain
  std::vector<float>
      camera_z_;  ///< of all pixels: z in the camera's frame where that of the view is 1; none if one view
  std::vector<Run> runs_;
  std::vector<std::size_t> first_run_;  ///< of every row, and the end
  std::vector<Rows> needed_;            ///< for every row: of every view
};

}  // namespace murosimf::imaging
