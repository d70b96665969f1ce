#include "apps/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::app {

void write_standard_output(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw SetupError(fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
  }
}

}  // namespace murosimf::app
