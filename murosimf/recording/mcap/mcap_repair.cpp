#include "murosimf/recording/mcap/mcap_repair.h"

#include <map>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"

namespace murosimf::recording {
namespace {

using NewIds = std::map<std::uint16_t, std::uint16_t>;

/// Channels get new numbers: those of a damaged file may have gaps.
NewIds copy_channels(const McapContents& contents, McapWriter& out) {
  NewIds schemas{{0, 0}}, channels;
  for (const Schema& schema : contents.schemas) {
    schemas[schema.id] = out.add_schema(schema.name, schema.encoding, schema.data);
  }
  for (const Channel& channel : contents.channels) {
    channels[channel.id] =
        out.add_channel(channel.topic, channel.message_encoding, schemas[channel.schema_id], channel.metadata);
  }
  return channels;
}

void copy(const McapReader& in, McapWriter& out) {
  const McapContents& contents = in.contents();
  NewIds channels = copy_channels(contents, out);
  for (const MetadataIndex& index : contents.metadata) out.add(in.metadata(index));
  for (const AttachmentIndex& index : contents.attachments) out.attach(in.attachment(index));
  for (const ChunkIndex& chunk : contents.chunks) {
    in.visit_messages(chunk, [&](const Message& message) {
      out.write(channels.at(message.channel_id), Duration(message.log_time), message.data);
    });
  }
}

/// Throws SetupError if the data of another run would be lost.
void check_one_run(const McapReader& in) {
  if (in.contents().other_run.empty()) return;
  throw SetupError(fmt::format("{}: {}; have the first one written to a file of its own (--out), nothing is changed",
                               in.file().string(), in.contents().other_run));
}

}  // namespace

/// Into a part file: if it fails, the damaged file is still there.
RepairReport repair(const std::filesystem::path& damaged, const std::filesystem::path& whole) {
  const McapReader in(damaged, McapReading::through_all);
  std::error_code error;
  const bool in_place = std::filesystem::equivalent(damaged, whole, error);
  if (in_place) check_one_run(in);
  files::PartFile part(whole);
  McapWriter out(part.path(), {.library = in.contents().header.library});
  out.begin();
  copy(in, out);
  out.close();
  part.commit(in_place ? files::PartFile::Replaces::input_too : files::PartFile::Replaces::no_input);
  return {.damage = in.contents().damage,
          .other_run = in.contents().other_run,
          .messages = out.statistics().message_count,
          .last_time = seconds(Duration(out.statistics().end_time))};
}

}  // namespace murosimf::recording
