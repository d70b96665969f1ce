#include "murosimf/files/npy_array.h"

#include <cstdint>
#include <cstring>
#include <regex>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

struct ArrayParts {
  std::string header;
  std::size_t data = 0;  // where the numbers begin
};

[[noreturn]] void refuse_array(const std::string& name, const std::string& message) {
  throw SetupError(fmt::format("{}: {}", name, message));
}

std::size_t little_number(const std::string& bytes, std::size_t place, std::size_t size) {
  MUROSIMF_ASSERT(place + size <= bytes.size());
  std::size_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = 256 * value + static_cast<unsigned char>(bytes[place + i]);
  return value;
}

ArrayParts split_array(const std::string& name, const std::string& bytes) {
  using namespace std::string_view_literals;
  if (bytes.size() < 12 || !bytes.starts_with("\x93NUMPY"sv)) refuse_array(name, "is no file of numpy.save");
  const std::size_t size = bytes[6] == 1 ? 2 : 4, length = little_number(bytes, 8, size), data = 8 + size + length;
  if (length > 10'000 || data > bytes.size()) refuse_array(name, "ends within its header");
  MUROSIMF_ASSERT(data <= bytes.size());
  return {bytes.substr(8 + size, length), data};
}

/// The text of the first group of the pattern in the header.
std::string find_in_header(const std::string& name, const std::string& header, const char* pattern, const char* what) {
  std::smatch match;
  if (!std::regex_search(header, match, std::regex(pattern)))
    refuse_array(name, fmt::format("its header has no {}", what));
  return match[1];
}

template <class Number>
HeightTable numbers(const std::string& name, const std::string& bytes, std::size_t data, HeightTable table) {
  MUROSIMF_ASSERT(data <= bytes.size());
  const std::size_t count = table.rows * table.columns;
  if (bytes.size() - data != count * sizeof(Number)) {
    refuse_array(name, fmt::format("has {} bytes of numbers, where {} x {} take {}", bytes.size() - data, table.rows,
                                   table.columns, count * sizeof(Number)));
  }
  table.heights.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Copied: the numbers of a file need not be aligned. Both are little-endian here.
    Number number;
    std::memcpy(&number, bytes.data() + data + i * sizeof(Number), sizeof(Number));
    table.heights.push_back(static_cast<double>(number));
  }
  MUROSIMF_ASSERT(table.heights.size() == count);
  return table;
}

}  // namespace

HeightTable npy_heights(const std::string& name, const std::string& bytes) {
  const ArrayParts parts = split_array(name, bytes);
  const std::string type = find_in_header(name, parts.header, "'descr': *'([^']*)'", "type of numbers");
  if (find_in_header(name, parts.header, "'fortran_order': *(True|False)", "order") == "True") {
    refuse_array(name, "stands column by column; save numpy.ascontiguousarray of it");
  }
  const std::string shape = find_in_header(name, parts.header, "'shape': *\\(([^)]*)\\)", "shape");
  std::smatch sizes;
  if (!std::regex_match(shape, sizes, std::regex(" *([0-9]{1,7}) *, *([0-9]{1,7}) *,? *"))) {
    refuse_array(name, fmt::format("its shape is ({}); heights have two dimensions", shape));
  }
  HeightTable table;
  table.rows = std::stoul(sizes[1]);
  table.columns = std::stoul(sizes[2]);
  if (table.rows * table.columns > most_heights) {
    refuse_array(name, fmt::format("more than {} heights; make the grid coarser", most_heights));
  }
  if (type == "<f8") return numbers<double>(name, bytes, parts.data, table);
  if (type == "<f4") return numbers<float>(name, bytes, parts.data, table);
  if (type == "<u2") return numbers<std::uint16_t>(name, bytes, parts.data, table);
  if (type == "<i2") return numbers<std::int16_t>(name, bytes, parts.data, table);
  if (type == "|u1") return numbers<std::uint8_t>(name, bytes, parts.data, table);
  refuse_array(name, fmt::format("its numbers are '{}'; save it as float32 or float64", type));
}

}  // namespace murosimf::files
