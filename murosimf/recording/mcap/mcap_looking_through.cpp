// What McapReader does without a summary: from record to record, as far as these are whole.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

void McapReader::note_damage(const std::string& damage) {
  if (contents_.damage.empty()) contents_.damage = damage;
}

void McapReader::look_through() {
  std::uint64_t offset = mcap_magic.size();
  while (offset < size_) {
    Record record;
    try {
      record = record_at(offset);
    } catch (const SetupError&) {
      return note_damage(fmt::format("it ends in the middle of a record that begins at byte {}", offset));
    }
    try {
      if (!take_record(record, offset)) return;
    } catch (const SetupError& error) {
      note_damage(fmt::format("byte {}: {}", offset, error.what()));
    }
    offset += record.length;
  }
}

/// Whether more may follow.
bool McapReader::take_record(const Record& record, std::uint64_t offset) {
  Statistics& sums = contents_.statistics;
  switch (record.opcode) {
    case Opcode::data_end: return false;
    case Opcode::chunk: take_chunk(offset, record.length); return true;
    case Opcode::message: throw SetupError("a message stands outside of a chunk, where this program does not look");
    case Opcode::attachment: {
      AttachmentIndex index{.offset = offset,
                            .length = record.length,
                            .log_time = 0,
                            .create_time = 0,
                            .data_size = 0,
                            .name = {},
                            .media_type = {}};
      const Attachment found = attachment(index);
      index.log_time = found.log_time;
      index.create_time = found.create_time;
      index.data_size = found.data.size();
      index.name = found.name;
      index.media_type = found.media_type;
      contents_.attachments.push_back(std::move(index));
      ++sums.attachment_count;
      return true;
    }
    case Opcode::metadata: {
      MetadataIndex index{.offset = offset, .length = record.length, .name = {}};
      index.name = metadata(index).name;
      contents_.metadata.push_back(std::move(index));
      ++sums.metadata_count;
      return true;
    }
    case Opcode::schema:
    case Opcode::channel:
      take_chunk_record(record.opcode, bytes_at(offset + record_head, record.length - record_head));
      return true;
    default: return true;
  }
}

void McapReader::take_chunk(std::uint64_t offset, std::uint64_t length) {
  const std::string content = bytes_at(offset + record_head, length - record_head);
  const auto chunk = parse_record<Chunk>(content);
  ChunkIndex index{.start_time = chunk.start_time,
                   .end_time = chunk.end_time,
                   .offset = offset,
                   .length = length,
                   .message_indexes = {},
                   .message_index_length = 0,
                   .compression = chunk.compression,
                   .compressed_size = chunk.records.size(),
                   .uncompressed_size = chunk.uncompressed_size};
  const std::string records = records_of(index);
  const Statistics before = contents_.statistics;
  try {
    visit_records(records, [this](Opcode opcode, std::string_view one) { take_chunk_record(opcode, one); });
  } catch (const SetupError&) {
    contents_.statistics = before;
    throw;
  }
  contents_.chunks.push_back(std::move(index));
  ++contents_.statistics.chunk_count;
}

void McapReader::take_chunk_record(Opcode opcode, std::string_view content) {
  Statistics& sums = contents_.statistics;
  if (opcode == Opcode::schema || opcode == Opcode::channel) {
    take_summary_record(opcode, content);
    sums.schema_count = static_cast<std::uint16_t>(contents_.schemas.size());
    sums.channel_count = static_cast<std::uint32_t>(contents_.channels.size());
  } else if (opcode == Opcode::message) {
    const auto message = parse_record<Message>(content);
    check_channel(message);
    if (sums.message_count++ == 0) sums.start_time = message.log_time;
    sums.start_time = std::min(sums.start_time, message.log_time);
    sums.end_time = std::max(sums.end_time, message.log_time);
    ++sums.channel_message_counts[message.channel_id];
  }
}

}  // namespace murosimf::recording
