#include "murosimf/recording/mcap/mcap_records.h"

#include "murosimf/math/assert.h"
#include "murosimf/recording/mcap/byte_string.h"
#include "murosimf/recording/mcap/crc32.h"

namespace murosimf::recording {
namespace {

/// Writes the head of a record, and fills in its length when the content is complete.
class RecordWriter : public ByteWriter {
 public:
  RecordWriter(std::string& bytes, Opcode opcode) : ByteWriter(bytes), bytes_(bytes), begin_(bytes.size()) {
    number(static_cast<std::uint8_t>(opcode));
    number(std::uint64_t{0});
  }
  ~RecordWriter() {
    MUROSIMF_ASSERT(bytes_.size() >= begin_ + record_head);
    const std::uint64_t length = bytes_.size() - begin_ - record_head;
    for (std::size_t i = 0; i < 8; ++i) bytes_[begin_ + 1 + i] = static_cast<char>(length >> (8 * i) & 0xff);
  }
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  void map(const TextMap& map) {
    std::string entries;
    ByteWriter writer(entries);
    for (const auto& [key, value] : map) {
      writer.text(key);
      writer.text(value);
    }
    text(entries);
  }
  void map(const std::map<std::uint16_t, std::uint64_t>& map) {
    number(static_cast<std::uint32_t>(10 * map.size()));  // [byte] a number of 2 bytes and one of 8
    for (const auto& [key, value] : map) {
      number(key);
      number(value);
    }
  }
  [[nodiscard]] std::string_view content() const { return std::string_view(bytes_).substr(begin_ + record_head); }

 private:
  std::string& bytes_;
  std::size_t begin_;
};

}  // namespace

void append_record(std::string& bytes, const Header& record) {
  RecordWriter out(bytes, Opcode::header);
  out.text(record.profile);
  out.text(record.library);
}

void append_record(std::string& bytes, const Footer& record) {
  RecordWriter out(bytes, Opcode::footer);
  out.number(record.summary_start);
  out.number(record.summary_offset_start);
  out.number(record.summary_crc);
}

void append_record(std::string& bytes, const Schema& record) {
  RecordWriter out(bytes, Opcode::schema);
  out.number(record.id);
  out.text(record.name);
  out.text(record.encoding);
  out.text(record.data);
}

void append_record(std::string& bytes, const Channel& record) {
  RecordWriter out(bytes, Opcode::channel);
  out.number(record.id);
  out.number(record.schema_id);
  out.text(record.topic);
  out.text(record.message_encoding);
  out.map(record.metadata);
}

void append_record(std::string& bytes, const Message& record) {
  RecordWriter out(bytes, Opcode::message);
  out.number(record.channel_id);
  out.number(record.sequence);
  out.number(record.log_time);
  out.number(record.publish_time);
  out.raw(record.data);
}

void append_record(std::string& bytes, const Chunk& record) {
  RecordWriter out(bytes, Opcode::chunk);
  out.number(record.start_time);
  out.number(record.end_time);
  out.number(record.uncompressed_size);
  out.number(record.uncompressed_crc);
  out.text(record.compression);
  out.number(std::uint64_t{record.records.size()});
  out.raw(record.records);
}

void append_record(std::string& bytes, const MessageIndex& record) {
  RecordWriter out(bytes, Opcode::message_index);
  out.number(record.channel_id);
  out.number(static_cast<std::uint32_t>(16 * record.entries.size()));  // [byte] two numbers of 8 bytes each
  for (const MessageIndex::Entry& entry : record.entries) {
    out.number(entry.log_time);
    out.number(entry.offset);
  }
}

void append_record(std::string& bytes, const ChunkIndex& record) {
  RecordWriter out(bytes, Opcode::chunk_index);
  out.number(record.start_time);
  out.number(record.end_time);
  out.number(record.offset);
  out.number(record.length);
  out.map(record.message_indexes);
  out.number(record.message_index_length);
  out.text(record.compression);
  out.number(record.compressed_size);
  out.number(record.uncompressed_size);
}

void append_record(std::string& bytes, const Attachment& record) {
  RecordWriter out(bytes, Opcode::attachment);
  out.number(record.log_time);
  out.number(record.create_time);
  out.text(record.name);
  out.text(record.media_type);
  out.number(std::uint64_t{record.data.size()});
  out.raw(record.data);
  out.number(crc32(out.content()));
}

void append_record(std::string& bytes, const AttachmentIndex& record) {
  RecordWriter out(bytes, Opcode::attachment_index);
  out.number(record.offset);
  out.number(record.length);
  out.number(record.log_time);
  out.number(record.create_time);
  out.number(record.data_size);
  out.text(record.name);
  out.text(record.media_type);
}

void append_record(std::string& bytes, const Metadata& record) {
  RecordWriter out(bytes, Opcode::metadata);
  out.text(record.name);
  out.map(record.values);
}

void append_record(std::string& bytes, const MetadataIndex& record) {
  RecordWriter out(bytes, Opcode::metadata_index);
  out.number(record.offset);
  out.number(record.length);
  out.text(record.name);
}

void append_record(std::string& bytes, const Statistics& record) {
  RecordWriter out(bytes, Opcode::statistics);
  out.number(record.message_count);
  out.number(record.schema_count);
  out.number(record.channel_count);
  out.number(record.attachment_count);
  out.number(record.metadata_count);
  out.number(record.chunk_count);
  out.number(record.start_time);
  out.number(record.end_time);
  out.map(record.channel_message_counts);
}

void append_record(std::string& bytes, const SummaryOffset& record) {
  RecordWriter out(bytes, Opcode::summary_offset);
  out.number(static_cast<std::uint8_t>(record.group));
  out.number(record.start);
  out.number(record.length);
}

void append_record(std::string& bytes, const DataEnd& record) {
  RecordWriter out(bytes, Opcode::data_end);
  out.number(record.data_crc);
}

}  // namespace murosimf::recording
