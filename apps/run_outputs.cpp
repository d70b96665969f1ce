#include "apps/run_outputs.h"

#include "apps/standard_output.h"
#include "murosimf/files/output_file.h"
#include "murosimf/scene/scene_pictures.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::app {

RunOutputs::RunOutputs(const RunOptions& options) : options_(options), saver_(options.save_at, options.save_state) {
  check_json_file(options.json);
  for (const std::string& file : {options.picture, options.out, options.game.log}) {
    if (!file.empty()) files::check_writable(file);
  }
  if (!options.pictures.empty()) pictures_.emplace(options.pictures, options.picture_every);
}

void RunOutputs::attach(scene::Scene& scene, const scene::SceneOptions& scene_options, const league::League* game,
                        const connect::DrawingBoard* others) {
  scene_ = &scene;
  game_ = game;
  if (!options_.log.empty()) {
    log_.emplace(scene.simulation(), options_.log,
                 logging::RunLogOptions{.step_rate = scene.spec().rate, .property_rate = options_.log_rate});
  }
  description_ = description_of(options_.scene, scene, scene_options);
  if (game) description_.outside.emplace_back("a GameController or other teams");
  recorder_ = make_recorder(scene, options_.record, files_, description_, others);
  html_ = make_html_recording(scene, options_.web, others);
}

void RunOutputs::begin() {
  if (!options_.save_at.empty() || !options_.save_state.empty() || !options_.supervision.where.empty()) {
    saver_.begin(*scene_, files_, description_);
  }
  if (pictures_) pictures_->show(*scene_);
}

std::function<void(bool)> RunOutputs::record_switch() const {
  if (!recorder_ || !is_asked_for(options_.record)) return nullptr;
  return [recorder = recorder_.get()](bool on) { recorder->ask(on); };
}

RunOutputs::Written RunOutputs::write(const scene::RunReport& report) {
  if (log_) log_->write(options_.out);
  if (html_) html_->finish();
  if (game_ && !options_.game.log.empty()) files::write_file(options_.game.log, game_->log().to_text());
  const Written written{!recorder_ || finish(*recorder_, report, options_.record), saver_.finish()};
  if (!options_.picture.empty()) write_picture(*scene_, options_.picture);
  write_result(options_.json, scene::to_text(report), options_.json.empty() ? "" : scene::to_json(report));
  return written;
}

}  // namespace murosimf::app
