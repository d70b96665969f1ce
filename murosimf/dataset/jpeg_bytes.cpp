#include "murosimf/dataset/jpeg_bytes.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

// after <cstdio>, which it needs
#include <jpeglib.h>

#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

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

void check_jpeg_bytes() {}

}  // namespace murosimf::dataset
