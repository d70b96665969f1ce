/// told.h - conversion of the library's exceptions and values to those of its public interface.
#pragma once

#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/error.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/values.h"

namespace murosimf::api {

/// Calls `f`; converts exceptions of the library to those of error.h.
template <class F>
decltype(auto) told(const F& f) {
  try {
    return f();
  } catch (const SetupError& error) {
    throw InputError(error.what());
  } catch (const control_software::SoftwareCrash& error) {
    throw SimulationError(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(error.what());
  }
}

[[nodiscard]] inline Vec3d vec(const Vector3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vector3 vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Rotation rotation_of(const Mat3d& m) {
  const Quaterniond q = from_matrix(m);
  return {q.w, q.x, q.y, q.z};
}

[[nodiscard]] inline bool is_finite(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
/// Throws InputError: "velocity of 'ball' is not finite".
void check_finite(const Vector3& v, std::string_view what);
/// Throws InputError for another number of values, and for values that are not finite.
void check_row(std::span<const double> row, std::size_t size, std::string_view what);

[[noreturn]] void throw_unknown(std::string_view kind, std::string_view name,
                                const std::vector<std::string_view>& candidates);

}  // namespace murosimf::api
