/// obstacle_map.h - the standing obstacles that a robot has seen, in a frame of its own.
///
/// All obstacles are alike: upright, of one color and one radius. A blob's lowest pixel shows where the nearest one of it
/// meets the ground, on the side of the robot; its middle is a radius farther away. A blob that is cut off by the left or right
/// border of the picture is used only while no better sighting exists there, one that is cut off below not at all.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "murosimf/soccer/color_blobs.h"
#include "murosimf/soccer/ground_projection.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::soccer {

inline constexpr std::size_t most_obstacles = 16;

struct Obstacle {
  Vec3d place;        ///< [m] of its middle
  int sightings = 0;  ///< pictures in which it was seen

  void state(StateArchive& archive) { archive(place, sightings); }
};

/// An obstacle of one picture.
struct ObstacleSighting {
  Vec3d place;        ///< [m] of its middle on the ground, robot's frame (ground_projection.h)
  bool whole = true;  ///< not cut off by a side of the picture
};

/// Place of a blob, for obstacles of a `radius` [m]. Nothing if its foot is below the picture, or beyond `farthest` [m].
[[nodiscard]] std::optional<ObstacleSighting> obstacle_of(const Blob& blob, const imaging::Lens& lens,
                                                          const CameraPose& pose, double radius,
                                                          double farthest) noexcept;

class ObstacleMap {
 public:
  /// Adds a sighting at `place` [m] in the frame of the map. Within `same` [m] of a known obstacle it moves that one by a
  /// share of the way, 1/n at first and a fifth later, so that the map follows the robot's own errors. Others are new while
  /// there is room.
  void see(const Vec3d& place, bool whole, double same) noexcept;
  void clear() noexcept { count_ = 0; }

  [[nodiscard]] std::span<const Obstacle> all() const noexcept { return {obstacles_.data(), count_}; }

  /// Throws SetupError for more obstacles than the map holds.
  void state(StateArchive& archive);

 private:
  std::array<Obstacle, most_obstacles> obstacles_{};
  std::size_t count_ = 0;
};

}  // namespace murosimf::soccer
