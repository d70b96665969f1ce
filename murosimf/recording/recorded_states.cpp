#include "murosimf/recording/recorded_states.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/topics.h"

namespace murosimf::recording {
namespace {

/// One of the messages murosimf.StateHash and murosimf.State.
struct StateMessage {
  std::uint64_t hash = 0;
  std::string_view state;
};

StateMessage read_state(std::string_view data) {
  StateMessage message;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 2) message.hash = in.fixed64();
    if (in.field() == 3) message.state = in.bytes();
  }
  return message;
}

/// Of two states at one instant the later one counts: between them the run was changed.
void add(std::map<Duration, RecordedState>& states, const RecordedState& state) {
  const auto [known, is_new] = states.try_emplace(state.time, state);
  if (!is_new && (state.chunk || state.hash != known->second.hash)) known->second = state;
}

}  // namespace

std::string attached_text(const McapReader& file, const std::string& name) {
  const auto& all = file.contents().attachments;
  const auto found = std::ranges::find(all, name, &AttachmentIndex::name);
  return found == all.end() ? std::string{} : file.attachment(*found).data;
}

TextMap described(const McapReader& file, const std::string& name) {
  TextMap values;
  for (const MetadataIndex& one : file.contents().metadata) {
    if (one.name != name) continue;
    for (auto& [key, value] : file.metadata(one).values) values.insert_or_assign(key, std::move(value));
  }
  return values;
}

/// The states themselves stay in the file: only where they are is kept.
RecordedStates::RecordedStates(const McapReader& file) : file_(&file) {
  std::map<Duration, RecordedState> states;
  visit_topics(file, {"/state_hash", "/state", "/commands"},
               [&](const std::string& topic, const Message& message, std::size_t chunk) {
                 if (topic == "/commands") {
                   commands_.push_back({.time = time_of(message), .text = text_of_log(message.data)});
                 } else {
                   const StateMessage state = read_state(message.data);
                   const bool whole = !state.state.empty();
                   add(states, {.time = time_of(message),
                                .hash = state.hash,
                                .chunk = whole ? std::optional(chunk) : std::nullopt});
                 }
               });
  for (const auto& [time, state] : states) states_.push_back(state);
  std::ranges::stable_sort(commands_, {}, &Command::time);
}

const RecordedState* RecordedStates::last_until(Duration time) const {
  const RecordedState* last = nullptr;
  for (const RecordedState& state : states_) {
    if (state.chunk && state.time <= time) last = &state;
  }
  return last;
}

/// Read when it is needed: a state may have many megabytes.
std::string RecordedStates::bytes_of(const RecordedState& state) const {
  MUROSIMF_ASSERT(state.chunk.has_value());
  std::string bytes;
  file_->visit_messages(file_->contents().chunks[state.chunk.value()], [&](const Message& message) {
    if (time_of(message) != state.time) return;
    const auto is_state = [&](const Channel& channel) {
      return channel.id == message.channel_id && channel.topic == "/state";
    };
    if (std::ranges::any_of(file_->contents().channels, is_state)) bytes = read_state(message.data).state;
  });
  return bytes;
}

void RecordedStates::load(scene::Scene& scene, const RecordedState& state) const {
  const TextMap run = described(*file_, "murosimf");
  const auto value = [&](const std::string& key) { return run.contains(key) ? run.at(key) : "?"; };
  const std::string origin = fmt::format("{}: state of '{}' at {:.3f} s by {}", file_->file().string(), value("scene"),
                                         seconds(state.time), value("program"));
  const std::string bytes = bytes_of(state);
  with_context(origin, [&] { scene.load(std::as_bytes(std::span(bytes))); });
}

}  // namespace murosimf::recording
