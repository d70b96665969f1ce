#include "murosimf/model/state_archive.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {

void StateArchive::one(std::string& text) {
  text.resize(count(text.size(), 1));
  raw(std::as_writable_bytes(std::span(text)));
}

std::size_t StateArchive::count(std::size_t number, std::size_t size) {
  auto saved = static_cast<std::uint64_t>(number);
  one(saved);
  if (loads() && saved > left_.size() / size) throw SetupError("it ends too early");
  return static_cast<std::size_t>(saved);
}

void StateArchive::check_count(std::size_t number) {
  auto saved = static_cast<std::uint64_t>(number);
  one(saved);
  if (saved != number) throw SetupError(fmt::format("it has {} values, not {}", saved, number));
}

void StateArchive::raw(std::span<std::byte> bytes) {
  if (!loads()) {
    saved_->insert(saved_->end(), bytes.begin(), bytes.end());
    return;
  }
  if (bytes.size() > left_.size()) throw SetupError("it ends too early");
  std::copy_n(left_.begin(), bytes.size(), bytes.begin());
  left_ = left_.subspan(bytes.size());
}

}  // namespace murosimf
