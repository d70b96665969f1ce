/// random.h - counter-based random numbers: the n-th number of a stream is a pure function of (seed, stream, n).
///
/// Streams are addressed, not advanced, so adding a robot or a sensor never changes the numbers of another.
/// Generator: Philox 4x32 with 10 rounds. Source: Salmon, Moraes, Dror, Shaw, "Parallel Random Numbers: As Easy as
/// 1, 2, 3", SC 2011.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace murosimf {

/// The bare generator: 128 random bits for a 128-bit counter and a 64-bit key.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) noexcept;

class RandomStream {
 public:
  /// `name` distinguishes streams of one seed, for example "blue1/start".
  RandomStream(std::uint64_t seed, std::string_view name) noexcept;

  /// From now on the stream of this name that `seed` has.
  void reseed(std::uint64_t seed) noexcept { seed_ = seed; }

  /// The n-th number, uniform in [0, 1).
  [[nodiscard]] double uniform(std::uint64_t n) const noexcept;
  /// The n-th number, uniform in [low, high).
  [[nodiscard]] double uniform(std::uint64_t n, double low, double high) const noexcept;
  /// The n-th two independent numbers of the standard normal distribution (mean 0, standard deviation 1).
  /// Source: Box, Muller, "A note on the generation of random normal deviates", Ann. Math. Statist. 29 (1958).
  [[nodiscard]] std::array<double, 2> normals(std::uint64_t n) const noexcept;
  /// The first of them.
  [[nodiscard]] double normal(std::uint64_t n) const noexcept { return normals(n)[0]; }

 private:
  /// Two independent numbers, uniform in [0, 1).
  [[nodiscard]] std::array<double, 2> pair(std::uint64_t n) const noexcept;

  std::uint64_t seed_, stream_;
};

}  // namespace murosimf
