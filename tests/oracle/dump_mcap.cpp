/// dump_mcap - writes an MCAP file, or says what is in one, for mcap_against_official.py.
///
///     dump_mcap write FILE SEED plain|compressed
///     dump_mcap read FILE
///
/// Both print one line of JSON for each schema, channel, attachment, metadata and message; data are hexadecimal.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"

namespace {

using namespace murosimf;
using namespace murosimf::recording;

std::string hexadecimal(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

std::string random_bytes(std::mt19937& random, std::size_t most) {
  std::string bytes(random() % (most + 1), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() % 7 == 0 ? random() : 'a');
  return bytes;
}

void write(const std::string& file, unsigned seed, bool compressed) {
  std::mt19937 random(seed);
  McapWriter out(file, {.library = "dump_mcap", .chunk_bytes = 1 + random() % 20000, .compressed = compressed});
  const auto schema = out.add_schema("Thing", "jsonschema", R"({"type": "object"})");
  out.add({.name = "run", .values = {{"seed", std::to_string(seed)}, {"", "empty key"}}});
  for (int i = 0; i < 3; ++i) {
    (void)out.add_channel(fmt::format("/topic{}", i), "json", i == 2 ? std::uint16_t{0} : schema,
                          {{"number", std::to_string(i)}});
  }
  Duration time{};
  const int messages = static_cast<int>(random() % 2000);
  for (int i = 0; i < messages; ++i) {
    time += Duration(random() % 20'000'000);
    out.write(static_cast<std::uint16_t>(1 + random() % 3), time, random_bytes(random, 300));
    if (i % 500 == 400) {
      out.attach({.log_time = static_cast<std::uint64_t>(time.count()),
                  .create_time = 5,
                  .name = fmt::format("file{}", i),
                  .media_type = "application/octet-stream",
                  .data = random_bytes(random, 5000)});
    }
  }
  out.close();
}

void read(const std::string& file) {
  const McapReader reader(file);
  const McapContents& contents = reader.contents();
  if (!contents.damage.empty()) throw SetupError(contents.damage);
  for (const Schema& one : contents.schemas) {
    fmt::print("[\"schema\", {}, \"{}\", \"{}\", \"{}\"]\n", one.id, one.name, one.encoding, hexadecimal(one.data));
  }
  for (const Channel& one : contents.channels) {
    fmt::print("[\"channel\", {}, {}, \"{}\", \"{}\", {}]\n", one.id, one.schema_id, one.topic, one.message_encoding,
               one.metadata.size());
  }
  for (const AttachmentIndex& index : contents.attachments) {
    const Attachment one = reader.attachment(index);
    fmt::print("[\"attachment\", {}, {}, \"{}\", \"{}\", \"{}\"]\n", one.log_time, one.create_time, one.name,
               one.media_type, hexadecimal(one.data));
  }
  for (const MetadataIndex& index : contents.metadata) {
    const Metadata one = reader.metadata(index);
    fmt::print("[\"metadata\", \"{}\", {}]\n", one.name, one.values.size());
  }
  for (const ChunkIndex& chunk : contents.chunks) {
    reader.visit_messages(chunk, [](const Message& one) {
      fmt::print("[\"message\", {}, {}, {}, \"{}\"]\n", one.channel_id, one.sequence, one.log_time,
                 hexadecimal(one.data));
    });
  }
}

}  // namespace

int main(int count, char** words) try {
  if (count == 5) write(words[2], static_cast<unsigned>(std::atoi(words[3])), std::string(words[4]) == "compressed");
  read(words[2]);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "dump_mcap: {}\n", error.what());
  return 1;
}
