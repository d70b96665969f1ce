/// live_source.h - a scene that is computed while a session runs, with a timeline for going back.
#pragma once

#include <cstddef>

#include "murosimf/session/playback_source.h"

namespace murosimf::session {

struct LiveOptions {
  TimelineOptions timeline{};  ///< states kept for going back
  std::string no_way_back{};   ///< reason why reset and going back are impossible ("it is recorded"); empty: possible
};

class LiveSource final : public PlaybackSource {
 public:
  /// The scene must outlive it.
  explicit LiveSource(scene::Scene& scene, const LiveOptions& options = {});
  explicit LiveSource(std::unique_ptr<scene::Scene> scene, const LiveOptions& options = {});

  [[nodiscard]] scene::Scene& scene() override { return scene_; }
  void begin() override;
  void step() override;
  void reset(std::optional<std::uint64_t> seed) override;
  void seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) override;
  void load(const std::function<void(scene::Scene&)>& load) override;
  void change(const std::vector<std::string>& changes) override;
  void extend(const std::function<void(scene::Scene&)>& add) override;
  [[nodiscard]] std::string diagnostic() const override { return diagnostic_; }

  [[nodiscard]] int branch() const override { return timeline_.present(); }
  [[nodiscard]] Duration first() const override { return timeline_.first(); }
  [[nodiscard]] Duration last() const override { return timeline_.last(); }
  [[nodiscard]] std::vector<BranchView> branches() const override { return timeline_.branches(); }
  [[nodiscard]] bool has_grown() override;
  [[nodiscard]] const std::vector<std::string>& known_properties() const override { return all_; }

 private:
  void note_commands();
  void note_outside();
  void begin_branch();
  void repeat(const Timeline::Way& way, Duration time, const std::function<bool()>& given_up);
  [[nodiscard]] ExternalInputHistory& outside() { return *scene_.parts().outside.memory; }

  std::unique_ptr<scene::Scene> own_;
  scene::Scene& scene_;
  Simulation& simulation_;
  LiveOptions options_;
  Timeline timeline_;
  std::size_t noted_ = 0;  // number of commands noted
  struct Place {
    int branch = -1;
    Duration time{};
    friend bool operator==(const Place&, const Place&) = default;
  };
  Place live_;                // instant reached by external participants
  std::string diagnostic_;    // PlaybackSource::diagnostic
  bool diagnostics_ = false;  // not yet reported for the present run
  int told_branch_ = -1;
  bool new_state_ = false;
  std::vector<std::string> all_;  // empty
};

}  // namespace murosimf::session
