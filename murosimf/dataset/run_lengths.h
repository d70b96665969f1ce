/// run_lengths.h - masks as COCO writes them: lengths of runs, down each column from the left, beginning with zeros; as a text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace murosimf::dataset {

/// Collects the pixels of a mask in the order of columns, each from the top.
class RunLengths {
 public:
  /// Pixels from `at` (column * height + row) to at + count - 1 are in the mask; not before those of earlier calls.
  void add(std::uint64_t at, std::uint64_t count);
  /// All runs of a mask with so many pixels.
  [[nodiscard]] std::vector<std::uint64_t> finish(std::uint64_t pixels) const;

 private:
  std::vector<std::uint64_t> counts_;
  std::uint64_t end_ = 0;
};

/// The text of `counts`: each length less the one before the last, in groups of five bits, lowest first, as characters from '0'.
/// Source: the data format page of COCO, and its rleToString.
[[nodiscard]] std::string run_length_text(const std::vector<std::uint64_t>& counts);

}  // namespace murosimf::dataset
