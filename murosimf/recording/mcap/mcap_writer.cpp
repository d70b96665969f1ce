#include "murosimf/recording/mcap/mcap_writer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/compression.h"
#include "murosimf/recording/mcap/crc32.h"

namespace murosimf::recording {
namespace {

/// The next id of a kind of records.
std::uint16_t next_id(std::size_t count, std::string_view what) {
  if (count >= std::numeric_limits<std::uint16_t>::max()) {
    throw SetupError(fmt::format("a recording has room for {} {}", std::numeric_limits<std::uint16_t>::max(), what));
  }
  return static_cast<std::uint16_t>(count + 1);
}

/// Adds the records of one kind to a summary that begins at `start` in the file, and their place to `offsets`.
template <class Record>
void append_group(std::string& summary, std::uint64_t start, const std::vector<Record>& records, Opcode opcode,
                  std::string& offsets) {
  if (records.empty()) return;
  const std::size_t begin = summary.size();
  for (const Record& record : records) append_record(summary, record);
  append_record(offsets, SummaryOffset{.group = opcode, .start = start + begin, .length = summary.size() - begin});
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& file, McapOptions options)
    : options_(std::move(options)), file_(file) {
  std::string bytes(mcap_magic);
  append_record(bytes, Header{.profile = options_.profile, .library = options_.library});
  file_.append(bytes);
}

template <class Record>
void McapWriter::append(const Record& record) {
  std::string bytes;
  append_record(bytes, record);
  file_.append(bytes);
}

std::uint16_t McapWriter::add_schema(const std::string& name, const std::string& encoding, std::string data) {
  const std::uint16_t id = next_id(schemas_.size(), "schemas");
  schemas_.push_back({.id = id, .name = name, .encoding = encoding, .data = std::move(data)});
  append(schemas_.back());
  ++statistics_.schema_count;
  return id;
}

std::uint16_t McapWriter::add_channel(const std::string& topic, const std::string& encoding, std::uint16_t schema,
                                      TextMap metadata) {
  MUROSIMF_ASSERT(schema <= schemas_.size());
  const std::uint16_t id = next_id(channels_.size(), "channels");
  channels_.push_back(
      {.id = id, .schema_id = schema, .topic = topic, .message_encoding = encoding, .metadata = std::move(metadata)});
  append(channels_.back());
  sequences_.push_back(0);
  indexes_.push_back({.channel_id = id, .entries = {}});
  ++statistics_.channel_count;
  MUROSIMF_ASSERT(sequences_.size() == channels_.size() && indexes_.size() == channels_.size());
  return id;
}

/// A chunk ends when it is long or late: readers find instants by chunks.
void McapWriter::write(std::uint16_t channel, Duration time, std::string_view data) {
  MUROSIMF_ASSERT(channel >= 1 && channel <= channels_.size());
  const auto log_time = static_cast<std::uint64_t>(std::max(time, Duration{}).count());
  const auto span = static_cast<std::uint64_t>(options_.chunk_span.count());
  if (!records_.empty() && (records_.size() >= options_.chunk_bytes || log_time >= start_time_ + span)) flush();
  if (records_.empty()) start_time_ = end_time_ = log_time;
  start_time_ = std::min(start_time_, log_time);
  end_time_ = std::max(end_time_, log_time);
  indexes_[channel - 1U].entries.push_back({.log_time = log_time, .offset = records_.size()});
  append_record(records_, Message{.channel_id = channel,
                                  .sequence = sequences_[channel - 1U]++,
                                  .log_time = log_time,
                                  .publish_time = log_time,
                                  .data = data});
  if (statistics_.message_count++ == 0) statistics_.start_time = log_time;
  statistics_.start_time = std::min(statistics_.start_time, log_time);
  statistics_.end_time = std::max(statistics_.end_time, log_time);
  ++statistics_.channel_message_counts[channel];
}

/// The CRC is that of the uncompressed records, so that it covers the compression, too.
void McapWriter::flush() {
  if (records_.empty()) return;
  MUROSIMF_ASSERT(start_time_ <= end_time_);
  const bool compressed = options_.compressed && !usual_compression().empty();
  const std::string packed = compressed ? compress(records_) : std::string{};
  const Chunk chunk{.start_time = start_time_,
                    .end_time = end_time_,
                    .uncompressed_size = records_.size(),
                    .uncompressed_crc = crc32(records_),
                    .compression = std::string(compressed ? usual_compression() : std::string_view{}),
                    .records = compressed ? packed : records_};
  std::string bytes;
  append_record(bytes, chunk);
  ChunkIndex index{.start_time = start_time_,
                   .end_time = end_time_,
                   .offset = file_.size(),
                   .length = bytes.size(),
                   .message_indexes = {},
                   .message_index_length = 0,
                   .compression = chunk.compression,
                   .compressed_size = chunk.records.size(),
                   .uncompressed_size = chunk.uncompressed_size};
  for (MessageIndex& one : indexes_) {
    if (one.entries.empty()) continue;
    index.message_indexes[one.channel_id] = file_.size() + bytes.size();
    append_record(bytes, one);
    one.entries.clear();
  }
  index.message_index_length = bytes.size() - index.length;
  records_.clear();
  file_.append(bytes);
  chunks_.push_back(std::move(index));
  ++statistics_.chunk_count;
}

void McapWriter::sync() { file_.sync(); }

void McapWriter::attach(const Attachment& attachment) {
  flush();
  // after flush(): attachments stand between chunks, never inside
  const std::uint64_t offset = file_.size();
  append(attachment);
  attachments_.push_back({.offset = offset,
                          .length = file_.size() - offset,
                          .log_time = attachment.log_time,
                          .create_time = attachment.create_time,
                          .data_size = attachment.data.size(),
                          .name = attachment.name,
                          .media_type = attachment.media_type});
  ++statistics_.attachment_count;
}

/// Metadata is not part of chunks: what was collected is written first, so that the order stays.
void McapWriter::add(const Metadata& metadata) {
  flush();
  const std::uint64_t offset = file_.size();
  append(metadata);
  metadata_.push_back({.offset = offset, .length = file_.size() - offset, .name = metadata.name});
  ++statistics_.metadata_count;
}

std::string McapWriter::summary(std::uint64_t start, std::uint64_t& offset_start) const {
  std::string bytes, offsets;
  append_group(bytes, start, schemas_, Opcode::schema, offsets);
  append_group(bytes, start, channels_, Opcode::channel, offsets);
  append_group(bytes, start, std::vector{statistics_}, Opcode::statistics, offsets);
  append_group(bytes, start, chunks_, Opcode::chunk_index, offsets);
  append_group(bytes, start, attachments_, Opcode::attachment_index, offsets);
  append_group(bytes, start, metadata_, Opcode::metadata_index, offsets);
  offset_start = start + bytes.size();
  return bytes + offsets;
}

void McapWriter::close() {
  flush();
  append(DataEnd{.data_crc = file_.crc()});
  Footer footer{.summary_start = file_.size(), .summary_offset_start = 0, .summary_crc = 0};
  std::string bytes = summary(footer.summary_start, footer.summary_offset_start);
  std::string end;
  append_record(end, footer);
  // the checksum of the summary covers the footer up to the checksum itself
  end.resize(end.size() - sizeof(footer.summary_crc));
  footer.summary_crc = crc32(end, crc32(bytes));
  append_record(bytes, footer);
  bytes.append(mcap_magic);
  file_.append(bytes);
  file_.finish();
}

}  // namespace murosimf::recording
