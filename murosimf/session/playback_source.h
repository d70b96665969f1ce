/// playback_source.h - what a session leads through time: a scene that is computed (live_source.h), or a recording of one that is played
/// (recording/recorded_source.h).
///
/// All of it is called by the thread that runs the session.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/session/timeline.h"

namespace murosimf::session {

class PlaybackSource {
 public:
  virtual ~PlaybackSource() = default;

  /// Where everything is seen; now() is its simulation's.
  [[nodiscard]] virtual scene::Scene& scene() = 0;
  /// Initializes; once, before everything else.
  virtual void begin() = 0;
  /// To the next instant; nothing if at_end().
  virtual void step() = 0;
  /// Nothing comes after this instant.
  [[nodiscard]] virtual bool at_end() const { return false; }

  // These throw SetupError if it cannot be done.

  /// Back to the start.
  virtual void reset(std::optional<std::uint64_t> seed) = 0;
  /// To an instant that was there before, of the present branch if none is given. Ends on the way there when `given_up` says so.
  virtual void seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) = 0;
  /// `load` puts a state of somewhere else into the scene, or throws and changes nothing: a branch without a parent begins there.
  virtual void load(const std::function<void(scene::Scene&)>& load) = 0;
  /// Each PATH = VALUE as of Scene::post; all of them, or none if one cannot be.
  virtual void change(const std::vector<std::string>& changes) = 0;

  /// What is to be said of what goes on from the present instant ("software of ... keeps its own state: ..."); empty: nothing.
  [[nodiscard]] virtual std::string diagnostic() const { return {}; }

  // Of the time line.

  [[nodiscard]] virtual int branch() const = 0;
  /// Of the present branch, with what led to it.
  [[nodiscard]] virtual Duration first() const = 0;
  [[nodiscard]] virtual Duration last() const = 0;
  [[nodiscard]] virtual std::vector<BranchView> branches() const = 0;
  /// Whether there is more of them since the last call.
  [[nodiscard]] virtual bool has_grown() = 0;

  /// Names of the properties whose columns are right at every instant; empty: all are. Can be asked from any thread.
  [[nodiscard]] virtual const std::vector<std::string>& known_properties() const = 0;
};

using MakeCourse = std::function<std::unique_ptr<PlaybackSource>()>;

}  // namespace murosimf::session
