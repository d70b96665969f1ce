// Parses contents of records (mcap_records.h).
#include "murosimf/recording/mcap/byte_string.h"
#include "murosimf/recording/mcap/crc32.h"
#include "murosimf/recording/mcap/mcap_records.h"

namespace murosimf::recording {
namespace {

/// Size in bytes first, then pairs.
TextMap read_text_map(ByteReader& reader) {
  TextMap map;
  ByteReader entries(reader.raw(reader.number<std::uint32_t>()));
  while (!entries.left().empty()) {
    std::string key = entries.text();
    map[std::move(key)] = entries.text();
  }
  return map;
}

std::map<std::uint16_t, std::uint64_t> read_number_map(ByteReader& reader) {
  std::map<std::uint16_t, std::uint64_t> map;
  ByteReader entries(reader.raw(reader.number<std::uint32_t>()));
  while (!entries.left().empty()) {
    const auto key = entries.number<std::uint16_t>();
    map[key] = entries.number<std::uint64_t>();
  }
  return map;
}

}  // namespace

// Braced initializers are evaluated from left to right: the order of members is that of the bytes.

template <>
Header parse_record(std::string_view content) {
  ByteReader in(content);
  return {.profile = in.text(), .library = in.text()};
}

template <>
Footer parse_record(std::string_view content) {
  ByteReader in(content);
  return {.summary_start = in.number<std::uint64_t>(),
          .summary_offset_start = in.number<std::uint64_t>(),
          .summary_crc = in.number<std::uint32_t>()};
}

template <>
Schema parse_record(std::string_view content) {
  ByteReader in(content);
  return {.id = in.number<std::uint16_t>(), .name = in.text(), .encoding = in.text(), .data = in.text()};
}

template <>
Channel parse_record(std::string_view content) {
  ByteReader in(content);
  return {.id = in.number<std::uint16_t>(),
          .schema_id = in.number<std::uint16_t>(),
          .topic = in.text(),
          .message_encoding = in.text(),
          .metadata = read_text_map(in)};
}

template <>
Message parse_record(std::string_view content) {
  ByteReader in(content);
  Message message{.channel_id = in.number<std::uint16_t>(),
                  .sequence = in.number<std::uint32_t>(),
                  .log_time = in.number<std::uint64_t>(),
                  .publish_time = in.number<std::uint64_t>(),
                  .data = {}};
  message.data = in.left();
  return message;
}

template <>
Chunk parse_record(std::string_view content) {
  ByteReader in(content);
  Chunk chunk{.start_time = in.number<std::uint64_t>(),
              .end_time = in.number<std::uint64_t>(),
              .uncompressed_size = in.number<std::uint64_t>(),
              .uncompressed_crc = in.number<std::uint32_t>(),
              .compression = in.text(),
              .records = {}};
  chunk.records = in.raw(in.number<std::uint64_t>());
  return chunk;
}

template <>
ChunkIndex parse_record(std::string_view content) {
  ByteReader in(content);
  return {.start_time = in.number<std::uint64_t>(),
          .end_time = in.number<std::uint64_t>(),
          .offset = in.number<std::uint64_t>(),
          .length = in.number<std::uint64_t>(),
          .message_indexes = read_number_map(in),
          .message_index_length = in.number<std::uint64_t>(),
          .compression = in.text(),
          .compressed_size = in.number<std::uint64_t>(),
          .uncompressed_size = in.number<std::uint64_t>()};
}

template <>
Attachment parse_record(std::string_view content) {
  ByteReader in(content);
  Attachment attachment{.log_time = in.number<std::uint64_t>(),
                        .create_time = in.number<std::uint64_t>(),
                        .name = in.text(),
                        .media_type = in.text(),
                        .data = {}};
  attachment.data = in.raw(in.number<std::uint64_t>());
  const std::string_view checked = content.substr(0, content.size() - in.left().size());
  const auto crc = in.number<std::uint32_t>();
  if (crc != 0 && crc != crc32(checked)) throw SetupError("the checksum of an attachment does not fit");
  return attachment;
}

template <>
AttachmentIndex parse_record(std::string_view content) {
  ByteReader in(content);
  return {.offset = in.number<std::uint64_t>(),
          .length = in.number<std::uint64_t>(),
          .log_time = in.number<std::uint64_t>(),
          .create_time = in.number<std::uint64_t>(),
          .data_size = in.number<std::uint64_t>(),
          .name = in.text(),
          .media_type = in.text()};
}

template <>
Metadata parse_record(std::string_view content) {
  ByteReader in(content);
  return {.name = in.text(), .values = read_text_map(in)};
}

template <>
MetadataIndex parse_record(std::string_view content) {
  ByteReader in(content);
  return {.offset = in.number<std::uint64_t>(), .length = in.number<std::uint64_t>(), .name = in.text()};
}

template <>
Statistics parse_record(std::string_view content) {
  ByteReader in(content);
  return {.message_count = in.number<std::uint64_t>(),
          .schema_count = in.number<std::uint16_t>(),
          .channel_count = in.number<std::uint32_t>(),
          .attachment_count = in.number<std::uint32_t>(),
          .metadata_count = in.number<std::uint32_t>(),
          .chunk_count = in.number<std::uint32_t>(),
          .start_time = in.number<std::uint64_t>(),
          .end_time = in.number<std::uint64_t>(),
          .channel_message_counts = read_number_map(in)};
}

}  // namespace murosimf::recording
