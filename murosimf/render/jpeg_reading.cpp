#include <csetjmp>
#include <cstdio>

// after <cstdio>, which it needs
#include <jpeglib.h>

#include <array>
#include <cstring>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/picture_reading.h"

namespace murosimf::render {
namespace {

constexpr int most_scans = 100;  // exporters write up to 11

/// libjpeg reports errors by a jump, and damage that it can draw around by warnings, which count as errors here.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf jump;
  std::array<char, JMSG_LENGTH_MAX> message;
};

void jump_out(j_common_ptr info) {
  auto* errors = reinterpret_cast<JpegErrors*>(info->err);
  errors->manager.format_message(info, errors->message.data());
  std::longjmp(errors->jump, 1);
}

void take_message(j_common_ptr info, int level) {
  if (level < 0) jump_out(info);
}

/// Progressive pictures come in scans, each of which may go over all pixels: a small file could ask for any number.
void stop_endless(j_common_ptr info) {
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= most_scans) return;
  auto* errors = reinterpret_cast<JpegErrors*>(info->err);
  std::strcpy(errors->message.data(), "too many scans");
  std::longjmp(errors->jump, 1);
}

/// False after an error: nothing here may need to be destroyed.
bool read_header(jpeg_decompress_struct& jpeg, JpegErrors& errors, const std::string& bytes) {
  if (setjmp(errors.jump) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  (void)jpeg_read_header(&jpeg, TRUE);
  jpeg.out_color_space = JCS_RGB;
  return true;
}

bool read_rows(jpeg_decompress_struct& jpeg, JpegErrors& errors, imaging::ColorImage& image) {
  if (setjmp(errors.jump) != 0) return false;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    auto* row = reinterpret_cast<JSAMPROW>(image.row(static_cast<int>(jpeg.output_scanline)).data());
    (void)jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

/// Frees what libjpeg has allocated.
struct Decompression {
  Decompression() = default;
  ~Decompression() { jpeg_destroy_decompress(&jpeg); }
  Decompression(const Decompression&) = delete;
  Decompression& operator=(const Decompression&) = delete;
  jpeg_decompress_struct jpeg{};
};

}  // namespace

imaging::ColorImage picture_of_jpeg(const std::string& bytes) {
  static_assert(sizeof(imaging::Rgb) == 3 && BITS_IN_JSAMPLE == 8);
  JpegErrors errors{};
  jpeg_progress_mgr progress{};
  progress.progress_monitor = stop_endless;
  Decompression reading;
  reading.jpeg.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = jump_out;
  errors.manager.emit_message = take_message;
  const auto refuse = [&] { throw SetupError(fmt::format("the picture cannot be read: {}", errors.message.data())); };
  if (!read_header(reading.jpeg, errors, bytes)) refuse();
  check_picture_size(reading.jpeg.image_width, reading.jpeg.image_height);
  imaging::ColorImage image(static_cast<int>(reading.jpeg.image_width), static_cast<int>(reading.jpeg.image_height));
  MUROSIMF_ASSERT(!image.empty());
  reading.jpeg.progress = &progress;
  if (!read_rows(reading.jpeg, errors, image)) refuse();
  return image;
}

}  // namespace murosimf::render
