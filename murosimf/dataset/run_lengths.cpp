#include "murosimf/dataset/run_lengths.h"

#include "murosimf/math/assert.h"

namespace murosimf::dataset {

void RunLengths::add(std::uint64_t at, std::uint64_t count) {
  MUROSIMF_ASSERT(at >= end_);
  if (!counts_.empty() && at == end_) {
    counts_.back() += count;
  } else {
    counts_.push_back(at - end_);
    counts_.push_back(count);
  }
  end_ = at + count;
}

std::vector<std::uint64_t> RunLengths::finish(std::uint64_t pixels) const {
  MUROSIMF_ASSERT(end_ <= pixels);
  std::vector<std::uint64_t> counts = counts_;
  if (end_ < pixels) counts.push_back(pixels - end_);
  return counts;
}

std::string run_length_text(const std::vector<std::uint64_t>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    auto rest = static_cast<std::int64_t>(counts[i]);
    if (i > 2) rest -= static_cast<std::int64_t>(counts[i - 2]);
    for (bool more = true; more;) {
      const std::int64_t group = rest & 31;
      rest >>= 5;
      more = (group & 16) != 0 ? rest != -1 : rest != 0;
      text += static_cast<char>('0' + group + (more ? 32 : 0));
    }
  }
  return text;
}

}  // namespace murosimf::dataset
