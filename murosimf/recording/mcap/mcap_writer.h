/// mcap_writer.h - writes an MCAP file: chunks with indexes of their messages, and a summary at the end with the places of all records.
///
///     McapWriter file("game.mcap", {.library = "murosimf 0.1.0"});
///     const auto schema = file.add_schema("foxglove.Log", "protobuf", descriptors);
///     const auto channel = file.add_channel("/events", "protobuf", schema);
///     file.write(channel, 20ms, bytes);
///     file.close();
///
/// Schemas and channels are outside of chunks, so that every complete chunk can be read whatever happened to the others. Place and
/// replacement of the file: growing_file.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/mcap/growing_file.h"
#include "murosimf/recording/mcap/mcap_records.h"
#include "murosimf/recording/mcap/message_sink.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

struct McapOptions {
  std::string library;                                   ///< name and version of the program that writes
  std::string profile = {};                              ///< conventions of its messages, like "ros2"; empty: none
  std::size_t chunk_bytes = 1 << 20;                     ///< size at which a chunk is complete,
  Duration chunk_span = std::chrono::milliseconds(500);  ///< or the span of time of its messages
  bool compressed = true;                                ///< if supported by the build (compression.h)
};

/// All throw SetupError if the file cannot be written; data written before stay readable.
class McapWriter final : public MessageSink {
 public:
  McapWriter(const std::filesystem::path& file, McapOptions options);

  [[nodiscard]] std::uint16_t add_schema(const std::string& name, const std::string& encoding,
                                         std::string data) override;
  [[nodiscard]] std::uint16_t add_channel(const std::string& topic, const std::string& encoding, std::uint16_t schema,
                                          TextMap metadata = {}) override;
  void write(std::uint16_t channel, Duration time, std::string_view data) override;
  void attach(const Attachment& attachment);
  void add(const Metadata& metadata);

  /// Writes to the file from now on; until then, or close(), data are kept in memory, and no file changes.
  void begin() { file_.begin(); }
  /// Completes the present chunk.
  void flush();
  /// Returns when the disk has all data of the file.
  void sync();
  /// Writes the summary, and gives the file its name. Without it the file is incomplete.
  void close();

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  [[nodiscard]] std::uint64_t bytes() const { return file_.size(); }
  [[nodiscard]] const GrowingFile& file() const { return file_; }

 private:
  template <class Record>
  void append(const Record& record);
  [[nodiscard]] std::string summary(std::uint64_t start, std::uint64_t& offset_start) const;

  McapOptions options_;
  GrowingFile file_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<std::uint32_t> sequences_;  // by channel, of its next message
  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
  Statistics statistics_;

  std::string records_;                // of the present chunk
  std::vector<MessageIndex> indexes_;  // of it, by channel
  std::uint64_t start_time_ = 0, end_time_ = 0;
};

}  // namespace murosimf::recording
