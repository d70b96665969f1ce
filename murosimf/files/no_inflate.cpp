// Replaces inflate.cpp where zlib is missing.
#include "murosimf/files/gray_png.h"
#include "murosimf/model/error.h"

namespace murosimf::files {

std::optional<std::string> inflated(std::string_view, std::size_t) {
  throw SetupError(
      "PNG files of heights cannot be read: this program was built without zlib (Debian and Ubuntu: zlib1g-dev); save "
      "them as .npy or .csv");
}

}  // namespace murosimf::files
