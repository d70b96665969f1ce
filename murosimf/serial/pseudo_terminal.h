/// pseudo_terminal.h - a virtual serial port: programs open one end like a real port, this process holds the other end.
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
  /// Bytes pass unchanged. The rate [bit/s] applies to programs that set none. Throws SetupError if the system has no
  /// pseudo terminal left.
  explicit PseudoTerminal(double rate = 1e6);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Path of the end that programs open: "/dev/pts/3".
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Whether a program has it open at present.
  [[nodiscard]] bool is_open() const noexcept;
  /// Appends bytes that programs have sent, up to a change of their rate. Never waits.
  void receive(std::vector<std::uint8_t>& bytes) noexcept;
  /// [bit/s] of the bytes received last.
  [[nodiscard]] double rate() const noexcept { return rate_; }
  /// Returns the number of bytes that fit; the others are lost. Never waits.
  std::size_t send(std::span<const std::uint8_t> bytes) noexcept;
  /// Drops bytes that were sent and not read.
  void discard() noexcept;

 private:
  int file_;
  std::string name_;
  double rate_;
  std::shared_ptr<WriterHold> hold_;
  std::unique_ptr<TerminalDrain> drain_;
};

/// Creates the folder of a link if it does not exist. Throws SetupError if that fails, or if anything else than a link to a terminal,
/// left behind by a program, has that path.
void check_link_place(const std::filesystem::path& path);

/// A symbolic link to a terminal, for as long as this lives.
class TerminalLink {
 public:
  /// Replaces a link that a program left behind. Throws SetupError as check_link_place does, or if the link cannot be made.
  TerminalLink(std::filesystem::path path, std::string terminal);
  ~TerminalLink();
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;

 private:
  std::filesystem::path path_;
  std::string terminal_;
};

}  // namespace murosimf::serial
