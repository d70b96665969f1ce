// Writes numbers of 16 bits as a PNG file: cairo has no format for them.
#include <csetjmp>
#include <vector>

#include <png.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/image_png.h"

namespace murosimf::render {
namespace {

constexpr int bits = 16;

void add_bytes(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

/// False if libpng fails, which it reports by a jump: nothing here may need to be destroyed.
bool write(png_structp png, png_infop info, png_uint_32 width, png_uint_32 height, png_bytepp rows, std::string* into) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, into, add_bytes, nullptr);
  png_set_IHDR(png, info, width, height, bits, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

/// Rows one behind the other, the higher byte of each number first (PNG specification, 7.2).
std::vector<png_byte> big_endian(const imaging::NumberImage& image) {
  std::vector<png_byte> bytes;
  bytes.reserve(2 * image.pixels().size());
  for (const std::uint16_t number : image.pixels()) {
    bytes.push_back(static_cast<png_byte>(number >> 8));
    bytes.push_back(static_cast<png_byte>(number & 255));
  }
  return bytes;
}

}  // namespace

std::string number_png(const imaging::NumberImage& image) {
  std::vector<png_byte> bytes = big_endian(image);
  std::vector<png_bytep> rows;
  // The rows point into `bytes`, which must not change from here on.
  for (int v = 0; v < image.height(); ++v) rows.push_back(bytes.data() + std::ptrdiff_t{2} * v * image.width());
  MUROSIMF_ASSERT(bytes.size() == 2 * image.pixels().size());
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written = info && write(png, info, static_cast<png_uint_32>(image.width()),
                                     static_cast<png_uint_32>(image.height()), rows.data(), &file);
  png_destroy_write_struct(&png, &info);
  if (!written) throw SetupError("cannot draw the picture: libpng gave up");
  return file;
}

}  // namespace murosimf::render
