/// bytes_hash.h - a checksum of a state's bytes: another one if any bit of them is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "murosimf/math/hash.h"

namespace murosimf {

/// Eight bytes at a time; not for security.
[[nodiscard]] inline std::uint64_t hash_of(std::span<const std::byte> bytes) noexcept {
  Hasher hasher;
  for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof(word));
    hasher.add(word);
  }
  for (const std::byte byte : bytes) hasher.add(static_cast<std::uint64_t>(byte));
  return hasher.value();
}

}  // namespace murosimf
