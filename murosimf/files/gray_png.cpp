#include "murosimf/files/gray_png.h"

#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

using namespace std::string_view_literals;

[[noreturn]] void refuse_picture(const std::string& name, const std::string& message) {
  throw SetupError(fmt::format("{}: {}", name, message));
}

unsigned byte_at(std::string_view bytes, std::size_t i) {
  MUROSIMF_ASSERT(i < bytes.size());
  return static_cast<unsigned char>(bytes[i]);
}

std::size_t big_number(std::string_view bytes, std::size_t place) {
  MUROSIMF_ASSERT(place + 4 <= bytes.size());
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = 256 * value + byte_at(bytes, place + i);
  return value;
}

struct Picture {
  std::size_t columns = 0, rows = 0, sample = 0;  // [byte] of a sample
  std::string packed;
};

void read_header(const std::string& name, std::string_view data, Picture& picture) {
  if (data.size() != 13) refuse_picture(name, "has a broken header");
  picture.columns = big_number(data, 0);
  picture.rows = big_number(data, 4);
  const unsigned bits = byte_at(data, 8), color = byte_at(data, 9), interlace = byte_at(data, 12);
  if (color != 0) refuse_picture(name, "is no gray picture; save it in gray, without colors and transparency");
  if (bits != 8 && bits != 16) refuse_picture(name, fmt::format("has {} bits to a pixel; save it with 8 or 16", bits));
  if (interlace != 0) refuse_picture(name, "is interlaced; save it without");
  // Each number alone first: their product must not overflow.
  if (picture.columns > most_heights || picture.rows > most_heights || picture.columns * picture.rows > most_heights) {
    refuse_picture(name, fmt::format("more than {} heights; make the grid coarser", most_heights));
  }
  if (picture.columns == 0 || picture.rows == 0) refuse_picture(name, "has no pixels");
  picture.sample = bits / 8;
}

Picture read_chunks(const std::string& name, std::string_view bytes) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) refuse_picture(name, "is no PNG file");
  Picture picture;
  std::size_t place = 8;
  MUROSIMF_ASSERT(place <= bytes.size());
  while (bytes.size() - place >= 12) {
    const std::size_t size = big_number(bytes, place);
    const std::string_view kind = bytes.substr(place + 4, 4);
    // A size beyond the end of the file: the subtraction cannot wrap, since 12 bytes remain.
    if (size > bytes.size() - place - 12) break;
    const std::string_view data = bytes.substr(place + 8, size);
    if (kind == "IHDR") read_header(name, data, picture);
    if (kind == "IDAT") picture.packed += data;
    if (kind == "IEND") {
      if (picture.sample == 0) refuse_picture(name, "has no header");
      return picture;
    }
    place += size + 12;
  }
  refuse_picture(name, "ends too early");
}

/// The one of left, above and above left that is nearest to left + above - above left (the Paeth predictor).
unsigned nearest_of(int left, int above, int corner) {
  const int guess = left + above - corner;
  const int to_left = std::abs(guess - left), to_above = std::abs(guess - above), to_corner = std::abs(guess - corner);
  if (to_left <= to_above && to_left <= to_corner) return static_cast<unsigned>(left);
  return static_cast<unsigned>(to_above <= to_corner ? above : corner);
}

/// Reverses the filter of a line; false if there is no such filter.
bool unfilter(unsigned filter, std::string& line, const std::string& before, std::size_t sample) {
  MUROSIMF_ASSERT(sample == 1 || sample == 2);
  MUROSIMF_ASSERT(line.size() == before.size());
  if (filter > 4) return false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const unsigned left = i < sample ? 0 : byte_at(line, i - sample), above = byte_at(before, i);
    const unsigned corner = i < sample ? 0 : byte_at(before, i - sample);
    const unsigned guesses[]{0, left, above, (left + above) / 2,
                             nearest_of(static_cast<int>(left), static_cast<int>(above), static_cast<int>(corner))};
    line[i] = static_cast<char>(static_cast<unsigned char>(byte_at(line, i) + guesses[filter]));
  }
  return true;
}

}  // namespace

HeightTable png_heights(const std::string& name, const std::string& bytes) {
  const Picture picture = read_chunks(name, bytes);
  const std::size_t width = picture.columns * picture.sample;
  const auto pixels = inflated(picture.packed, picture.rows * (width + 1));
  if (!pixels) refuse_picture(name, "its pixels are broken");
  MUROSIMF_ASSERT(pixels->size() == picture.rows * (width + 1));
  HeightTable table{.rows = picture.rows, .columns = picture.columns, .heights = {}, .is_picture = true};
  std::string line, before(width, '\0');
  for (std::size_t i = 0; i < picture.rows; ++i) {
    const std::size_t begin = i * (width + 1);
    line = pixels->substr(begin + 1, width);
    if (!unfilter(byte_at(*pixels, begin), line, before, picture.sample)) refuse_picture(name, "its pixels are broken");
    for (std::size_t j = 0; j < picture.columns; ++j) {
      const bool is_short = picture.sample == 1;
      const unsigned gray = is_short ? byte_at(line, j) : 256 * byte_at(line, 2 * j) + byte_at(line, 2 * j + 1);
      table.heights.push_back(gray / (is_short ? 255.0 : 65535.0));
    }
    before = line;
  }
  MUROSIMF_ASSERT(table.heights.size() == table.rows * table.columns);
  return table;
}

}  // namespace murosimf::files
