#include "murosimf/world/state_archive.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {

void StateArchive::one(std::string& text) {
  text.resize(count(text.size(), 1));
  raw(std::as_writable_bytes(std::span(text)));
}

std::size_t StateArchive::count(std::size_t number, std::size_t size) {
  auto saved = static_cast<std::uint64_t>(number);
  MUROSIMF_ASSERT(size > 0);
  one(saved);
  // checked before anything is allocated: the bytes may come from a damaged file
  if (loads() && saved > left_.size() / size) throw SetupError("it ends too early");
  return static_cast<std::size_t>(saved);
}

void StateArchive::check_count(std::size_t number) {
  auto saved = static_cast<std::uint64_t>(number);
  one(saved);
  // columns have a fixed size: spans of algorithms point into them
  if (saved != number) throw SetupError(fmt::format("it has {} values, not {}", saved, number));
}

void StateArchive::raw(std::span<std::byte> bytes) {
  const auto copy = [&](auto size) {
    if (!loads()) {  // most are a few bytes: insert() would take longer
      const std::size_t end = saved_->size();
      saved_->resize(end + size);
      std::memcpy(saved_->data() + end, bytes.data(), size);
      return;
    }
    if (size > left_.size()) throw SetupError("it ends too early");
    std::memcpy(bytes.data(), left_.data(), size);
    left_ = left_.subspan(size);
  };
  if (bytes.empty()) return;
  // most are one number: a copy of a size that is known here is one instruction
  if (bytes.size() == sizeof(std::uint64_t)) return copy(std::integral_constant<std::size_t, sizeof(std::uint64_t)>());
  copy(bytes.size());
}

}  // namespace murosimf
