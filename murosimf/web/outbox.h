/// outbox.h - queue of messages to one client.
///
/// Answers are sent in their order, all of them. Views of the present (poses, numbers, pictures) are not queued: of each kind only the
/// newest one waits, so a slow client gets fewer of them, but no outdated ones.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace murosimf::web {

struct Message {
  std::shared_ptr<const std::string> bytes;  ///< may be shared by several clients
  bool binary = false;
};

inline Message text_message(std::string text) { return {std::make_shared<const std::string>(std::move(text)), false}; }
inline Message binary_message(std::string bytes) {
  return {std::make_shared<const std::string>(std::move(bytes)), true};
}

class Outbox {
 public:
  void send(Message message) {
    waiting_ += message.bytes->size();
    answers_.push_back(std::move(message));
  }
  /// Replaces the waiting view of the same kind, at its place in the order.
  void show(int kind, Message message) {
    replaced_ += views_.contains(kind) ? 1 : 0;
    views_[kind] = std::move(message);
  }

  [[nodiscard]] bool empty() const { return answers_.empty() && views_.empty(); }
  [[nodiscard]] std::size_t waiting_bytes() const { return waiting_; }  ///< of answers
  [[nodiscard]] std::size_t replaced() const { return replaced_; }      ///< number of views that were never sent

  /// Answers first; then the kinds in turn.
  [[nodiscard]] std::optional<Message> take() {
    if (!answers_.empty()) {
      Message message = std::move(answers_.front());
      answers_.pop_front();
      waiting_ -= message.bytes->size();
      return message;
    }
    auto next = views_.upper_bound(last_kind_);
    if (next == views_.end()) next = views_.begin();
    if (next == views_.end()) return std::nullopt;
    last_kind_ = next->first;
    Message message = std::move(next->second);
    views_.erase(next);
    return message;
  }

 private:
  std::deque<Message> answers_;
  std::map<int, Message> views_;
  int last_kind_ = -1;
  std::size_t waiting_ = 0, replaced_ = 0;
};

}  // namespace murosimf::web
