#include "murosimf/math/random.h"

#include <cmath>

#include "murosimf/math/hash.h"
#include "murosimf/math/scalar.h"

namespace murosimf {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> key) noexcept {
  // ten rounds, as recommended by the authors for Philox4x32
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
    c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return c;
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) noexcept : seed_(seed) {
  Hasher hasher;
  hasher.add(name);
  stream_ = hasher.value();
}

std::array<double, 2> RandomStream::pair(std::uint64_t n) const noexcept {
  const auto lo = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
  const auto hi = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); };
  const auto bits = philox({lo(n), hi(n), lo(stream_), hi(stream_)}, {lo(seed_), hi(seed_)});
  const auto number = [&](std::size_t i) {
    const std::uint64_t wide = (std::uint64_t{bits[i]} << 32) | bits[i + 1];
    // 53 bits: every multiple of 2^-53 in [0, 1) is equally likely
    return static_cast<double>(wide >> 11) * 0x1.0p-53;
  };
  return {number(0), number(2)};
}

double RandomStream::uniform(std::uint64_t n) const noexcept { return pair(n)[0]; }

double RandomStream::uniform(std::uint64_t n, double low, double high) const noexcept {
  return low + (high - low) * uniform(n);
}

std::array<double, 2> RandomStream::normals(std::uint64_t n) const noexcept {
  const auto [a, b] = pair(n);
  // Box and Muller; 1 - a is never 0
  const double radius = std::sqrt(-2 * std::log(1 - a)), angle = 2 * pi * b;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace murosimf
