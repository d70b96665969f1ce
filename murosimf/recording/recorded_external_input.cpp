#include "murosimf/recording/recorded_external_input.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/topics.h"

namespace murosimf::recording {

void put_outside(std::string& bytes, const std::string& channel, const ExternalInput& note) {
  ProtobufWriter out(bytes);
  // times before the run are negative, which messages cannot have: field 3 keeps the exact time
  put_time(out, 1, std::max(note.time, Duration{}));
  out.text(2, channel);
  out.varint(3, static_cast<std::uint64_t>(note.time.count()));
  out.varint(4, note.kind);
  out.text(5, note.bytes);
}

std::shared_ptr<const ExternalInputLog> recorded_external_input(const McapReader& file) {
  auto notes = std::make_shared<ExternalInputLog>();
  visit_topics(file, {"/outside"}, [&](const std::string&, const Message& message, std::size_t) {
    std::string channel;
    ExternalInput note;
    for (ProtobufReader in(message.data); in.next();) {
      if (in.field() == 2) channel = in.bytes();
      if (in.field() == 3) note.time = Duration(static_cast<Duration::rep>(in.varint()));
      if (in.field() == 4) note.kind = static_cast<ExternalInput::Kind>(in.varint());
      if (in.field() == 5) note.bytes = in.bytes();
    }
    notes->channel(channel).push_back(std::move(note));
  });
  for (const std::string& name : notes->names()) {  // lasting input may be written later (Recorder)
    std::ranges::stable_sort(notes->channel(name), {}, &ExternalInput::time);
  }
  return notes;
}

}  // namespace murosimf::recording
