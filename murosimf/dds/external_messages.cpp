#include "murosimf/dds/external_messages.h"

namespace murosimf::dds {

ExternalMessages::ExternalMessages(const std::string& channel, const ExternalInputOptions& outside,
                                   control_software::SayLine say, Lines lines)
    : say_(std::move(say)),
      lines_(std::move(lines)),
      notes_(outside.notes),
      pen_(outside.channel(channel)),
      repeated_(outside.repeated),
      reader_(repeated_ ? repeated_->find(channel) : nullptr),
      remembered_(outside.memory),
      memory_(remembered_ ? &remembered_->channel(channel) : nullptr) {}

/// The mark is the first byte of what is written down.
std::vector<ExternalInput> ExternalMessages::listen(Inbox* inbox) {
  std::vector<ExternalInput> heard;
  if (!inbox) return heard;
  const bool client = inbox->writers() > 0;
  if (client && !client_) heard.push_back({{}, ExternalInput::came});
  for (const Arrival& arrival : inbox->take()) {
    heard.push_back({{}, ExternalInput::sent, std::string(1, arrival.topic)});
    heard.back().bytes.append(arrival.message.begin(), arrival.message.end());
  }
  if (!client && client_) heard.push_back({{}, ExternalInput::left});
  return heard;
}

std::vector<ExternalInput> ExternalMessages::repeat(Duration now) {
  std::vector<ExternalInput> heard;
  for (; const ExternalInput* note = reader_.next(now); reader_.pass()) {
    // of messages before a state that was loaded, the state knows all
    if (note->time == now || note->kind != ExternalInput::sent) heard.push_back(*note);
  }
  return heard;
}

std::vector<ExternalInput> ExternalMessages::remember() {
  std::vector<ExternalInput> heard;
  for (; const ExternalInput* note = memory_->next(); memory_->pass()) {
    if (note->kind == ExternalInput::sent) heard.push_back(*note);
  }
  return heard;
}

std::vector<Arrival> ExternalMessages::at(Duration now, Inbox* inbox) {
  const bool live = !remembers();
  const std::vector<ExternalInput> heard = !live ? remember() : repeated_ ? repeat(now) : listen(inbox);
  pen_.at(now);
  std::vector<Arrival> messages;
  for (const ExternalInput& note : heard) {
    if (live) {
      pen_.write(note.kind, note.bytes);
      if (memory_) memory_->write(note.kind, note.bytes);
    }
    if (note.kind == ExternalInput::sent) {
      if (!note.bytes.empty()) messages.push_back({note.bytes.front(), {note.bytes.begin() + 1, note.bytes.end()}});
    } else {
      client_ = note.kind == ExternalInput::came;
      say_(client_ ? lines_.came : lines_.left);
    }
  }
  return messages;
}

}  // namespace murosimf::dds
