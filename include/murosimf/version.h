/// version.h - which version of MuRoSimF this is, and the common part of all public headers.
///
/// The headers of this folder are the whole interface of the library for programs: values, and handles to objects that stay in the library. Their
/// names stand in an inline namespace (`v0`), so that programs write `murosimf::Scene`, and a program that was built against another
/// interface does not link, instead of going wrong. Lengths are in meters, angles in radians, times in simulated seconds, forces in
/// newtons; frames are right-handed, x forward, y left, z up.
#pragma once

#define MUROSIMF_VERSION_MAJOR 0
#define MUROSIMF_VERSION_MINOR 1
#define MUROSIMF_VERSION_PATCH 0

/// Exported by the shared library, which hides everything else.
#define MUROSIMF_API __attribute__((visibility("default")))

namespace murosimf {
inline namespace v0 {

/// Version of the library that the program runs with: "0.1.0".
[[nodiscard]] MUROSIMF_API const char* version() noexcept;

}  // namespace v0
}  // namespace murosimf
