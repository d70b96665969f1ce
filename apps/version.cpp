// What `murosimf --version` says.
#include "apps/version.h"

#include <fmt/format.h>

namespace murosimf::app {

std::string version_number() { return MUROSIMF_VERSION; }

std::string version_text() {
  return fmt::format("murosimf {} (commit {})\nbuild: {}, {}\nfeatures: {}", version_number(), version_commit(),
                     MUROSIMF_BUILD, MUROSIMF_COMPILER, MUROSIMF_FEATURES);
}

}  // namespace murosimf::app
