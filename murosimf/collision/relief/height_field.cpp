#include "murosimf/collision/relief/height_field.h"

#include <algorithm>

namespace murosimf::collision {
namespace {

constexpr double wall_thickness = 0.1;  // [m] of the solid behind the walls around it, at most

/// The vertices of a grid, and below those of its border.
class GridMesh {
 public:
  GridMesh(const HeightField& field, double bottom) : field_(field), bottom_(bottom) {
    for (std::size_t i = 0; i < field.rows; ++i) {
      for (std::size_t j = 0; j < field.columns; ++j) mesh_.vertices.push_back(place(i, j));
    }
  }

  [[nodiscard]] geometry::TriangleMesh make() {
    for (std::size_t i = 0; i + 1 < field_.rows; ++i) {
      for (std::size_t j = 0; j + 1 < field_.columns; ++j) add_cell(i, j);
    }
    const std::size_t last_row = field_.rows - 1, last_column = field_.columns - 1;
    for (std::size_t j = 0; j < last_column; ++j) {
      add_wall(last_row, j, last_row, j + 1);
      add_wall(0, j + 1, 0, j);
    }
    for (std::size_t i = 0; i < last_row; ++i) {
      add_wall(i, 0, i + 1, 0);
      add_wall(i + 1, last_column, i, last_column);
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::uint32_t number(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(i * field_.columns + j);
  }
  [[nodiscard]] Vec3d place(std::size_t i, std::size_t j) const {
    const auto share = [](std::size_t k, std::size_t count) {
      return static_cast<double>(k) / static_cast<double>(count - 1) - 0.5;
    };
    return {field_.length * share(j, field_.columns), -field_.width * share(i, field_.rows),
            field_.heights[number(i, j)]};
  }
  void add_cell(std::size_t i, std::size_t j) {
    const std::uint32_t left = number(i + 1, j), right = number(i + 1, j + 1);
    const std::uint32_t far_left = number(i, j), far_right = number(i, j + 1);
    mesh_.triangles.push_back({left, right, far_right});
    mesh_.triangles.push_back({left, far_right, far_left});
  }
  std::uint32_t add_below(std::size_t i, std::size_t j) {
    Vec3d p = place(i, j);
    p.z = bottom_;
    mesh_.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  /// The ground lies to the left of the way from one corner to the other.
  void add_wall(std::size_t i, std::size_t j, std::size_t next_i, std::size_t next_j) {
    const std::uint32_t from = number(i, j), to = number(next_i, next_j);
    const std::uint32_t below_from = add_below(i, j), below_to = add_below(next_i, next_j);
    mesh_.triangles.push_back({from, below_from, below_to});
    mesh_.triangles.push_back({from, below_to, to});
  }

  const HeightField& field_;
  double bottom_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

ReliefPtr make_relief(const HeightField& field) {
  const double bottom = *std::ranges::min_element(field.heights) - field.base;
  return std::make_shared<const Relief>(GridMesh(field, bottom).make(),
                                        Relief::Options{.thickness = wall_thickness, .bottom = bottom});
}

}  // namespace murosimf::collision
