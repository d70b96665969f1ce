/// controller_algorithm.h - algorithm: calls a controller of the program (include/murosimf/control.h) at its rate.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "murosimf/control.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::api {

struct SceneInside;

class ControllerTask final : public Algorithm {
 public:
  ControllerTask(Setup& setup, SceneInside& scene, std::shared_ptr<Controller> controller);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { started_ = false; }
  /// An exception of the controller is kept for the thread that steps the scene.
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;

 private:
  void gather() noexcept;

  SceneInside& scene_;
  std::shared_ptr<Controller> controller_;
  std::span<const int> joints_;
  std::span<const double> q_, qd_;                    // by object
  std::span<double> targets_;                         // by object
  std::vector<double> position_, velocity_, target_;  // by joint
  bool started_ = false;
};

}  // namespace murosimf::api
