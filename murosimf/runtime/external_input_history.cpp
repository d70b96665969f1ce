#include "murosimf/runtime/external_input_history.h"

#include "murosimf/math/assert.h"

namespace murosimf {

const ExternalInput* ExternalInputHistory::Channel::next() const {
  return at_ < repeated_.size() && repeated_[at_].time <= memory_->now_ ? &repeated_[at_] : nullptr;
}

auto ExternalInputHistory::channel(const std::string& name) -> Channel& {
  const auto [found, is_new] = names_.try_emplace(name, channels_.size());
  if (is_new) channels_.emplace_back(*this);
  return channels_[found->second];
}

std::vector<RememberedInput> ExternalInputHistory::take() {
  std::vector<RememberedInput> taken;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    for (ExternalInput& note : channels_[i].written_) taken.push_back({i, std::move(note)});
    channels_[i].written_.clear();
  }
  return taken;
}

void ExternalInputHistory::repeat(std::vector<RememberedInput> notes) {
  live();
  repeats_ = true;
  for (RememberedInput& one : notes) {
    MUROSIMF_ASSERT(one.channel < channels_.size());
    channels_[one.channel].repeated_.push_back(std::move(one.note));
  }
}

void ExternalInputHistory::live() {
  repeats_ = false;
  for (Channel& channel : channels_) {
    channel.repeated_.clear();
    channel.at_ = 0;
  }
}

}  // namespace murosimf
