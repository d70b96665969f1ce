/// mesh_limits.h - words that the readers of mesh files share.
#pragma once

#include <cctype>
#include <string>

#include <fmt/format.h>

#include "murosimf/formats/mesh/mesh_file.h"

namespace murosimf::formats::mesh {

/// The message about too many triangles, with their number if it is known before they are read.
inline std::string too_many(std::size_t count = 0) {
  const std::string have = count > 0 ? std::to_string(count) : fmt::format("more than {}", most_triangles);
  return fmt::format("the mesh has {} triangles, at most {} are read; simplify it", have, most_triangles);
}

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace murosimf::formats::mesh
