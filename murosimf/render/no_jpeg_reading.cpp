// Replaces jpeg_reading.cpp where libjpeg is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/picture_reading.h"

namespace murosimf::render {

imaging::ColorImage picture_of_jpeg(const std::string& /*bytes*/) {
  throw SetupError("JPEG files are not read by this build: libjpeg was missing (Debian and Ubuntu: libjpeg-dev)");
}

}  // namespace murosimf::render
