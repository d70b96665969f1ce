/// pseudo_terminal.h - a serial port that programs open as they open a real one, and this process holds the other end of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace murosimf::serial {

class TerminalDrain;
class WriterHold;

class PseudoTerminal {
 public:
  /// Bytes go through as they are. The rate [bit/s] is that of programs which choose none. Throws SetupError if the system has
  /// none left.
  explicit PseudoTerminal(double rate = 1e6);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Of the end that programs open: "/dev/pts/3".
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Whether a program has it open now.
  [[nodiscard]] bool is_open() const noexcept;
  /// Appends what programs have sent, up to where they have chosen another rate. Never waits.
  void receive(std::vector<std::uint8_t>& bytes) noexcept;
  /// [bit/s] of what was received last.
  [[nodiscard]] double rate() const noexcept { return rate_; }
  /// How many bytes there was room for; the others are lost. Never waits.
  std::size_t send(std::span<const std::uint8_t> bytes) noexcept;
  /// Forgets what was sent and nobody has read.
  void discard() noexcept;

 private:
  int file_;
  std::string name_;
  double rate_;
  std::shared_ptr<WriterHold> hold_;
  std::unique_ptr<TerminalDrain> drain_;
};

/// Makes the folder of a link if it is not there. Throws SetupError if that cannot be, or if anything else than a link to a terminal,
/// which a program left behind, has that path.
void check_link_place(const std::filesystem::path& path);

/// A symbolic link to a terminal, for as long as this lives.
class TerminalLink {
 public:
  /// Replaces what a program left behind. Throws SetupError as check_link_place does, or if it cannot be made.
  TerminalLink(std::filesystem::path path, std::string terminal);
  ~TerminalLink();
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;

 private:
  std::filesystem::path path_;
  std::string terminal_;
};

}  // namespace murosimf::serial
