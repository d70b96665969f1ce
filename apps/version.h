/// version.h - version of the program: number, commit, built-in features.
#pragma once

#include <string>

namespace murosimf::app {

/// "0.1.0"
[[nodiscard]] std::string version_number();

/// The commit that was built, "136ba27"; with a plus if files were changed; "unknown" outside a repository. Compiled anew for
/// every commit: nothing else stands in its source.
[[nodiscard]] const char* version_commit();

/// Several lines: version and commit, build and compiler, features with on or off.
[[nodiscard]] std::string version_text();

}  // namespace murosimf::app
