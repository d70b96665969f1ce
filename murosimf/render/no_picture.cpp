// Stands in for everything that draws where cairo is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/field_picture.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/scene_view.h"

namespace murosimf::render {
namespace {

[[noreturn]] void refuse() {
  throw SetupError("pictures are off in this build: cairo was missing (Debian and Ubuntu: libcairo2-dev)");
}

}  // namespace

std::string field_picture_png(const Markings& /*markings*/, const std::vector<Path>& /*paths*/,
                              const FieldPictureOptions& /*options*/) {
  refuse();
}

std::string image_png(const imaging::ColorImage& /*image*/) { refuse(); }

View view_of(const View& /*axes*/, const std::vector<ViewedShape>& /*shapes*/, int /*columns*/, int /*rows*/) {
  refuse();
}

View view_of(const View& /*axes*/, const Markings& /*markings*/, int /*columns*/, int /*rows*/) { refuse(); }

std::string scene_view_png(const Markings& /*markings*/, const std::vector<ViewedShape>& /*shapes*/,
                           const View& /*view*/, const std::string& /*title*/) {
  refuse();
}

}  // namespace murosimf::render
