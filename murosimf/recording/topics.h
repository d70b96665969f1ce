/// topics.h - access to messages of a recording by their topics.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

/// The channels of these topics, by id.
[[nodiscard]] std::map<std::uint16_t, std::string> channels_of(const McapReader& file,
                                                               const std::set<std::string>& topics);
/// Whether a chunk can contain messages of one of these channels, by id.
template <class Of>
[[nodiscard]] bool has_any(const ChunkIndex& chunk, const std::map<std::uint16_t, Of>& channels) {
  return chunk.message_indexes.empty() ||
         std::ranges::any_of(channels, [&](const auto& one) { return chunk.message_indexes.contains(one.first); });
}

/// Calls visit(topic, message, chunk) with all messages of some topics.
template <class Visit>
void visit_topics(const McapReader& file, const std::set<std::string>& topics, const Visit& visit) {
  const auto wanted = channels_of(file, topics);
  for (std::size_t i = 0; i < file.contents().chunks.size(); ++i) {
    const ChunkIndex& chunk = file.contents().chunks[i];
    if (!has_any(chunk, wanted)) continue;
    file.visit_messages(chunk, [&](const Message& message) {
      const auto topic = wanted.find(message.channel_id);
      if (topic != wanted.end()) visit(topic->second, message, i);
    });
  }
}

[[nodiscard]] inline Duration time_of(const Message& message) {
  return Duration(static_cast<Duration::rep>(message.log_time));
}

/// The text of a foxglove.Log.
[[nodiscard]] std::string text_of_log(std::string_view data);

}  // namespace murosimf::recording
