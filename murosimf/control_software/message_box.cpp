#include "murosimf/control_software/message_box.h"

#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

void append(Hasher& hasher, const std::vector<TeamMessage>& messages) {
  hasher.add(static_cast<std::uint64_t>(messages.size()));
  for (const TeamMessage& message : messages) {
    hasher.add(static_cast<std::uint64_t>(message.sent.count()));
    hasher.add(std::string_view(message.sender));
    hasher.add(std::string_view(message.bytes));
  }
}

}  // namespace

/// A robot that does not read keeps the newest messages.
void MessageBox::deliver(TeamMessage message) {
  MUROSIMF_ASSERT(inbox.size() <= most_unread);
  ++counts.arrived;
  if (inbox.size() == most_unread) {
    inbox.erase(inbox.begin());
    ++counts.not_read;
  }
  inbox.push_back(std::move(message));
}

void append_hash(Hasher& hasher, const MessageBox& box) {
  append(hasher, box.outbox);
  append(hasher, box.inbox);
  for (const std::uint64_t count :
       {box.counts.sent, box.counts.refused, box.counts.lost, box.counts.arrived, box.counts.not_read}) {
    hasher.add(count);
  }
}

}  // namespace murosimf::control_software
