/// small_recording.h - an MCAP file for tests: two topics, some chunks, an attachment, metadata.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/recording/mcap/mcap_writer.h"

namespace murosimf::fixtures {

inline constexpr int small_recording_steps = 500;  ///< of 10 ms, with one message each on "/a", every tenth on "/b"

inline std::string small_message(int step) {
  return std::string(static_cast<std::size_t>(step % 50), 'x') + std::to_string(step);
}

/// Up to `steps`; a summary only if `closed`.
inline void write_small_recording(const std::filesystem::path& file, bool closed = true, bool compressed = true) {
  using namespace recording;
  McapWriter out(file, {.library = "test", .compressed = compressed});
  const auto schema = out.add_schema("thing", "jsonschema", "{}");
  const auto a = out.add_channel("/a", "json", schema, {{"unit", "m"}});
  const auto b = out.add_channel("/b", "json", 0);
  out.attach(
      {.log_time = 1, .create_time = 2, .name = "scene.toml", .media_type = "text/plain", .data = "duration = 3\n"});
  out.add({.name = "run", .values = {{"seed", "7"}, {"program", "test"}}});
  for (int step = 0; step < small_recording_steps; ++step) {
    out.write(a, std::chrono::milliseconds(10 * step), small_message(step));
    if (step % 10 == 0) out.write(b, std::chrono::milliseconds(10 * step), "b");
  }
  if (closed) {
    out.close();
  } else {
    out.begin();
    out.flush();
  }
}

}  // namespace murosimf::fixtures
