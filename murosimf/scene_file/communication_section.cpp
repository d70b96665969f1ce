// [communication] of a scene file: messages between the robots of a team; and [robots.link], the same of a robot and its software.
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

constexpr double longest_delay = 60;                  // [s]
constexpr std::uint64_t most_message_bytes = 65'507;  // of a UDP datagram
constexpr std::uint64_t most_messages = 1'000;        // [1/s]

void read_message_bytes(const files::TomlTable& table, std::string_view key, control_software::RadioOptions& radio) {
  table.read(key, radio.message_bytes);
  require(radio.message_bytes <= most_message_bytes, table, key, "must be up to 65507");
}

void read_messages_per_second(const files::TomlTable& table, std::string_view key,
                              control_software::RadioOptions& radio) {
  table.read(key, radio.messages_per_second);
  require(radio.messages_per_second <= most_messages, table, key, "must be up to 1000");
}

template <class Options>
void read_bandwidth(const files::TomlTable& table, std::string_view key, Options& options) {
  table.read(key, options.bandwidth);
  require(options.bandwidth == 0 || (options.bandwidth >= 1 && options.bandwidth <= 1e12), table, key,
          "must be from 1 to 1e12 bytes in a second, or 0: any");
}

}  // namespace

const Section<control_software::RadioOptions>& communication_section() {
  using Options = control_software::RadioOptions;
  static const Section<Options> section(
      "[communication]",
      {{"range", &Options::range, "m", "between two robots of a team that hear each other; 0: any",
        between(0, farthest_place)},
       {"bandwidth", read_bandwidth<Options>, "byte/s", "of the channel that a team's robots share; 0: any", {}, "0"},
       {"delay", &Options::delay, "s", "on the way from one robot to another", between(0, longest_delay)},
       {"jitter", &Options::jitter, "s", "that it is longer, by chance, up to this", between(0, longest_delay)},
       {"loss", &Options::loss, "", "share of the messages that do not arrive", between(0, 1)},
       {"message_bytes", read_message_bytes, "byte", "of the longest message", {}, "1400"},
       {"messages_per_second", read_messages_per_second, "", "that a robot may send", {}, "20"}});
  return section;
}

const Section<control_software::ControlLinkOptions>& link_section() {
  using Options = control_software::ControlLinkOptions;
  static const Section<Options> section(
      "[robots.link]",
      {{"delay", &Options::delay, "s", "on the way", between(0, longest_delay)},
       {"jitter", &Options::jitter, "s", "that it is longer, by chance, up to this", between(0, longest_delay)},
       {"bandwidth", read_bandwidth<Options>, "byte/s", "of each way, 8 bytes for a number; 0: any", {}, "0"},
       {"loss", &Options::loss, "", "share of the cycles whose numbers do not arrive", between(0, 1)},
       {"signals", &Options::signals, "", "whether what the robot measures takes it"},
       {"commands", &Options::commands, "", "whether its commands take it"}});
  return section;
}

void read_communication(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("communication")) communication_section().read(*node, spec.communication);
}

}  // namespace murosimf::scene_file
