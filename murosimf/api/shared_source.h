/// shared_source.h - a scene that a session and a program step by turns, without a way back in time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/api/scene_inside.h"
#include "murosimf/model/error.h"
#include "murosimf/session/playback_source.h"

namespace murosimf::api {

class SharedSource final : public session::PlaybackSource {
 public:
  explicit SharedSource(std::shared_ptr<SceneInside> inside) : inside_(std::move(inside)) {}

  [[nodiscard]] scene::Scene& scene() override { return inside_->scene; }
  void begin() override { inside_->begin(); }
  void step() override { inside_->step(); }
  void reset(std::optional<std::uint64_t>) override { refuse("reset"); }
  void seek(Duration, std::optional<int>, const std::function<bool()>&) override { refuse("way back in time"); }
  /// The program's own jumps.
  void load(const std::function<void(scene::Scene&)>& load) override { load(inside_->scene); }
  void change(const std::vector<std::string>& changes) override { inside_->scene.change(changes); }

  [[nodiscard]] int branch() const override { return 0; }
  [[nodiscard]] Duration first() const override { return inside_->scene.simulation().now(); }
  [[nodiscard]] Duration last() const override { return first(); }
  [[nodiscard]] std::vector<session::BranchView> branches() const override {
    session::BranchView all;
    all.begin = all.end = first();
    return {all};
  }
  [[nodiscard]] bool has_grown() override { return false; }
  [[nodiscard]] const std::vector<std::string>& known_properties() const override { return all_; }

 private:
  [[noreturn]] static void refuse(const char* what) {
    throw SetupError(std::string("no ") + what + ": a program steps this scene, too");
  }

  std::shared_ptr<SceneInside> inside_;
  std::vector<std::string> all_;  // empty
};

}  // namespace murosimf::api
