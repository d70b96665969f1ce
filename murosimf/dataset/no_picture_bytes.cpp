#include "murosimf/dataset/picture_bytes.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {

void check_picture_bytes() {
  throw SetupError(
      "this build writes no data sets: build it with libpng and libjpeg (Debian and Ubuntu: libcairo2-dev, "
      "libjpeg-dev)");
}

std::string png_bytes(const imaging::ColorImage& /*image*/) {
  check_picture_bytes();
  return {};
}
std::string png_bytes(const imaging::GrayImage& /*image*/) {
  check_picture_bytes();
  return {};
}
std::string png_bytes(const imaging::NumberImage& /*image*/) {
  check_picture_bytes();
  return {};
}
std::string jpeg_bytes(const imaging::ColorImage& /*image*/, int /*quality*/) {
  check_picture_bytes();
  return {};
}

}  // namespace murosimf::dataset
