/// playback_source.h - what a session plays: a scene that is computed (live_source.h), or a recording of one
/// (recording/recorded_source.h).
///
/// All functions are called by the thread that runs the session.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "murosimf/session/timeline.h"

namespace murosimf::session {

class PlaybackSource {
 public:
  virtual ~PlaybackSource() = default;

  /// The scene that shows the present instant; now() is its simulation's.
  [[nodiscard]] virtual scene::Scene& scene() = 0;
  /// Initializes; once, before all other calls.
  virtual void begin() = 0;
  /// Advances to the next instant; nothing if at_end().
  virtual void step() = 0;
  /// Whether this is the last instant.
  [[nodiscard]] virtual bool at_end() const { return false; }

  // These throw SetupError if it is impossible.

  /// Returns to the start.
  virtual void reset(std::optional<std::uint64_t> seed) = 0;
  /// To an earlier instant, of the present branch if none is given. Stops on the way there when `given_up` returns true.
  virtual void seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) = 0;
  /// `load` puts a state from elsewhere into the scene, or throws and changes nothing: a branch without a parent begins there.
  virtual void load(const std::function<void(scene::Scene&)>& load) = 0;
  /// Each PATH = VALUE as of Scene::post; all of them, or none if one fails.
  virtual void change(const std::vector<std::string>& changes) = 0;
  /// `add` adds entities (Scene::add), or throws and changes nothing: a branch without a parent begins there.
  virtual void extend(const std::function<void(scene::Scene&)>& add) {
    (void)add;
    throw SetupError("nothing is added to this run: its scene is not computed");
  }

  /// Diagnostic of the run from the present instant on ("software of ... keeps its own state: ..."); empty: none.
  [[nodiscard]] virtual std::string diagnostic() const { return {}; }

  // The timeline.

  [[nodiscard]] virtual int branch() const = 0;
  /// Limits of the present branch, including its ancestors.
  [[nodiscard]] virtual Duration first() const = 0;
  [[nodiscard]] virtual Duration last() const = 0;
  [[nodiscard]] virtual std::vector<BranchView> branches() const = 0;
  /// Whether there are more of them since the last call.
  [[nodiscard]] virtual bool has_grown() = 0;

  /// Names of the properties whose columns are valid at every instant; empty: all are. From any thread.
  [[nodiscard]] virtual const std::vector<std::string>& known_properties() const = 0;
};

using MakeSource = std::function<std::unique_ptr<PlaybackSource>()>;

}  // namespace murosimf::session
