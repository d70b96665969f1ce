#include "murosimf/robot_formats/mesh/msh_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr std::size_t word = 4;  // [byte] of every number

class Msh {
 public:
  Msh(const std::filesystem::path& path, std::size_t size) : name_(path.string()), bytes_(size) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream.read(bytes_.data(), static_cast<std::streamsize>(size))) fail("the file cannot be read");
    if (size < counts_.size() * word) fail(fmt::format("the file ends inside its header, after {} bytes", size));
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const auto count = at<std::int32_t>(i);
      if (count < 0) fail(fmt::format("count {} of its header is {}", i + 1, count));
      counts_[i] = static_cast<std::size_t>(count);
    }
    check_size();
    read_vertices();
    read_faces();
  }

  MeshFile result;

 private:
  void check_size() const {
    const auto [vertices, normals, texture, faces] = counts_;
    if (faces > most_triangles) fail(too_many(faces));  // before memory for them is needed
    MUROSIMF_ASSERT(bytes_.size() >= word * counts_.size());
    const std::size_t needed = word * (counts_.size() + 3 * vertices + 3 * normals + 2 * texture + 3 * faces);
    if (bytes_.size() != needed) {
      fail(fmt::format("its header asks for {} bytes, it has {}; export it anew", needed, bytes_.size()));
    }
  }

  void read_vertices() {
    for (std::size_t i = 0; i < counts_[0]; ++i) {
      const std::size_t first = counts_.size() + 3 * i;
      const Vec3d vertex{at<float>(first), at<float>(first + 1), at<float>(first + 2)};
      if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z)) {
        fail(fmt::format("vertex {} is not finite", i + 1));
      }
      result.mesh.vertices.push_back(
          {vertex.x + 0.0, vertex.y + 0.0, vertex.z + 0.0});  // no -0: vertices are merged by value
    }
  }

  void read_faces() {
    const std::size_t begin = counts_.size() + 3 * counts_[0] + 3 * counts_[1] + 2 * counts_[2];
    for (std::size_t i = 0; i < counts_[3]; ++i) {
      result.mesh.triangles.push_back({corner(begin + 3 * i), corner(begin + 3 * i + 1), corner(begin + 3 * i + 2)});
    }
  }

  [[nodiscard]] std::uint32_t corner(std::size_t index) const {
    const auto vertex = at<std::uint32_t>(index);
    if (vertex >= counts_[0])
      fail(fmt::format("a face names vertex {}; there are {}, counted from 0", vertex, counts_[0]));
    return vertex;
  }

  template <class T>
  [[nodiscard]] T at(std::size_t index) const {
    MUROSIMF_ASSERT(word * index + sizeof(T) <= bytes_.size());
    T value;
    // Copied: the bytes need not be aligned.
    std::memcpy(&value, bytes_.data() + word * index, sizeof value);
    return value;
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw SetupError(files::one_line(fmt::format("{}: {}", name_, message)));
  }

  std::string name_;
  std::vector<char> bytes_;
  std::array<std::size_t, 4> counts_{};  // vertices, normals, texture coordinates, faces
};

}  // namespace

MeshFile read_msh(const std::filesystem::path& path, std::size_t size) { return Msh(path, size).result; }

}  // namespace murosimf::robot_formats::mesh
