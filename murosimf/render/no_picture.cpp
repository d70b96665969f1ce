// Replaces everything that draws where cairo is missing.
#include "murosimf/model/error.h"
#include "murosimf/render/field_picture.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/picture_reading.h"
#include "murosimf/render/png_bytes.h"
#include "murosimf/render/seen_drawing.h"

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

double width_of_words(const std::string& /*words*/, double /*height*/) { refuse(); }

void draw_over(imaging::ColorImage& /*picture*/, const std::vector<SeenShape>& /*shapes*/) { refuse(); }

std::string image_png(const imaging::ColorImage& /*image*/, const std::string& /*title*/) { refuse(); }

std::string png_bytes(const imaging::ColorImage& /*image*/) { refuse(); }
std::string png_bytes(const imaging::GrayImage& /*image*/) { refuse(); }
std::string png_bytes(const imaging::NumberImage& /*image*/) { refuse(); }

imaging::ColorImage picture_of_png(const std::string& /*bytes*/) { refuse(); }

}  // namespace murosimf::render
