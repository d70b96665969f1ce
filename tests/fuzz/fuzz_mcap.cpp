// Recordings, MCAP: by their summaries and looked through.
#include "murosimf/recording/frame_reader.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "tests/fuzz/fuzz.h"

namespace {

/// Some of what moves in seeds/frames.mcap: what `run --record-what poses,joints,contacts` wrote of 30 ms, written again without compression
/// and checksums, which would keep nearly all changes from the readers.
murosimf::recording::RecordedEntity car() {
  murosimf::recording::RecordedEntity car;
  car.name = "car";
  car.links = {{0, -1, "car/chassis"}, {1, 0, "car/steer_left"}, {2, 1, "car/turn_front_left"}};
  car.joints = {{1, "car/steer_left"}, {2, "car/turn_front_left"}};
  return car;
}

}  // namespace

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
      const std::vector<recording::RecordedEntity> entities = {car()};
      recording::FrameReader frames(reader, entities);
      int left = 100;
      for (std::optional<Duration> time = frames.begin(); time && left > 0; time = frames.after(*time), --left) {
        if (frames.at(*time).time > *time) std::abort();
      }
    });
  }
  return 0;
}
