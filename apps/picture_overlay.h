/// picture_overlay.h - what `render` and `highlights` draw over pictures of a scene: time, score, names, levels, forces, support.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "murosimf/recording/score_keeper.h"
#include "murosimf/scene/scene.h"
#include "murosimf/viewer/overlay_shapes.h"

namespace murosimf::app {

/// The option --overlay.
Option add_overlay(const Command& command, std::vector<std::string>& words);

/// Whether these words have this one, by its name or by "all".
[[nodiscard]] bool has_word(const std::vector<std::string>& words, const std::string& word);

class PictureOverlay {
 public:
  /// `words`: as given to the option. The scene must be initialized and outlive it. Throws SetupError: there is no score to show.
  PictureOverlay(scene::Scene& scene, const std::vector<std::string>& words);

  /// Of the scene, which runs.
  void watch_score();
  /// Of a recording, until an instant; `moments`: those until then, if they are known.
  void read_score(const std::shared_ptr<const recording::RecordedRun>& run, Duration until);
  void read_score(const recording::RecordedRun& run, const std::vector<recording::Moment>& moments);

  /// Of the present instant, over a picture from there. Throws SetupError if this build has no pictures.
  void draw(const sensors::Perspective& from, imaging::ColorImage& picture);

 private:
  scene::Scene& scene_;
  bool time_;
  viewer::OverlayOptions options_;
  std::unique_ptr<recording::ScoreKeeper> score_;  // null: it is not shown
  std::vector<viewer::EntityOutline> outline_;
  PoseFrame frame_;
};

}  // namespace murosimf::app
