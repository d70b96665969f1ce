/// team_radio.h - how control software talks to the robots of its team: bytes, at most so many per message and second.
///
/// The same for software in shared libraries and behind sockets. What becomes of a message: message_exchange.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/connect/message_box.h"
#include "murosimf/model/setup.h"

namespace murosimf::connect {

/// What software has done with a radio.
struct RadioUse {
  std::uint64_t received = 0;     ///< messages that were read
  std::vector<std::string> sent;  ///< also those that were refused
};

class TeamRadio {
 public:
  /// `setup` must live until close().
  explicit TeamRadio(Setup& setup) : setup_(&setup) {}

  /// While the robot is set up: from now on it sends and gets messages; again at any time, if that was done before. Throws SetupError:
  /// the robot has no team, or it is too late.
  void open();
  void close() { setup_ = nullptr; }
  [[nodiscard]] bool is_open() const { return box_ != nullptr; }

  /// Before the software's step that begins at `now`.
  void refresh(Duration now) noexcept { now_ = now; }

  /// To all others of the team. False, and counted: it is too long, or there were too many in this second, or it is not open.
  bool send(std::string_view bytes) noexcept;
  /// The oldest that has arrived and was not read yet; null: there is none. It stays until the next call.
  [[nodiscard]] const TeamMessage* receive() noexcept;

  /// From now on what is done with it is added there, until the next call; null: nowhere.
  void note_use(RadioUse* use) noexcept { use_ = use; }

  /// Why the last send() was refused: "it has 2000 bytes; 1400 are allowed"; empty: it was not.
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

}  // namespace murosimf::connect
