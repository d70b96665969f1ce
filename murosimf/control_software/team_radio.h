/// team_radio.h - communication of control software within its team: byte strings, limited in size and rate.
///
/// The same for software in shared libraries and behind sockets. Delivery: message_exchange.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/message_box.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

/// Recorded use of a radio.
struct RadioUse {
  std::uint64_t received = 0;     ///< messages that were read
  std::vector<std::string> sent;  ///< also those that were refused
};

class TeamRadio {
 public:
  /// `setup` must live until close().
  explicit TeamRadio(Setup& setup) : setup_(&setup) {}

  /// While the robot is set up: enables sending and receiving; can be repeated later, once enabled. Throws SetupError:
  /// the robot has no team, or set-up is over.
  void open();
  void close() { setup_ = nullptr; }
  [[nodiscard]] bool is_open() const { return box_ != nullptr; }

  /// Before the software's step that begins at `now`.
  void refresh(Duration now) noexcept { now_ = now; }

  /// Sends to all others of the team. Returns false, and counts it, if it is too long, exceeds the rate, or the radio is not open.
  bool send(std::string_view bytes) noexcept;
  /// The oldest unread message; null: none. It stays valid until the next call.
  [[nodiscard]] const TeamMessage* receive() noexcept;

  /// Records later use there, until the next call; null: nowhere.
  void note_use(RadioUse* use) noexcept { use_ = use; }

  /// Reason for the refusal of the last send(): "it has 2000 bytes; 1400 are allowed"; empty: it was sent.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// Nothing if it is not open.
  [[nodiscard]] std::optional<MessageCounts> counts() const;

 private:
  [[nodiscard]] std::string why_not(std::string_view bytes) const;

  Setup* setup_;
  std::string name_;
  MessageBox* box_ = nullptr;
  Duration now_{};
  TeamMessage read_;  // the last one
  std::string refusal_;
  RadioUse* use_ = nullptr;
};

}  // namespace murosimf::control_software
