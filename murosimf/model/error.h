/// error.h - the one exception that users' errors throw, while a simulation is being set up.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

/// An error in a file, a name or a set-up. `what()` is one line: where, what, and what to do.
class SetupError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `f`; a SetupError that it throws gets `where` in front: "scenes/a.toml:3:7: ...".
template <class F>
decltype(auto) with_context(std::string_view where, const F& f) {
  try {
    return f();
  } catch (const SetupError& error) {
    throw SetupError(std::string(where) + ": " + error.what());
  }
}

/// The candidate nearest to `name` (edit distance), empty if none is near.
[[nodiscard]] std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// "unknown level 'full'; did you mean 'full_dynamics'?" or, if nothing is near, "...; known: a, b, c".
[[nodiscard]] std::string unknown_name(std::string_view kind, std::string_view name,
                                       const std::vector<std::string_view>& candidates);

}  // namespace murosimf
