// McapReader without a summary: reads from record to record, as far as these are complete.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

void McapReader::note_damage(const std::string& damage) {
  if (contents_.damage.empty()) contents_.damage = damage;
}

void McapReader::note_other_run(std::uint64_t offset, const std::string& how) {
  if (contents_.other_run.empty()) contents_.other_run = fmt::format("it holds two runs: at byte {} {}", offset, how);
}

/// Position of the next magic bytes; the size of the file if there are none.
std::uint64_t McapReader::find_magic(std::uint64_t offset) const {
  constexpr std::uint64_t block = 1 << 20;
  for (; offset < size_; offset += block) {
    const std::string bytes = bytes_at(offset, std::min(block + mcap_magic.size(), size_ - offset));
    const auto place = bytes.find(mcap_magic);
    if (place != std::string::npos) return offset + place;
  }
  return size_;
}

/// A file begins and ends with these bytes; if another run has written over it, or after it, they also appear in the middle. In the
/// records themselves, which are compressed or text, they do not occur.
void McapReader::look_for_other_run() {
  const std::uint64_t middle = find_magic(mcap_magic.size());
  if (middle + mcap_magic.size() >= size_) return;
  note_other_run(middle, find_magic(middle + mcap_magic.size()) == middle + mcap_magic.size()
                             ? "the first has its end, and another one begins"
                             : "one of them ends, and the file goes on");
}

/// Whether a record that a run writes only once is repeated: the attachment or metadata of this `name`.
template <class Index>
bool McapReader::is_again(const std::vector<Index>& known, const std::string& found, const char* name,
                          std::uint64_t offset) {
  if (found != name || std::ranges::find(known, found, &Index::name) == known.end()) return false;
  note_other_run(offset, fmt::format("'{}' comes again, which says how a run was begun", found));
  return true;
}

/// Two channels of the same number are a sign of two files in one.
bool McapReader::is_other_channel(std::string_view content, std::uint64_t offset) {
  const auto channel = parse_record<Channel>(content);
  const auto known = std::ranges::find(contents_.channels, channel.id, &Channel::id);
  if (known == contents_.channels.end() || known->topic == channel.topic) return false;
  note_other_run(offset, fmt::format("the channel of '{}' becomes one of '{}'", known->topic, channel.topic));
  return true;
}

/// In files of this program time never goes back.
bool McapReader::is_before_last(const Chunk& chunk, std::uint64_t offset) {
  constexpr std::uint64_t second = 1'000'000'000;
  const bool is_ours = contents_.header.library.starts_with("murosimf");
  if (!is_ours || contents_.chunks.empty() || chunk.start_time + second > contents_.chunks.back().start_time)
    return false;
  note_other_run(offset, "time goes back");
  return true;
}

/// For files without an end: record by record from the start, as far as they are whole.
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

/// Returns whether more records of this run may follow.
bool McapReader::take_record(const Record& record, std::uint64_t offset) {
  Statistics& sums = contents_.statistics;
  switch (record.opcode) {
    case Opcode::data_end: return false;
    case Opcode::chunk: return take_chunk(offset, record.length);
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
      if (is_again(contents_.attachments, found.name, "run.json", offset)) return false;
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
      if (is_again(contents_.metadata, index.name, "murosimf", offset)) return false;
      contents_.metadata.push_back(std::move(index));
      ++sums.metadata_count;
      return true;
    }
    case Opcode::schema:
    case Opcode::channel: {
      const std::string content = bytes_at(offset + record_head, record.length - record_head);
      if (record.opcode == Opcode::channel && is_other_channel(content, offset)) return false;
      take_chunk_record(record.opcode, content);
      return true;
    }
    case Opcode::header:
      if (offset > mcap_magic.size()) note_other_run(offset, "another one begins");
      return offset == mcap_magic.size();
    default: return true;
  }
}

/// Returns whether it belongs to this run.
bool McapReader::take_chunk(std::uint64_t offset, std::uint64_t length) {
  const std::string content = bytes_at(offset + record_head, length - record_head);
  const auto chunk = parse_record<Chunk>(content);
  if (is_before_last(chunk, offset)) return false;
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
  return true;
}

/// Schemas and channels may stand in chunks only.
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
