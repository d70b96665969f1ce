/// image_noise.h - the noise of an image sensor: of counted photons, and of reading them out.
///
/// Light L from 0 (black) to 1 (white) is read with the standard deviation
///
///     sqrt(shot^2 L + read^2)
///
/// shot^2 is 1 / (electrons that a white pixel counts). Source: EMVA standard 1288, release 3.1, section 2.2.
#pragma once

#include <array>
#include <cstdint>

#include "murosimf/imaging/image.h"
#include "murosimf/math/random.h"

namespace murosimf::imaging {

struct ImageNoiseSpec {
  double shot = 0;  ///< standard deviation of white that is counted photons' [1]
  double read = 0;  ///< standard deviation of black [1]
};

/// Noise of every color of every pixel is independent, and a pure function of the stream, the number of the picture and
/// the pixel. Values are normal to 3.7 standard deviations, and rounded; light below 0 is black.
class ImageNoise {
 public:
  /// `stream` distinguishes cameras. Throws SetupError if a number is not 0 to 1.
  ImageNoise(const ImageNoiseSpec& spec, const RandomStream& stream);

  /// Makes the tables that all cameras share, unless they are there: before the first picture, so that no step does.
  static void make_tables();

  /// Noise of another seed.
  void reseed(std::uint64_t seed) noexcept { stream_.reseed(seed); }
  void apply(ColorImage& picture, std::uint64_t number) const noexcept;

 private:
  std::array<float, 256> deviation_{};  ///< of each value's light, of full_light (imaging/srgb.h)
  RandomStream stream_;
};

}  // namespace murosimf::imaging
