/// recorded_states.h - states in a recording: hashes, whole states, and the commands between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/runtime/command_queue.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// The state of a recorded run at an instant.
struct RecordedState {
  Duration time{};
  std::uint64_t hash = 0;
  std::optional<std::size_t> chunk;  ///< chunk of the whole state; nothing: only the hash is recorded
};

class RecordedStates {
 public:
  /// `file` must outlive it. Throws SetupError if it is damaged.
  explicit RecordedStates(const McapReader& file);

  [[nodiscard]] const McapReader& file() const { return *file_; }
  // Ordered by time.
  [[nodiscard]] const std::vector<RecordedState>& all() const { return states_; }
  [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }
  /// The last whole state until then; null: none.
  [[nodiscard]] const RecordedState* last_until(Duration time) const;

  /// Loads it by Scene::load. Throws SetupError with the origin of the state, and the mismatch.
  void load(scene::Scene& scene, const RecordedState& state) const;

 private:
  [[nodiscard]] std::string bytes_of(const RecordedState& state) const;

  const McapReader* file_;
  std::vector<RecordedState> states_;
  std::vector<Command> commands_;
};

/// The attachment of this name; empty if there is none.
[[nodiscard]] std::string attached_text(const McapReader& file, const std::string& name);
/// The values of its metadata of this name, later ones before earlier ones; empty if there are none.
[[nodiscard]] TextMap described(const McapReader& file, const std::string& name);

}  // namespace murosimf::recording
