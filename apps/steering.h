/// steering.h - supervisors of a run, which may replace its scene: they stay connected while runs follow each other.
#pragma once

#include <memory>
#include <optional>

#include "apps/run_options.h"
#include "apps/run_outputs.h"
#include "murosimf/files/allowed_files.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::app {

class Steering {
 public:
  explicit Steering(const RunOptions& options) : first_(options) {}

  /// They steer this one from now on, which has these options and outputs, until leave(). Throws SetupError.
  void begin(session::Session& session, const scene::Scene& scene, const RunOptions& options, RunOutputs& outputs);
  void leave();
  /// What scenes and models that come over a network may be made of; null before the first begin().
  [[nodiscard]] const std::shared_ptr<const files::AllowedFiles>& allowed_files() const { return allowed_; }
  /// Another scene comes next: its session is to be finished then. Throws SetupError: it cannot be, or the run keeps its scene.
  void exchange(const supervise::SceneRequest& request);

  /// Whether another run follows.
  [[nodiscard]] bool goes_on() const { return next_.has_value(); }
  /// Options of the next run; can be called once.
  [[nodiscard]] RunOptions take_next();

 private:
  [[nodiscard]] RunOptions options_for(const supervise::SceneRequest& request) const;

  const RunOptions& first_;
  std::shared_ptr<const files::AllowedFiles> allowed_;  ///< that scenes of supervisors may be made of
  const RunOptions* options_ = nullptr;
  RunOutputs* outputs_ = nullptr;
  std::optional<supervise::SceneRequest> next_;
  std::unique_ptr<supervise::Supervision> supervision_;
};

}  // namespace murosimf::app
