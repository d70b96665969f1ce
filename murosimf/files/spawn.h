/// spawn.h - starts another program without a shell, in a process group of its own.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <sys/types.h>

namespace murosimf::files {

/// Starts `arguments[0]`, looked up in PATH; `streams` become its standard input, output and errors. A signal that a
/// terminal sends to this program's group does not reach it: who started it decides about its end. 0, or errno of what
/// failed.
[[nodiscard]] int spawn(const std::vector<std::string>& arguments, const std::array<int, 3>& streams, pid_t& child);

}  // namespace murosimf::files
