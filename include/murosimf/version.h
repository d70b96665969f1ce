/// version.h - which version of MuRoSimF this is, and what every header of the public interface has in common.
///
/// The headers of this folder are all that a program sees of the library: values, and handles to objects that stay in the library. Their
/// names stand in an inline namespace (`v0`), so that programs write `murosimf::Scene`, and a program that was built against another
/// interface does not link, instead of going wrong. Lengths are in meters, angles in radians, times in simulated seconds, forces in
/// newtons; frames are right-handed, x forward, y left, z up.
#pragma once

#define MUROSIMF_VERSION_MAJOR 0
#define MUROSIMF_VERSION_MINOR 1
#define MUROSIMF_VERSION_PATCH 0

/// What the shared library exports; all else is hidden in it.
#define MUROSIMF_API __attribute__((visibility("default")))

namespace murosimf {
inline namespace v0 {

/// Of the library that the program runs with: "0.1.0".
[[nodiscard]] MUROSIMF_API const char* version() noexcept;

}  // namespace v0
}  // namespace murosimf
