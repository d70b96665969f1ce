/// dae_geometry.h - a `geometry` element of a COLLADA file as triangles.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Elements of a COLLADA file by their attribute `id`.
class DaeIds {
 public:
  explicit DaeIds(const files::XmlElement& root);
  /// The element that the attribute, "#id", refers to. Throws SetupError if there is no such element in the file.
  [[nodiscard]] const files::XmlElement& find(const files::XmlElement& user, const char* attribute) const;
  /// The element with this id; nothing: there is none.
  [[nodiscard]] std::optional<files::XmlElement> find(const std::string& id) const;

 private:
  std::map<std::string, files::XmlElement> elements_;
};

/// The numbers in an element. Throws SetupError for other contents, or if there are not `count` of them (0: any number).
[[nodiscard]] std::vector<double> dae_numbers(const files::XmlElement& element, std::size_t count = 0);

struct DaeGeometry {
  geometry::TriangleMesh mesh;
  std::vector<std::string> symbols;      ///< of its materials
  std::vector<std::uint32_t> symbol_of;  ///< by triangle, an index
  std::vector<PicturePlaces> places;     ///< by triangle; (0, 0) where there are none
};

/// Triangles of triangles, polylist, polygons, tristrips and trifans, polygons as fans, in the file's own unit and the
/// frame of the geometry; none for a geometry without surface. Throws SetupError for indices out of range, polygons with
/// holes, and more triangles than `most_triangles`.
[[nodiscard]] DaeGeometry read_dae_geometry(const files::XmlElement& geometry, const DaeIds& ids);

}  // namespace murosimf::robot_formats::mesh
