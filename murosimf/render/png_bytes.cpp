#include "murosimf/render/png_bytes.h"

#include <csetjmp>

#include <png.h>

#include "murosimf/math/assert.h"
#include "murosimf/render/png.h"

namespace murosimf::render {
namespace {

constexpr int compression = 4;

void add_bytes(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

/// Without it libpng takes its own, which is of a file.
void flush_nothing(png_structp /*png*/) {}

/// False if libpng fails, which it reports by a jump: nothing here may need to be destroyed.
bool write_png(png_structp png, png_infop info, const PngRows& picture, png_bytepp rows, std::string* into) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, into, add_bytes, flush_nothing);
  png_set_compression_level(png, compression);
  png_set_filter(png, 0, PNG_FILTER_NONE);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.rows.size()),
               picture.bits, picture.colors ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (picture.bits == 16) png_set_swap(png);  // PNG has the higher byte first (its specification, 7.2)
  if (picture.of_cairo) {                     // blue, green, red, nothing
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    png_set_bgr(png);
  }
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

template <class Pixel>
std::string bytes_of(const imaging::Image<Pixel>& image, int bits, bool colors) {
  PngRows picture{.width = image.width(), .bits = bits, .colors = colors};
  for (int v = 0; v < image.height(); ++v) {
    picture.rows.push_back(reinterpret_cast<const unsigned char*>(image.row(v).data()));
  }
  return encoded(picture);
}

}  // namespace

std::string encoded(const PngRows& picture) {
  MUROSIMF_ASSERT(!(picture.of_cairo && !picture.colors));
  std::vector<png_bytep> rows;
  for (const unsigned char* row : picture.rows) rows.push_back(const_cast<png_bytep>(row));  // libpng reads them only
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written = info && write_png(png, info, picture, rows.data(), &bytes);
  png_destroy_write_struct(&png, &info);
  if (!written) refuse_picture("libpng gave up");
  return bytes;
}

std::string png_bytes(const imaging::ColorImage& image) { return bytes_of(image, 8, true); }
std::string png_bytes(const imaging::GrayImage& image) { return bytes_of(image, 8, false); }
std::string png_bytes(const imaging::NumberImage& image) { return bytes_of(image, 16, false); }

}  // namespace murosimf::render
