// The terminal that clients open: bytes as they are, connected clients, links, nothing left behind.
#include "murosimf/serial/pseudo_terminal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/fixtures.h"
#include "tests/serial/serial_port.h"
#include "tests/temp_folder.h"

namespace murosimf::serial {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes all_bytes() {
  Bytes bytes;
  for (int i = 0; i < 256; ++i) bytes.push_back(static_cast<std::uint8_t>(i));
  return bytes;
}

TEST(PseudoTerminal, CarriesEveryByteAsItIs) {
  PseudoTerminal terminal;
  const SerialPort port(terminal.name());
  port.send(all_bytes());
  Bytes received;
  terminal.receive(received);
  EXPECT_EQ(received, all_bytes());
  EXPECT_EQ(terminal.send(all_bytes()), 256U);
  EXPECT_EQ(port.received(), all_bytes());
  terminal.receive(received);
  EXPECT_EQ(received.size(), 256U);  // no echo
}

TEST(PseudoTerminal, KnowsWhetherSomebodyIsThere) {
  PseudoTerminal terminal;
  EXPECT_FALSE(terminal.is_open());
  for (int i = 0; i < 3; ++i) {
    SerialPort port(terminal.name());
    EXPECT_TRUE(terminal.is_open());
    port.send(Bytes{1, 2, 3});
    port.hang_up();
    EXPECT_FALSE(terminal.is_open());
    Bytes received;
    terminal.receive(received);  // what it said before it went
    EXPECT_EQ(received, (Bytes{1, 2, 3}));
    received.clear();
    terminal.receive(received);
    EXPECT_TRUE(received.empty());
  }
}

TEST(PseudoTerminal, TakesOnlyAsMuchAsThereIsRoomFor) {
  PseudoTerminal terminal;
  const SerialPort port(terminal.name());
  const Bytes flood(1 << 20, 0x55);
  std::size_t taken = terminal.send(flood);
  EXPECT_GT(taken, 1000U);
  // The kernel moves what has come to the reader's end at a time of its own, which makes room once more.
  while (const std::size_t more = terminal.send(flood)) taken += more;
  EXPECT_LT(taken, flood.size());
  terminal.discard();
  EXPECT_TRUE(port.received().empty());
}

TEST(PseudoTerminal, LeavesNothingOpen) {
  const std::size_t before = open_files();
  for (int i = 0; i < 20; ++i) {
    PseudoTerminal terminal;
    const SerialPort port(terminal.name());
    EXPECT_GE(open_files(), before + 2);
  }
  EXPECT_EQ(open_files(), before);
}

/// Waits until that many bytes have come, at most a second.
Bytes received_all(PseudoTerminal& terminal, std::size_t size) {
  Bytes bytes;
  for (int i = 0; i < 1000 && bytes.size() < size; ++i) {
    terminal.receive(bytes);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return bytes;
}

// A kernel keeps 4 kB for a reader; what is behind them has no room, or a flush drops it.
TEST(PseudoTerminal, LosesNothingToAFlushThoughNobodyReads) {
  PseudoTerminal terminal;
  const SerialPort port(terminal.name());
  const Bytes packet = all_bytes();
  for (int i = 0; i < 60; ++i) {
    port.send(packet);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  port.flush_output();
  const Bytes bytes = received_all(terminal, 60 * packet.size());
  ASSERT_EQ(bytes.size(), 60 * packet.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) ASSERT_EQ(bytes[i], packet[i % packet.size()]) << i;
}

TEST(PseudoTerminal, KnowsTheRateThatAProgramHasChosen) {
  PseudoTerminal terminal(57600);
  SerialPort port(terminal.name());
  Bytes bytes;
  port.send(Bytes{1});
  while (bytes.empty()) terminal.receive(bytes);
  EXPECT_EQ(terminal.rate(), 57600);
  for (const double rate : {9600.0, 1e6, 4.5e6, 123456.0}) {
    EXPECT_TRUE(port.set_rate(rate));
    bytes.clear();
    port.send(Bytes{2});
    while (bytes.empty()) terminal.receive(bytes);
    EXPECT_EQ(terminal.rate(), rate);
  }
}

// What was sent at one rate is told apart from what comes at the next, though it was not read in between.
TEST(PseudoTerminal, KeepsRatesApart) {
  PseudoTerminal terminal;
  SerialPort port(terminal.name());
  port.send(Bytes{1, 2});
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(port.set_rate(9600));
  port.send(Bytes{3});
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  Bytes bytes;
  terminal.receive(bytes);
  EXPECT_EQ(bytes, (Bytes{1, 2}));
  EXPECT_EQ(terminal.rate(), 1e6);
  bytes.clear();
  terminal.receive(bytes);
  EXPECT_EQ(bytes, Bytes{3});
  EXPECT_EQ(terminal.rate(), 9600);
}

TEST(TerminalLink, StandsAsLongAsItLives) {
  const fs::path folder = fixtures::temp_folder() / "new" / "ports";
  const PseudoTerminal terminal;
  {
    const TerminalLink link(folder / "blue1", terminal.name());
    EXPECT_EQ(fs::read_symlink(folder / "blue1"), terminal.name());
    fs::remove(folder / "blue1");
    fs::create_symlink("/dev/null", folder / "blue1");  // belongs to another program by now
  }
  EXPECT_TRUE(fs::is_symlink(folder / "blue1"));
  fs::remove(folder / "blue1");
  { const TerminalLink link(folder / "blue1", terminal.name()); }
  EXPECT_FALSE(fs::is_symlink(folder / "blue1"));
}

TEST(TerminalLink, ReplacesOnlyWhatAKilledProgramLeft) {
  const fs::path folder = fixtures::temp_folder() / "cleanup_guard";
  fs::create_directories(folder);
  fs::create_symlink("/dev/pts/99999", folder / "dead");
  { const TerminalLink link(folder / "dead", "/dev/pts/0"); }
  std::ofstream(folder / "file") << "text";
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { const TerminalLink link(folder / "file", "/dev/pts/0"); }),
                             {"file' is there already, and no link to a terminal"}));
  EXPECT_TRUE(fs::exists(folder / "file"));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { const TerminalLink link(folder / "file" / "a", "/dev/pts/0"); }),
                             {"is no folder"}));
}

}  // namespace
}  // namespace murosimf::serial
