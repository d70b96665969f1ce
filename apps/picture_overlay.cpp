#include "apps/picture_overlay.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/interruption.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_source.h"
#include "murosimf/render/caption.h"

namespace murosimf::app {
namespace {

const std::vector<std::string>& overlay_words() {
  static const std::vector<std::string> words = {"all", "time", "score", "names", "levels", "forces", "support"};
  return words;
}

}  // namespace

Option add_overlay(const Command& command, std::vector<std::string>& words) {
  return command
      .add("--overlay", words,
           "What is drawn over colors: time, score, names, levels of detail, forces of contact, support polygons; "
           "alone: all of it")
      .value_if_alone("all")
      .separated_by(',')
      .one_of(overlay_words())
      .offers(overlay_words());
}

bool has_word(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::any_of(words, [&](const std::string& one) { return one == word || one == "all"; });
}

PictureOverlay::PictureOverlay(scene::Scene& scene, const std::vector<std::string>& words)
    : scene_(scene), time_(has_word(words, "time")), outline_(viewer::outline_of(scene)) {
  options_ = {.forces = has_word(words, "forces"),
              .names = has_word(words, "names"),
              .levels = has_word(words, "levels"),
              .support_polygons = has_word(words, "support")};
  const bool asked = std::ranges::find(words, "score") != words.end();
  if (asked || (has_word(words, "score") && scene.spec().teams.size() == 2)) {
    with_context("--overlay score", [&] { score_ = std::make_unique<recording::ScoreKeeper>(scene); });
  }
}

void PictureOverlay::watch_score() {
  if (score_) score_->watch(scene_);
}

void PictureOverlay::read_score(const std::shared_ptr<const recording::RecordedRun>& run, Duration until) {
  if (!score_ || score_->hear(*run)) return;
  recording::RecordedSource source(run);
  score_->count(find_moments(source, [&] { return interrupted() || source.scene().simulation().now() > until; }));
}

void PictureOverlay::read_score(const recording::RecordedRun& run, const std::vector<recording::Moment>& moments) {
  if (score_ && !score_->hear(run)) score_->count(moments);
}

void PictureOverlay::draw(const sensors::Perspective& from, imaging::ColorImage& picture) {
  Simulation& simulation = scene_.simulation();
  simulation.poses().take(simulation.world(), simulation.now(), 0, frame_);
  frame_.contacts.clear();
  simulation.poses().add_contacts(simulation.world(), frame_.contacts);
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  const viewer::Inspection seen = viewer::inspect(scene_, {.events_known = all, .warnings_known = all});
  const bool captions = time_ || score_;
  const viewer::OverlayStyle style{.letters = std::max(11.0, picture.height() / 42.0),
                                   .width = std::max(1.0, picture.height() / 480.0),
                                   .top = captions ? render::caption_room(picture.height()) : 0};
  render::draw_over(picture, shapes_of(overlays(frame_, outline_, seen, options_, -1), from, style));
  if (time_) {
    render::draw_caption(picture, fmt::format("{:.2f} s", seconds(simulation.now())), render::CaptionPlace::top_left);
  }
  if (!score_) return;
  const auto& teams = scene_.spec().teams;
  const std::array<int, 2> goals = score_->at(simulation.now());
  const std::array colors{teams[0].color, teams[1].color};
  render::draw_caption(picture, fmt::format("{} {} : {} {}", teams[0].name, goals[0], goals[1], teams[1].name),
                       render::CaptionPlace::top, colors);
}

}  // namespace murosimf::app
