/// mcap_records.h - the records of MCAP files, version 0 (mcap.dev/spec), as plain data and as bytes.
///
/// A file is `magic`, records, `magic`. A record is its opcode (1 byte), the length of its content (8 bytes), and the content. Times
/// are nanoseconds of simulated time here.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::recording {

inline constexpr std::string_view mcap_magic{"\x89MCAP0\r\n", 8};
inline constexpr std::uint64_t record_head = 9;  ///< [byte] opcode and length

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0a,
  statistics = 0x0b,
  metadata = 0x0c,
  metadata_index = 0x0d,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

using TextMap = std::map<std::string, std::string>;

struct Header {
  std::string profile, library;
};
struct Footer {
  std::uint64_t summary_start = 0, summary_offset_start = 0;  ///< [byte] in the file; 0: none
  std::uint32_t summary_crc = 0;                              ///< 0: none
};
struct Schema {
  std::uint16_t id = 0;  ///< from 1
  std::string name, encoding, data;
};
struct Channel {
  std::uint16_t id = 0, schema_id = 0;
  std::string topic, message_encoding;
  TextMap metadata;
};
struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;  ///< [ns]
  std::string_view data;                         ///< in the caller's bytes
};
struct Chunk {
  std::uint64_t start_time = 0, end_time = 0;  ///< [ns] of its messages
  std::uint64_t uncompressed_size = 0;         ///< [byte]
  std::uint32_t uncompressed_crc = 0;          ///< 0: none
  std::string compression;
  std::string_view records;  ///< compressed; in the caller's bytes
};
struct MessageIndex {
  struct Entry {
    std::uint64_t log_time = 0, offset = 0;  ///< [ns], [byte] in the chunk's records
  };
  std::uint16_t channel_id = 0;
  std::vector<Entry> entries;
};
struct ChunkIndex {
  std::uint64_t start_time = 0, end_time = 0;              ///< [ns]
  std::uint64_t offset = 0, length = 0;                    ///< [byte] of the chunk's record in the file
  std::map<std::uint16_t, std::uint64_t> message_indexes;  ///< [byte] in the file, by channel
  std::uint64_t message_index_length = 0;                  ///< [byte] of all of them
  std::string compression;
  std::uint64_t compressed_size = 0, uncompressed_size = 0;  ///< [byte]
};
struct Attachment {
  std::uint64_t log_time = 0, create_time = 0;  ///< [ns]
  std::string name, media_type, data;
};
struct AttachmentIndex {
  std::uint64_t offset = 0, length = 0;  ///< [byte] of its record in the file
  std::uint64_t log_time = 0, create_time = 0, data_size = 0;
  std::string name, media_type;
};
struct Metadata {
  std::string name;
  TextMap values;
};
struct MetadataIndex {
  std::uint64_t offset = 0, length = 0;  ///< [byte] of its record in the file
  std::string name;
};
struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0, attachment_count = 0, metadata_count = 0, chunk_count = 0;
  std::uint64_t start_time = 0, end_time = 0;  ///< [ns] of all messages
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};
struct SummaryOffset {
  Opcode group{};
  std::uint64_t start = 0, length = 0;  ///< [byte] in the file
};
struct DataEnd {
  std::uint32_t data_crc = 0;  ///< of everything before its record; 0: none
};

// Append a whole record to `bytes`.
void append_record(std::string& bytes, const Header& record);
void append_record(std::string& bytes, const Footer& record);
void append_record(std::string& bytes, const Schema& record);
void append_record(std::string& bytes, const Channel& record);
void append_record(std::string& bytes, const Message& record);
void append_record(std::string& bytes, const Chunk& record);
void append_record(std::string& bytes, const MessageIndex& record);
void append_record(std::string& bytes, const ChunkIndex& record);
void append_record(std::string& bytes, const Attachment& record);
void append_record(std::string& bytes, const AttachmentIndex& record);
void append_record(std::string& bytes, const Metadata& record);
void append_record(std::string& bytes, const MetadataIndex& record);
void append_record(std::string& bytes, const Statistics& record);
void append_record(std::string& bytes, const SummaryOffset& record);
void append_record(std::string& bytes, const DataEnd& record);

/// Parses the content of a record (without its head) as T, one of the types that readers need. Throws SetupError if it ends too early,
/// or its checksum does not fit.
template <class T>
[[nodiscard]] T parse_record(std::string_view content);
template <>
Header parse_record(std::string_view content);
template <>
Footer parse_record(std::string_view content);
template <>
Schema parse_record(std::string_view content);
template <>
Channel parse_record(std::string_view content);
template <>
Message parse_record(std::string_view content);
template <>
Chunk parse_record(std::string_view content);
template <>
ChunkIndex parse_record(std::string_view content);
template <>
Attachment parse_record(std::string_view content);
template <>
AttachmentIndex parse_record(std::string_view content);
template <>
Metadata parse_record(std::string_view content);
template <>
MetadataIndex parse_record(std::string_view content);
template <>
Statistics parse_record(std::string_view content);

}  // namespace murosimf::recording
