#include "murosimf/recording/mcap/mcap_reader.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/byte_string.h"
#include "murosimf/recording/mcap/compression.h"
#include "murosimf/recording/mcap/crc32.h"

namespace murosimf::recording {
namespace {

constexpr std::uint64_t footer_bytes = record_head + 20;

/// Bounded before memory is set aside: the size comes from the file.
std::string unpack(const Chunk& chunk) {
  if (chunk.uncompressed_size > most_chunk_bytes) {
    throw SetupError(fmt::format("the chunk is too large: at most {} MB are read", most_chunk_bytes / 1'000'000));
  }
  std::string records = decompress(chunk.compression, chunk.records, chunk.uncompressed_size);
  if (chunk.uncompressed_crc != 0 && crc32(records) != chunk.uncompressed_crc) {
    throw SetupError("the checksum of the chunk does not fit");
  }
  return records;
}

/// Adds it, unless it is known: channels and schemas may be repeated in a file.
template <class T>
void add_once(std::vector<T>& known, T&& found) {
  const auto same = std::ranges::find(known, found.id, &T::id);
  if (same == known.end()) known.push_back(std::forward<T>(found));
}

}  // namespace

void visit_records(std::string_view bytes, const std::function<void(Opcode, std::string_view)>& visit) {
  ByteReader reader(bytes);
  while (!reader.left().empty()) {
    const auto opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
    const auto length = reader.number<std::uint64_t>();
    visit(opcode, reader.raw(length));
  }
}

McapReader::McapReader(const std::filesystem::path& file, McapReading reading) : file_(file) {
  size_ = files::check_input_file(file, std::numeric_limits<std::int64_t>::max());
  stream_.reset(std::fopen(file.c_str(), "rb"));
  with_context(file.string(), [&] {
    if (!stream_) throw SetupError("the file cannot be read");
    check_header();
    const bool whole = read_summary();
    if (whole && reading == McapReading::by_summary) return;
    contents_ = {.header = contents_.header,
                 .schemas = {},
                 .channels = {},
                 .chunks = {},
                 .attachments = {},
                 .metadata = {},
                 .statistics = {},
                 .damage = {},
                 .other_run = {}};
    look_through();
    look_for_other_run();
    if (!whole) note_damage("it has no summary at its end: it was cut off, or is still being written");
  });
}

std::string McapReader::bytes_at(std::uint64_t offset, std::uint64_t length) const {
  if (offset > size_ || length > size_ - offset) throw SetupError("the file ends too early");
  std::string bytes(length, '\0');
  // seek and read together: the stream has one position
  const std::lock_guard lock(reading_);
  const bool good = std::fseek(stream_.get(), static_cast<long>(offset), SEEK_SET) == 0 &&
                    std::fread(bytes.data(), 1, length, stream_.get()) == length;
  if (!good) throw SetupError("the file cannot be read to its end");
  return bytes;
}

/// The length is compared with the rest of the file before anything is read.
McapReader::Record McapReader::record_at(std::uint64_t offset) const {
  const std::string bytes = bytes_at(offset, record_head);
  ByteReader head(bytes);
  const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
  const auto length = head.number<std::uint64_t>();
  if (length > size_ - offset - record_head) throw SetupError("the file ends too early");
  return {.opcode = opcode, .length = record_head + length};
}

std::string McapReader::content_at(std::uint64_t offset, std::uint64_t length, Opcode opcode) const {
  const Record record = record_at(offset);
  if (record.opcode != opcode || record.length != length) throw SetupError("the index leads to another record");
  return bytes_at(offset + record_head, length - record_head);
}

template <class Call>
auto McapReader::at(std::uint64_t offset, const Call& call) const {
  return with_context(fmt::format("{}: byte {}", file_.string(), offset), call);
}

/// Magic bytes and header: other files are refused with a reason.
void McapReader::check_header() {
  if (size_ < mcap_magic.size() || bytes_at(0, mcap_magic.size()) != mcap_magic) {
    throw SetupError("this is no MCAP file: it does not begin as one");
  }
  const Record record = record_at(mcap_magic.size());
  if (record.opcode != Opcode::header) throw SetupError("this is no MCAP file: it has no header");
  const std::string content = bytes_at(mcap_magic.size() + record_head, record.length - record_head);
  contents_.header = parse_record<Header>(content);
}

/// Returns whether there is a valid one.
bool McapReader::read_summary() try {
  const std::uint64_t end_bytes = footer_bytes + mcap_magic.size();
  if (size_ < end_bytes + mcap_magic.size()) return false;
  const std::uint64_t footer_start = size_ - end_bytes;
  if (bytes_at(size_ - mcap_magic.size(), mcap_magic.size()) != mcap_magic) return false;
  const auto footer = parse_record<Footer>(content_at(footer_start, footer_bytes, Opcode::footer));
  if (footer.summary_start == 0 || footer.summary_start > footer_start) return false;
  const std::string bytes = bytes_at(footer.summary_start, footer_start - footer.summary_start);
  const std::string end = bytes_at(footer_start, footer_bytes - sizeof(footer.summary_crc));
  if (footer.summary_crc != 0 && crc32(end, crc32(bytes)) != footer.summary_crc) return false;
  visit_records(bytes, [this](Opcode opcode, std::string_view content) { take_summary_record(opcode, content); });
  // a valid summary may lack records that a reader needs
  return contents_.statistics.chunk_count == contents_.chunks.size() &&
         (contents_.statistics.message_count == 0 || !contents_.chunks.empty());
} catch (const SetupError&) {
  return false;
}

void McapReader::take_summary_record(Opcode opcode, std::string_view content) {
  switch (opcode) {
    case Opcode::schema: return add_once(contents_.schemas, parse_record<Schema>(content));
    case Opcode::channel: return add_once(contents_.channels, parse_record<Channel>(content));
    case Opcode::chunk_index: return contents_.chunks.push_back(parse_record<ChunkIndex>(content));
    case Opcode::attachment_index: return contents_.attachments.push_back(parse_record<AttachmentIndex>(content));
    case Opcode::metadata_index: return contents_.metadata.push_back(parse_record<MetadataIndex>(content));
    case Opcode::statistics: contents_.statistics = parse_record<Statistics>(content); return;
    default: return;  // reserved for later versions by the specification
  }
}

void McapReader::visit_messages(const ChunkIndex& chunk, const std::function<void(const Message&)>& visit) const {
  at(chunk.offset, [&] {
    const std::string records = records_of(chunk);
    std::vector<Message> messages;
    visit_records(records, [&](Opcode opcode, std::string_view content) {
      if (opcode == Opcode::message) messages.push_back(parse_record<Message>(content));
    });
    // stable: messages of one instant keep the order in which they were written
    std::ranges::stable_sort(messages, {}, &Message::log_time);
    for (const Message& message : messages) {
      check_channel(message);
      visit(message);
    }
  });
}

void McapReader::check_channel(const Message& message) const {
  if (std::ranges::find(contents_.channels, message.channel_id, &Channel::id) != contents_.channels.end()) return;
  throw SetupError(fmt::format("a message is of the channel {}, which there is not", message.channel_id));
}

std::string McapReader::records_of(const ChunkIndex& chunk) const {
  const std::string content = content_at(chunk.offset, chunk.length, Opcode::chunk);
  return unpack(parse_record<Chunk>(content));
}

Attachment McapReader::attachment(const AttachmentIndex& index) const {
  return at(index.offset,
            [&] { return parse_record<Attachment>(content_at(index.offset, index.length, Opcode::attachment)); });
}

Metadata McapReader::metadata(const MetadataIndex& index) const {
  return at(index.offset,
            [&] { return parse_record<Metadata>(content_at(index.offset, index.length, Opcode::metadata)); });
}

}  // namespace murosimf::recording
