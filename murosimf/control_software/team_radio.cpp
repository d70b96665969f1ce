#include "murosimf/control_software/team_radio.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {

void TeamRadio::open() {
  if (box_) return;
  if (!setup_) throw SetupError("messages were not asked for when the robot was set up, so they cannot be now");
  name_ = setup_->entity().name();
  if (setup_->entity().options().team.empty()) {
    throw SetupError(fmt::format("{} is in no team, so there is no robot to send messages to", name_));
  }
  box_ = &setup_->write(message_box)[0];
}

bool TeamRadio::send(std::string_view bytes) noexcept {
  if (use_) use_->sent.emplace_back(bytes);
  refusal_ = why_not(bytes);
  if (!refusal_.empty()) {
    if (box_) ++box_->counts.refused;
    return false;
  }
  MUROSIMF_ASSERT(box_ != nullptr);
  ++box_->counts.sent;
  box_->recent.push_back(now_);
  box_->outbox.push_back({now_, name_, std::string(bytes)});
  return true;
}

std::string TeamRadio::why_not(std::string_view bytes) const {
  using namespace std::chrono_literals;
  if (!box_) return "messages were not asked for when the robot was set up";
  if (bytes.size() > box_->longest) {
    return fmt::format("a message has {} bytes; {} are allowed", bytes.size(), box_->longest);
  }
  // a sliding window: any interval of one second, not only whole ones
  std::erase_if(box_->recent, [&](Duration sent) { return sent <= now_ - 1s; });
  if (box_->recent.size() < box_->per_second) return {};
  return fmt::format("more than {} messages in a second", box_->per_second);
}

const TeamMessage* TeamRadio::receive() noexcept {
  if (!box_ || box_->inbox.empty()) return nullptr;
  if (use_) ++use_->received;
  read_ = std::move(box_->inbox.front());
  box_->inbox.erase(box_->inbox.begin());
  return &read_;
}

std::optional<MessageCounts> TeamRadio::counts() const {
  if (!box_) return std::nullopt;
  return box_->counts;
}

}  // namespace murosimf::control_software
