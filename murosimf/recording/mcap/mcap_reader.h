/// mcap_reader.h - reads MCAP files: by their summary, or by scanning a file that was cut off.
///
/// Messages must be in chunks, as written by nearly every program; others are refused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "murosimf/files/file_pointer.h"
#include "murosimf/recording/mcap/mcap_records.h"

namespace murosimf::recording {

inline constexpr std::uint64_t most_chunk_bytes = 256'000'000;  ///< uncompressed; usual ones have a million

struct McapContents {
  Header header;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkIndex> chunks;  ///< in the order of the file
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  Statistics statistics;
  std::string damage;  ///< error in the file, in one line; empty: complete, according to its summary
  /// One line about data of a second run, and its place; empty: none found.
  std::string other_run;
};

enum class McapReading : std::uint8_t {
  by_summary,  ///< scans the file only if the summary is missing or damaged
  through_all  ///< checks every chunk
};

class McapReader {
 public:
  /// Throws SetupError if this is no MCAP file, or nothing of it is readable.
  explicit McapReader(const std::filesystem::path& file, McapReading reading = McapReading::by_summary);

  [[nodiscard]] const McapContents& contents() const { return contents_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  // All throw SetupError, one line that begins with the file's name and place, if that place is damaged.

  /// Calls `visit` with the messages of a chunk, ordered by time; their data are valid until it returns.
  void visit_messages(const ChunkIndex& chunk, const std::function<void(const Message&)>& visit) const;
  [[nodiscard]] Attachment attachment(const AttachmentIndex& index) const;
  [[nodiscard]] Metadata metadata(const MetadataIndex& index) const;

 private:
  struct Record {
    Opcode opcode{};
    std::uint64_t length = 0;  // [byte] of the whole record
  };
  [[nodiscard]] std::string bytes_at(std::uint64_t offset, std::uint64_t length) const;
  [[nodiscard]] Record record_at(std::uint64_t offset) const;
  [[nodiscard]] std::string content_at(std::uint64_t offset, std::uint64_t length, Opcode opcode) const;
  void check_channel(const Message& message) const;
  [[nodiscard]] std::string records_of(const ChunkIndex& chunk) const;
  template <class Call>
  auto at(std::uint64_t offset, const Call& call) const;

  void check_header();
  [[nodiscard]] bool read_summary();
  void take_summary_record(Opcode opcode, std::string_view content);
  void look_through();
  [[nodiscard]] bool take_record(const Record& record, std::uint64_t offset);
  [[nodiscard]] bool take_chunk(std::uint64_t offset, std::uint64_t length);
  void take_chunk_record(Opcode opcode, std::string_view content);
  void note_damage(const std::string& damage);
  void note_other_run(std::uint64_t offset, const std::string& how);
  void look_for_other_run();
  [[nodiscard]] std::uint64_t find_magic(std::uint64_t offset) const;
  template <class Index>
  [[nodiscard]] bool is_again(const std::vector<Index>& known, const std::string& found, const char* name,
                              std::uint64_t offset);
  [[nodiscard]] bool is_other_channel(std::string_view content, std::uint64_t offset);
  [[nodiscard]] bool is_before_last(const Chunk& chunk, std::uint64_t offset);

  std::filesystem::path file_;
  mutable std::mutex reading_;  // several threads may read
  files::FilePtr stream_;
  std::uint64_t size_ = 0;
  McapContents contents_;
};

/// Calls `visit` with the opcode and content of every record in `bytes`. Throws SetupError if the last one ends too early.
void visit_records(std::string_view bytes, const std::function<void(Opcode, std::string_view)>& visit);

}  // namespace murosimf::recording
