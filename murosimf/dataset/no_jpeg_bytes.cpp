#include "murosimf/dataset/jpeg_bytes.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {

void check_jpeg_bytes() {
  throw SetupError(
      "this build writes no data sets: build it with libpng and libjpeg (Debian and Ubuntu: libcairo2-dev, "
      "libjpeg-dev)");
}

std::string jpeg_bytes(const imaging::ColorImage& /*image*/, int /*quality*/) {
  check_jpeg_bytes();
  return {};
}

}  // namespace murosimf::dataset
