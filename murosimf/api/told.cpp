#include "murosimf/api/told.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/version.h"

#define MUROSIMF_TEXT_OF(x) #x
#define MUROSIMF_TEXT(x) MUROSIMF_TEXT_OF(x)
static_assert(std::string_view(MUROSIMF_VERSION) ==
                  MUROSIMF_TEXT(MUROSIMF_VERSION_MAJOR) "." MUROSIMF_TEXT(MUROSIMF_VERSION_MINOR) "." MUROSIMF_TEXT(
                      MUROSIMF_VERSION_PATCH),
              "include/murosimf/version.h names another version than CMakeLists.txt");

namespace murosimf {
inline namespace v0 {

Error::~Error() = default;
InputError::~InputError() = default;
UnknownName::~UnknownName() = default;
SimulationError::~SimulationError() = default;

const char* version() noexcept { return MUROSIMF_VERSION; }

}  // namespace v0

namespace api {

void check_finite(const Vector3& v, std::string_view what) {
  if (!is_finite(v)) throw InputError(fmt::format("{} is not finite", what));
}

void check_row(std::span<const double> row, std::size_t size, std::string_view what) {
  if (row.size() != size) throw InputError(fmt::format("{} takes {} numbers, not {}", what, size, row.size()));
  const auto bad = std::ranges::find_if(row, [](double x) { return !std::isfinite(x); });
  if (bad != row.end()) throw InputError(fmt::format("{}: number {} is not finite", what, bad - row.begin()));
}

void throw_unknown(std::string_view kind, std::string_view name, const std::vector<std::string_view>& candidates) {
  throw UnknownName(unknown_name(kind, name, candidates));
}

}  // namespace api
}  // namespace murosimf
