// Stands in for field_picture.cpp where cairo is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/field_picture.h"

namespace murosimf::render {

std::string field_picture_png(const Markings& /*markings*/, const std::vector<Path>& /*paths*/,
                              const FieldPictureOptions& /*options*/) {
  throw SetupError("pictures are off in this build: cairo was missing (Debian and Ubuntu: libcairo2-dev)");
}

}  // namespace murosimf::render
