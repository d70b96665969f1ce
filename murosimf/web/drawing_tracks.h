/// drawing_tracks.h - debug drawings (drawing/drawn.h) over all frames of an HTML file: a track for each group, which
/// contains changes only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "murosimf/drawing/drawn.h"

namespace murosimf::web {

class DrawingTracks {
 public:
  /// All drawings from this frame on; frames must increase.
  void take(std::size_t frame, const std::vector<drawing::Drawn>& all);
  [[nodiscard]] bool empty() const { return tracks_.empty(); }

  /// `{looks: [[kind, size, red, green, blue, opacity, words, points, triangles]],
  /// tracks: [{entity, by, name, of_robot, frames, looks, points}]}`. Only polygons have `triangles`, numbers of points.
  /// Each version of a group has one number in `frames`, the number of frames since the previous version, and one element in the other two:
  /// `looks` has one number for each shape, null if unchanged, none if the group was removed; `points` are all coordinates [mm],
  /// as differences to the previous version if that has the same number.
  [[nodiscard]] nlohmann::json object() const;

 private:
  using Numbers = std::vector<std::int64_t>;
  struct Version {
    std::size_t frame = 0;
    bool same_looks = false;
    Numbers looks, points;
  };
  struct Track {
    Numbers looks, points;  // of the last version
    std::vector<Version> versions;
  };
  using Key = std::tuple<int, std::string, std::string, bool>;  // entity, by, name, of_robot
  std::int64_t look_of(const DrawnShape& shape);
  static void add(Track& track, std::size_t frame, Numbers looks, Numbers points);

  std::map<Key, Track> tracks_;
  std::map<std::string, std::int64_t> looks_;  // by JSON text
  std::vector<std::string> looks_in_order_;
};

}  // namespace murosimf::web
