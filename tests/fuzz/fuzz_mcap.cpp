// Recordings, MCAP: by their summaries and looked through.
#include "murosimf/recording/frame_reader.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  for (const auto reading : {recording::McapReading::by_summary, recording::McapReading::through_all}) {
    fuzz::feed(data, size, ".mcap", [&](const auto& file) {
      const recording::McapReader reader(file, reading);
      for (const auto& chunk : reader.contents().chunks) {
        reader.visit_messages(chunk, [&](const recording::Message& message) {
          if (message.data.size() > recording::most_chunk_bytes) std::abort();
        });
      }
      for (const auto& index : reader.contents().attachments) (void)reader.attachment(index);
      for (const auto& index : reader.contents().metadata) (void)reader.metadata(index);
      const std::vector<recording::RecordedEntity> nobody;
      recording::FrameReader frames(reader, nobody);
      int left = 100;
      for (std::optional<Duration> time = frames.begin(); time && left > 0; time = frames.after(*time), --left) {
        if (frames.at(*time).time > *time) std::abort();
      }
    });
  }
  return 0;
}
