// Six robots at serial lines of 1 Mbaud in real time: each client sends all goals by one sync write and reads all positions by one bulk
// read, one hundred times per second. Prints a table, writes JSON:
//
//     murosimf_serial_lines [SECONDS] [FILE.json]
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/model/error.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/scene/scene.h"
#include "murosimf/serial/dynamixel/packet_parser.h"

namespace {

using namespace murosimf;
using namespace murosimf::serial::dynamixel;
using WallClock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr int servos = 21;
constexpr auto cycle = std::chrono::milliseconds(10);
constexpr std::array robots{"blue1", "blue2", "blue3", "red1", "red2", "red3"};

struct Registers {
  std::uint8_t torque, return_delay, goal, present, size;
};
constexpr Registers registers_of(Protocol protocol) {
  return protocol == Protocol::v1 ? Registers{24, 5, 30, 36, 2} : Registers{64, 9, 116, 132, 4};
}

/// One robot's software.
class Client {
 public:
  Client(const std::filesystem::path& port, Protocol protocol)
      : file_(open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)), protocol_(protocol) {
    if (file_ < 0) throw SetupError(port.string() + ": " + std::strerror(errno));
  }
  ~Client() { close(file_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void run(WallClock::time_point begin, int cycles) {
    const Registers at = registers_of(protocol_);
    send(sync_write(at.return_delay, 1, 0));
    send(sync_write(at.torque, 1, 1));
    WallClock::time_point due = begin;
    for (int i = 0; i < cycles; ++i, due += cycle) {
      std::this_thread::sleep_until(due);
      const WallClock::time_point sent = WallClock::now();
      send(sync_write(at.goal, at.size, 2048 + static_cast<int>(std::lround(50 * std::sin(0.05 * i)))));
      send(bulk_read(at.present, at.size));
      if (all_answers(due + cycle)) {
        took_.push_back(Milliseconds(WallClock::now() - sent).count());
      } else {
        ++missed_;
      }
    }
  }
  [[nodiscard]] const std::vector<double>& took() const { return took_; }
  [[nodiscard]] int missed() const { return missed_; }

 private:
  void number(Bytes& bytes, int value) const {
    if (protocol_ == Protocol::v1) return bytes.push_back(static_cast<std::uint8_t>(value));
    append_word(bytes, static_cast<std::size_t>(value));
  }
  [[nodiscard]] Packet sync_write(int address, int size, int value) const {
    Packet packet{protocol_, broadcast_id, static_cast<std::uint8_t>(Instruction::sync_write), {}};
    number(packet.parameters, address);
    number(packet.parameters, size);
    for (int id = 1; id <= servos; ++id) {
      packet.parameters.push_back(static_cast<std::uint8_t>(id));
      for (int i = 0; i < size; ++i) packet.parameters.push_back(static_cast<std::uint8_t>(value >> 8 * i & 0xFF));
    }
    return packet;
  }
  [[nodiscard]] Packet bulk_read(int address, int size) const {
    Packet packet{protocol_, broadcast_id, static_cast<std::uint8_t>(Instruction::bulk_read), {}};
    if (protocol_ == Protocol::v1) packet.parameters.push_back(0);
    for (int id = 1; id <= servos; ++id) {
      if (protocol_ == Protocol::v1) number(packet.parameters, size);
      packet.parameters.push_back(static_cast<std::uint8_t>(id));
      number(packet.parameters, address);
      if (protocol_ == Protocol::v2) number(packet.parameters, size);
    }
    return packet;
  }
  void send(const Packet& packet) const {
    const Bytes bytes = to_bytes(packet);
    if (write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
      std::fputs("a line takes no bytes\n", stderr);
    }
  }
  /// Whether all positions have come by then. Those that come later count for nobody.
  bool all_answers(WallClock::time_point deadline) {
    int answers = 0;
    PacketParser parser;
    while (answers < servos) {
      const double left = Milliseconds(deadline - WallClock::now()).count();
      if (left <= 0) return false;
      pollfd wanted{.fd = file_, .events = POLLIN, .revents = 0};
      poll(&wanted, 1, 1 + static_cast<int>(left));
      std::array<std::uint8_t, 4096> bytes{};
      const ssize_t count = read(file_, bytes.data(), bytes.size());
      if (count > 0) parser.push({bytes.data(), static_cast<std::size_t>(count)});
      while (parser.next()) ++answers;
    }
    return true;
  }

  int file_;
  Protocol protocol_;
  std::vector<double> took_;  // [ms]
  int missed_ = 0;
};

struct Result {
  int protocol = 0;
  double baud_rate = 0, late_share = 0, worst_step = 0;  // [bit/s, 1, ms]
  std::size_t answered = 0;
  int missed = 0;
  double median = 0, most = 0,
         worst = 0;  // [ms] median, 99 % and longest from the first byte sent to the last that came
};

Result measure(Protocol protocol, double baud_rate, int seconds) {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("murosimf_serial_lines_{}", getpid());
  scene::SceneOptions options{.terminals = folder.string(), .cameras = false};
  for (const char* robot : robots) {
    options.overrides.push_back(fmt::format("{}.controller=serial", robot));
    options.overrides.push_back(fmt::format("{}.options.protocol={}", robot, static_cast<int>(protocol)));
    options.overrides.push_back(fmt::format("{}.options.baud_rate={}", robot, baud_rate));
  }
  Result result{.protocol = static_cast<int>(protocol), .baud_rate = baud_rate};
  {
    scene::Scene scene("three_on_three", options);
    scene.simulation().step();  // from now on there are links
    Clock clock(1.0);
    std::atomic<bool> done = false;
    scene.simulation().stop_if([&] { return done.load(); });
    std::jthread simulation([&] { scene.simulation().run(std::chrono::hours(1), clock); });
    std::vector<std::unique_ptr<Client>> clients;
    for (const char* robot : robots) clients.push_back(std::make_unique<Client>(folder / robot, protocol));
    {
      const auto begin = WallClock::now() + std::chrono::milliseconds(200);
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < clients.size(); ++i) {  // robots are not in step
        threads.emplace_back([&, i] { clients[i]->run(begin + i * std::chrono::microseconds(1700), 100 * seconds); });
      }
    }
    done = true;
    simulation.join();
    std::vector<double> took;
    for (const auto& client : clients) {
      took.insert(took.end(), client->took().begin(), client->took().end());
      result.missed += client->missed();
    }
    std::ranges::sort(took);
    result.answered = took.size();
    if (!took.empty()) {
      result.median = took[took.size() / 2];
      result.most = took[took.size() * 99 / 100];
      result.worst = took.back();
    }
    const Lateness& late = clock.lateness();
    result.late_share =
        static_cast<double>(late.late_steps) / static_cast<double>(std::max<std::int64_t>(1, late.steps));
    result.worst_step = Milliseconds(late.worst).count();
  }
  std::filesystem::remove(folder);
  return result;
}

std::string to_json(const Result& result) {
  return fmt::format(
      R"(  {{"protocol": {}, "baud_rate": {:.0f}, "answered": {}, "missed": {}, "median_ms": {:.3f}, "p99_ms": {:.3f}, )"
      R"("worst_ms": {:.3f}, "late_steps": {:.5f}, "worst_step_ms": {:.3f}}})",
      result.protocol, result.baud_rate, result.answered, result.missed, result.median, result.most, result.worst,
      result.late_share, result.worst_step);
}

int run(int seconds, const char* file) {
  fmt::print("six robots, {} servos each, sync write and bulk read at 100 Hz for {} s\n\n", servos, seconds);
  fmt::print("protocol  baud rate  answered  missed   median     99 %    worst  late steps\n");
  std::string json;
  for (const Protocol protocol : {Protocol::v1, Protocol::v2}) {
    for (const double baud_rate : {0.0, 1e6}) {
      const Result result = measure(protocol, baud_rate, seconds);
      fmt::print("{:>7}.0  {:>9}  {:>8}  {:>6}  {:>4.2f} ms  {:>4.2f} ms  {:>4.2f} ms  {:>8.2f} %\n", result.protocol,
                 baud_rate > 0 ? "1 M" : "-", result.answered, result.missed, result.median, result.most, result.worst,
                 100 * result.late_share);
      std::fflush(stdout);
      json += (json.empty() ? "" : ",\n") + to_json(result);
    }
  }
  if (file) std::ofstream(file) << "[\n" << json << "\n]\n";
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  int seconds = 10;
  const std::string_view given = count > 1 ? arguments[1] : "10";
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), seconds);
  if (error != std::errc{} || end != given.data() + given.size() || seconds < 1 || seconds > 3600 || count > 3) {
    std::fputs("usage: murosimf_serial_lines [SECONDS] [FILE.json]\n", stderr);
    return 2;
  }
  try {
    return run(seconds, count > 2 ? arguments[2] : nullptr);
  } catch (const SetupError& failure) {
    fmt::print(stderr, "murosimf_serial_lines: {}\n", failure.what());
    return 1;
  }
}
