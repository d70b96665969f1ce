#include "murosimf/robot_formats/mesh/stl_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr std::size_t header_size = 84;    // 80 bytes of text, then the count of triangles
constexpr std::size_t triangle_size = 50;  // normal and three corners as 12 floats, two bytes more

template <class T>
T little_endian(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

void add_triangle(MeshFile& file, const std::array<Vec3d, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(file.mesh.vertices.size());
  file.mesh.vertices.insert(file.mesh.vertices.end(), corners.begin(), corners.end());
  file.mesh.triangles.push_back({first, first + 1, first + 2});
}

std::string read_head(const std::filesystem::path& path, std::size_t size) {
  std::string head(std::min(size, header_size), '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head;
}

bool is_text(std::string_view head) {
  return std::ranges::none_of(head, [](char c) { return static_cast<unsigned char>(c) < 32 && !std::isspace(c); });
}

/// "solid" is the first word of ASCII files, and of many binary ones; these have the right size or unprintable bytes.
bool is_ascii(std::string_view head, std::size_t size) {
  const std::size_t start = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  if (!head.substr(start).starts_with("solid") && !head.substr(start).starts_with("SOLID")) return false;
  if (head.size() < header_size) return true;
  MUROSIMF_ASSERT(head.size() == header_size);
  const auto count = little_endian<std::uint32_t>(head.data() + 80);
  return is_text(head) && size != header_size + triangle_size * count;
}

class Binary {
 public:
  Binary(const std::filesystem::path& path, std::string_view head, std::size_t size) : name_(path.string()) {
    if (size < header_size) fail(fmt::format("the file ends inside its header, after {} bytes; export it anew", size));
    const std::size_t count = little_endian<std::uint32_t>(head.data() + 80);
    if (count > most_triangles) fail(too_many(count));
    const std::size_t needed = header_size + triangle_size * count;
    if (size < needed) {
      fail(fmt::format("the file is cut off: {} triangles take {} bytes, it has {}; export it anew", count, needed,
                       size));
    }
    std::ifstream stream(path, std::ios::binary);
    MUROSIMF_ASSERT(count <= most_triangles && size >= header_size + triangle_size * count);
    stream.seekg(header_size);
    std::vector<char> bytes(triangle_size * count);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail("the file cannot be read");
    for (std::size_t i = 0; i < count; ++i) read_triangle(bytes.data() + triangle_size * i, i);
  }

  MeshFile result;

 private:
  void read_triangle(const char* bytes, std::size_t number) {
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const char* corner = bytes + 12 * (i + 1);  // the normal comes first
      corners[i] = {coordinate(corner, number), coordinate(corner + 4, number), coordinate(corner + 8, number)};
    }
    add_triangle(result, corners);
  }
  double coordinate(const char* bytes, std::size_t number) const {
    const double value = little_endian<float>(bytes);
    if (!std::isfinite(value))
      fail(fmt::format("triangle {} has a coordinate that is not finite ({})", number + 1, value));
    return value + 0.0;  // no -0: vertices are merged by value
  }
  [[noreturn]] void fail(std::string_view message) const {
    throw SetupError(files::one_line(fmt::format("{}: {}", name_, message)));
  }

  std::string name_;
};

/// Reader of ASCII files. Line breaks between words are only a convention, so the words are read as one sequence.
class Ascii {
 public:
  explicit Ascii(const std::filesystem::path& path) : lines_(path) {
    while (lines_.next()) {
      for (auto word = lines_.word(); !word.empty(); word = lines_.word()) take(word);
    }
    if (corners_ > 0) lines_.fail("the file ends inside a triangle; export it anew");
  }

  MeshFile result;

 private:
  void take(std::string_view word) {
    const std::string lower = files::lower_case(std::string(word));
    if (lower == "vertex") return read_vertex();
    if (lower == "endloop") return read_facet();
    if (lower == "solid" || lower == "endsolid" || lower == "facet") {
      // A name or a normal follows, neither of which is used.
      if (lower == "facet") return skip_normal();
      while (!lines_.word().empty()) {
      }
      return;
    }
    if (lower != "outer" && lower != "loop" && lower != "endfacet") {
      lines_.fail(fmt::format("unknown word {} in an STL file", files::quoted(word)));
    }
  }
  void skip_normal() {
    for (int i = 0; i < 4; ++i) lines_.word();
  }
  void read_vertex() {
    if (corners_ == 3) lines_.fail("the facet has more than three vertices; export triangles");
    MUROSIMF_ASSERT(corners_ < triangle_.size());
    Vec3d& corner = triangle_[corners_++];
    corner.x = lines_.number("vertex");
    corner.y = lines_.number("vertex");
    corner.z = lines_.number("vertex");
  }
  void read_facet() {
    if (corners_ != 3) lines_.fail(fmt::format("the facet has {} vertices instead of three; export it anew", corners_));
    corners_ = 0;
    if (result.mesh.triangles.size() == most_triangles) lines_.fail(too_many());
    add_triangle(result, triangle_);
  }

  files::TextLines lines_;
  std::array<Vec3d, 3> triangle_;
  std::size_t corners_ = 0;
};

}  // namespace

MeshFile read_stl(const std::filesystem::path& path, std::size_t size) {
  const std::string head = read_head(path, size);
  return is_ascii(head, size) ? Ascii(path).result : Binary(path, head, size).result;
}

}  // namespace murosimf::robot_formats::mesh
