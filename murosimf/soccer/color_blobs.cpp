#include "murosimf/soccer/color_blobs.h"

#include <algorithm>
#include <tuple>

#include "murosimf/math/assert.h"

namespace murosimf::soccer {
namespace {

Blob begin_blob(int row, int first, int last) {
  MUROSIMF_ASSERT(row >= 0 && first >= 0 && first <= last);
  Blob blob;
  blob.left = first, blob.right = last;
  blob.top = blob.bottom = row;
  return blob;
}

/// Adds a run. Rows arrive from the top, runs of a row from the left.
void add(Blob& blob, int row, int first, int last) {
  MUROSIMF_ASSERT(first <= last && row >= blob.bottom);
  const int count = last - first + 1;
  const double middle = 0.5 * (first + last);
  if (blob.pixels == 0 || row > blob.bottom) blob.lowest = {middle, static_cast<double>(row)};
  blob.pixels += count;
  blob.center.u += count * middle;
  blob.center.v += static_cast<double>(count) * row;
  blob.left = std::min(blob.left, first);
  blob.right = std::max(blob.right, last);
  blob.bottom = row;
}

}  // namespace

const std::vector<Blob>& BlobFinder::find(const imaging::ColorImage& picture) noexcept {
  runs_.clear();
  std::size_t above = 0;
  for (int row = 0; row < picture.height(); ++row) {
    const std::size_t begin = runs_.size();
    add_runs(picture, row);
    join_rows(above, begin, runs_.size());
    above = begin;
  }
  collect();
  return blobs_;
}

void BlobFinder::add_runs(const imaging::ColorImage& picture, int row) noexcept {
  MUROSIMF_ASSERT(row >= 0 && row < picture.height());
  const auto pixels = picture.row(row);
  const int width = picture.width();
  for (int u = 0; u < width; ++u) {
    if (!color_.contains(pixels[u])) continue;
    const int first = u;
    while (u + 1 < width && color_.contains(pixels[u + 1])) ++u;
    runs_.push_back({row, first, u, runs_.size()});
  }
}

/// Joins runs [above, below) of one row with runs [below, end) of the next one where they touch.
void BlobFinder::join_rows(std::size_t above, std::size_t below, std::size_t end) noexcept {
  MUROSIMF_ASSERT(above <= below && below <= end && end <= runs_.size());
  const std::size_t first_below = below;
  while (above < first_below && below < end) {
    const Run &a = runs_[above], &b = runs_[below];
    // One column more on both sides: runs that touch by a corner belong together.
    if (a.first <= b.last + 1 && b.first <= a.last + 1) {
      const std::size_t i = root(above), j = root(below);
      // The older run is the root, so that a root is never behind its runs and collect() meets it first.
      runs_[std::max(i, j)].parent = std::min(i, j);
    }
    // The run that ends first cannot touch a later one of the other row.
    a.last < b.last ? ++above : ++below;
  }
}

std::size_t BlobFinder::root(std::size_t run) noexcept {
  MUROSIMF_ASSERT(run < runs_.size());
  // Halves the path on the way, so that later calls are short.
  while (runs_[run].parent != run) run = runs_[run].parent = runs_[runs_[run].parent].parent;
  return run;
}

void BlobFinder::collect() noexcept {
  blobs_.clear();
  blob_of_.resize(runs_.size());
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    const std::size_t head = root(i);
    MUROSIMF_ASSERT(head <= i);
    if (head == i) {
      blob_of_[i] = blobs_.size();
      blobs_.push_back(begin_blob(run.row, run.first, run.last));
    }
    add(blobs_[blob_of_[head]], run.row, run.first, run.last);
  }
  std::erase_if(blobs_, [&](const Blob& blob) { return blob.pixels < fewest_pixels_; });
  for (Blob& blob : blobs_) {
    MUROSIMF_ASSERT(blob.pixels > 0);
    blob.center = {blob.center.u / blob.pixels, blob.center.v / blob.pixels};
  }
  // A total order: equal sizes must not depend on the sorting algorithm of the library.
  std::sort(blobs_.begin(), blobs_.end(), [](const Blob& a, const Blob& b) {
    return std::tie(b.pixels, a.top, a.left) < std::tie(a.pixels, b.top, b.left);
  });
}

}  // namespace murosimf::soccer
