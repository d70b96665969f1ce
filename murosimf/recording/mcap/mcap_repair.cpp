#include "murosimf/recording/mcap/mcap_repair.h"

#include <unistd.h>

#include <map>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/leftovers.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"

namespace murosimf::recording {
namespace {

using NewIds = std::map<std::uint16_t, std::uint16_t>;

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

}  // namespace

RepairReport repair(const std::filesystem::path& damaged, const std::filesystem::path& whole) {
  const McapReader in(damaged, McapReading::through_all);
  files::check_writable(whole);
  const std::filesystem::path part = whole.string() + fmt::format(".{}.part", ::getpid());
  const files::Leftover half_file(part);
  std::error_code error;
  try {
    McapWriter out(part, {.library = in.contents().header.library});
    copy(in, out);
    out.close();
    out.sync();
    std::filesystem::rename(part, whole, error);
    if (error) throw SetupError(fmt::format("cannot write '{}': {}", whole.string(), error.message()));
    return {.damage = in.contents().damage,
            .messages = out.statistics().message_count,
            .last_time = seconds(Duration(out.statistics().end_time))};
  } catch (...) {
    std::filesystem::remove(part, error);
    throw;
  }
}

}  // namespace murosimf::recording
