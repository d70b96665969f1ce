#include "murosimf/recording/topics.h"

#include "murosimf/recording/mcap/protobuf.h"

namespace murosimf::recording {

std::map<std::uint16_t, std::string> channels_of(const McapReader& file, const std::set<std::string>& topics) {
  std::map<std::uint16_t, std::string> found;
  for (const Channel& channel : file.contents().channels) {
    if (topics.contains(channel.topic)) found[channel.id] = channel.topic;
  }
  return found;
}

std::string text_of_log(std::string_view data) {
  std::string text;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 3) text = in.bytes();
  }
  return text;
}

}  // namespace murosimf::recording
