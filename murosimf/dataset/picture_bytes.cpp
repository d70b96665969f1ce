#include "murosimf/dataset/picture_bytes.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <vector>

// after <cstdio>, which it needs
#include <jpeglib.h>
#include <png.h>

#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

// Half the time of the usual level, for files that are a fifth larger.
constexpr int compression = 3;

struct Format {
  int bits = 8, type = PNG_COLOR_TYPE_RGB;
};

void add_bytes(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

/// Without it libpng takes its own, which is of a file.
void flush_nothing(png_structp /*png*/) {}

/// False if libpng fails, which it reports by a jump: nothing here may need to be destroyed.
bool write_png(png_structp png, png_infop info, png_uint_32 width, png_uint_32 height, const Format& format,
               png_bytepp rows, std::string* into) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, into, add_bytes, flush_nothing);
  png_set_compression_level(png, compression);
  png_set_filter(png, 0, format.type == PNG_COLOR_TYPE_RGB ? PNG_FILTER_SUB : PNG_FILTER_NONE);
  png_set_IHDR(png, info, width, height, format.bits, format.type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (format.bits == 16) png_set_swap(png);  // PNG has the higher byte first
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

template <class Pixel>
std::string png_of(const imaging::Image<Pixel>& image, const Format& format) {
  std::vector<png_bytep> rows;
  for (int v = 0; v < image.height(); ++v) {
    // libpng reads rows only
    rows.push_back(const_cast<png_bytep>(reinterpret_cast<png_const_bytep>(image.row(v).data())));
  }
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written = info && write_png(png, info, static_cast<png_uint_32>(image.width()),
                                         static_cast<png_uint_32>(image.height()), format, rows.data(), &bytes);
  png_destroy_write_struct(&png, &info);
  if (!written) throw SetupError("cannot write a picture: libpng gave up");
  return bytes;
}

struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf jump;
};

void jump_out(j_common_ptr info) { std::longjmp(reinterpret_cast<JpegErrors*>(info->err)->jump, 1); }
void say_nothing(j_common_ptr /*info*/) {}

/// False if libjpeg fails, which it reports by a jump.
bool write_jpeg(jpeg_compress_struct& jpeg, JpegErrors& errors, const imaging::ColorImage& image, int quality,
                unsigned char** bytes, unsigned long* size) {
  if (setjmp(errors.jump) != 0) return false;
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, bytes, size);
  jpeg.image_width = static_cast<JDIMENSION>(image.width());
  jpeg.image_height = static_cast<JDIMENSION>(image.height());
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    const auto row = image.row(static_cast<int>(jpeg.next_scanline));
    JSAMPROW line = const_cast<JSAMPROW>(reinterpret_cast<const JSAMPLE*>(row.data()));
    (void)jpeg_write_scanlines(&jpeg, &line, 1);
  }
  jpeg_finish_compress(&jpeg);
  return true;
}

}  // namespace

std::string png_bytes(const imaging::ColorImage& image) { return png_of(image, {8, PNG_COLOR_TYPE_RGB}); }
std::string png_bytes(const imaging::GrayImage& image) { return png_of(image, {8, PNG_COLOR_TYPE_GRAY}); }
std::string png_bytes(const imaging::NumberImage& image) { return png_of(image, {16, PNG_COLOR_TYPE_GRAY}); }

std::string jpeg_bytes(const imaging::ColorImage& image, int quality) {
  jpeg_compress_struct jpeg{};
  JpegErrors errors{};
  jpeg.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = jump_out;
  errors.manager.output_message = say_nothing;
  unsigned char* data = nullptr;
  unsigned long size = 0;
  const bool written = write_jpeg(jpeg, errors, image, quality, &data, &size);
  std::string bytes;
  if (written) bytes.assign(reinterpret_cast<const char*>(data), size);
  jpeg_destroy_compress(&jpeg);
  // libjpeg has allocated it so; it updates the pointer at the end only, so after a failure it may be of memory that is freed
  if (written) std::free(data);
  if (!written) throw SetupError("cannot write a picture: libjpeg gave up");
  return bytes;
}

void check_picture_bytes() {}

}  // namespace murosimf::dataset
