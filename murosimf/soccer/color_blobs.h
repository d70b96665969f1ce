/// color_blobs.h - connected regions of one color in a picture.
///
/// Rows are cut into runs of pixels of the class; runs that touch in neighboring rows, also by a corner, belong together.
/// Source: runs merged by a disjoint-set forest as in Bruce, Balch, Veloso, "Fast and inexpensive color image
/// segmentation for interactive robots", IROS 2000.
#pragma once

#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/imaging/lens.h"
#include "murosimf/soccer/color_class.h"

namespace murosimf::soccer {

struct Blob {
  int pixels = 0;
  int left = 0, right = 0, top = 0, bottom = 0;  ///< [px] the box around it, all inside
  imaging::Pixel center;                         ///< [px] mean of its pixels
  imaging::Pixel lowest;                         ///< [px] middle of its lowest run; of several, the first from the left
};

/// Finds blobs and keeps its buffers from picture to picture.
class BlobFinder {
 public:
  explicit BlobFinder(const ColorClass& color, int fewest_pixels = 20) : color_(color), fewest_pixels_(fewest_pixels) {}

  /// Blobs of at least `fewest_pixels`, the largest first; of equal ones the higher first. Valid until the next picture.
  [[nodiscard]] const std::vector<Blob>& find(const imaging::ColorImage& picture) noexcept;

 private:
  struct Run {
    int row, first, last;  // [px] all inside
    std::size_t parent;    // another run of the same blob; itself: the root
  };
  void add_runs(const imaging::ColorImage& picture, int row) noexcept;
  void join_rows(std::size_t above, std::size_t below, std::size_t end) noexcept;
  [[nodiscard]] std::size_t root(std::size_t run) noexcept;
  void collect() noexcept;

  ColorClass color_;
  int fewest_pixels_;
  std::vector<Run> runs_;
  std::vector<Blob> blobs_;
  std::vector<std::size_t> blob_of_;  // by run: index of a root's blob
};

}  // namespace murosimf::soccer
