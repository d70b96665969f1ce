#include "apps/run_outputs.h"

#include "apps/results.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/scene/scene_pictures.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::app {

RunOutputs::RunOutputs(const RunOptions& options) : options_(options), saver_(options.save_at, options.save_state) {
  check_json_file(options.json);
  if (!options.picture.empty()) claim_picture("--picture", options.picture);
  if (!options.out.empty()) files::claim_output("--out", options.out);
  if (!options.game.log.empty()) files::claim_output("--game-log", options.game.log);
  if (!options.pictures.empty()) pictures_.emplace(options.pictures, options.picture_every);
}

void RunOutputs::attach(scene::Scene& scene, const scene::SceneOptions& scene_options, const league::League* game,
                        const drawing::DebugDrawSource* others) {
  scene_ = &scene;
  game_ = game;
  if (!options_.log.empty()) {
    log_.emplace(scene.simulation(), options_.log,
                 logging::RunLogOptions{.step_rate = scene.spec().rate,
                                        .property_rate = options_.log_rate,
                                        .others_come = is_steered(options_) || !options_.from.empty()});
  }
  description_ = description_of(options_.scene, scene, scene_options);
  if (game) description_.outside.emplace_back("a GameController or other teams");
  recorder_ = make_recorder(scene, options_.record, *files_, description_, others);
  html_ = make_html_recording(scene, options_.web, others);
}

void RunOutputs::begin() {
  if (!options_.save_at.empty() || !options_.save_state.empty() || !options_.supervision.where.empty()) {
    saver_.begin(*scene_, *files_, description_);
  }
  if (pictures_) pictures_->show(*scene_);
}

std::function<void(bool)> RunOutputs::record_switch() const {
  if (!recorder_ || !is_asked_for(options_.record)) return nullptr;
  return [recorder = recorder_.get()](bool on) { recorder->ask(on); };
}

RunOutputs::Written RunOutputs::write(const scene::RunReport& report) {
  Written written;
  Results results;
  if (log_) results.write([&] { log_->write(options_.out); });
  if (html_) results.write([&] { html_->finish(); });
  if (game_ && !options_.game.log.empty()) {
    results.write([&] { files::write_file(options_.game.log, game_->log().to_text()); });
  }
  if (recorder_) written.recording = finish(*recorder_, report, options_.record);
  results.write([&] { written.states = saver_.finish(); });
  if (!options_.picture.empty()) results.write([&] { write_picture(*scene_, options_.picture); });
  results.write([&] {
    write_result(options_.json, scene::to_text(report), options_.json.empty() ? "" : scene::to_json(report));
  });
  written.files = results.all();
  return written;
}

}  // namespace murosimf::app
