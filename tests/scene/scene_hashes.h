/// scene_hashes.h - what a scene shows, as hashes by name: do two of them go on alike, and if not, what differs first?
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// Hashes of everything that can be observed, by name.
inline std::map<std::string, std::uint64_t> hashes_of(const Scene& scene) {
  std::map<std::string, std::uint64_t> hashes{{"all", scene.simulation().state_hash()}};
  scene.simulation().world().for_all([&](const Entity& entity) {
    for (const auto& [name, column] : entity.columns()) {
      Hasher hasher;
      column->append_to(hasher);
      hashes[entity.name() + " " + name] = hasher.value();
    }
  });
  return hashes;
}

/// After each of a few further steps, which show what was forgotten, and at the end.
inline std::vector<std::map<std::string, std::uint64_t>> go_on(Scene& scene, Duration duration) {
  std::vector<std::map<std::string, std::uint64_t>> hashes{hashes_of(scene)};
  for (int i = 0; i < 3; ++i) {
    scene.simulation().step();
    hashes.push_back(hashes_of(scene));
  }
  scene.simulation().run(duration);
  hashes.push_back(hashes_of(scene));
  return hashes;
}

/// What differs first: the step and names.
inline std::string difference(const std::vector<std::map<std::string, std::uint64_t>>& one,
                              const std::vector<std::map<std::string, std::uint64_t>>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::string names;
    for (const auto& [name, hash] : one[i]) {
      if (!other[i].contains(name) || other[i].at(name) != hash) names += ", " + name;
    }
    if (one[i].size() != other[i].size()) names += ", other columns";
    if (!names.empty()) return std::to_string(i) + names;
  }
  return "";
}

/// Those that come with the program.
inline std::vector<std::string> all_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(MUROSIMF_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace murosimf::scene
