// Errors of clients are reported in one line, affect only their own robot, and leave nothing behind.
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cmath>
#include <random>

#include "tests/network/tcp_fixture.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

std::size_t open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// Runs two robots for a second; `error` is the software of the right one. Returns the report, while the left one continues to play.
std::string ending(const std::function<void(RawClient&)>& error, std::vector<std::string> overrides = {}) {
  const std::size_t files = open_files();
  std::string how;
  {
    const Listener listener;
    Software left([&] { walk_to_ball("left", listener.port()); });
    Software right([&] {
      RawClient client(listener.port());
      client.come("right");
      client.play(6);
      error(client);
    });
    overrides.insert(overrides.end(), {"right.control_rate=20", "right.options.limit=0.3", "right.options.absence=0"});
    {
      scene::Scene scene(to_the_ball_tcp, two_robots(listener, overrides));
      scene.simulation().run(1s);
      how = software(scene, "right").ended;
      EXPECT_EQ(software(scene, "left").calls, 20);
      EXPECT_EQ(software(scene, "left").ended, "");
      EXPECT_EQ(forward(scene, "right"), 0.1) << "the last commands hold";
      const auto warnings = scene::make_report(scene, 1s, {}).warnings;
      EXPECT_EQ(std::ranges::count_if(warnings,
                                      [](const std::string& w) { return w.starts_with("right: its control"); }),
                1);
    }
    EXPECT_EQ(left.error(), "");
    EXPECT_EQ(right.error(), "");
  }
  EXPECT_EQ(open_files(), files);
  EXPECT_EQ(how.find('\n'), std::string::npos);
  return how;
}

constexpr const char* of_client = "at 0.250 s: raw at 127.0.0.1:";

TEST(TcpFaults, KilledInTheMiddleOfAMessage) {
  EXPECT_TRUE(says(ending([](RawClient& client) {
                     (void)client.receive();
                     client.bytes(std::string("\0\0\0\x20half", 8));
                   }),
                   {of_client, "closed the connection"}));
}

TEST(TcpFaults, Vanishes) {
  EXPECT_TRUE(says(ending([](RawClient& client) {
                     (void)client.receive();
                     const linger at_once{1, 0};  // a reset instead of an orderly end
                     ::setsockopt(client.connection.socket().number(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
                   }),
                   {of_client, "closed the connection"}));
}

TEST(TcpFaults, ClosesItsHalfOnly) {
  EXPECT_TRUE(says(ending([](RawClient& client) {
                     ::shutdown(client.connection.socket().number(), SHUT_WR);
                     EXPECT_EQ(client.end(), "closed the connection");
                   }),
                   {of_client, "closed the connection"}));
}

TEST(TcpFaults, IsSilent) {
  EXPECT_TRUE(says(ending([](RawClient& client) { EXPECT_EQ(client.end(), "did not answer in time"); }),
                   {of_client, "did not answer in time"}));
}

TEST(TcpFaults, SendsTooMuchAtOnce) {
  for (const auto& [prefix, length] :
       {std::pair{std::string("\x40\0\0\0", 4), 1073741824U}, std::pair{std::string("\0\1\0\1", 4), 65537U}}) {
    const std::string reason = fmt::format("announces a message of {} bytes, the longest may have 65536", length);
    EXPECT_TRUE(says(ending([&](RawClient& client) {
                       client.bytes(prefix);
                       EXPECT_EQ(client.end(), reason);
                     }),
                     {of_client, reason}));
  }
}

TEST(TcpFaults, SendsNothingButZeros) {
  EXPECT_TRUE(says(ending([](RawClient& client) { client.bytes(std::string(1000, '\0')), (void)client.end(); }),
                   {of_client, "sends what is no message of this protocol"}));
}

TEST(TcpFaults, SendsGarbage) {
  EXPECT_TRUE(
      says(ending([](RawClient& client) { client.bytes(std::string("\0\0\0\6GET / HTTP", 14)), (void)client.end(); }),
           {of_client, "sends what is no message of this protocol"}));
}

TEST(TcpFaults, AnswersAnotherCycle) {
  EXPECT_TRUE(says(ending([](RawClient& client) { client.answer(3), (void)client.end(); }),
                   {of_client, "answers cycle 3 in cycle 7"}));
  EXPECT_TRUE(says(ending([](RawClient& client) { client.answer(1000), (void)client.end(); }),
                   {of_client, "answers cycle 1000 in cycle 7"}));
}

TEST(TcpFaults, SendsOtherRows) {
  EXPECT_TRUE(says(ending([](RawClient& client) {
                     client.answer(7, {0, 0}), (void)client.end();
                   }),
                   {of_client, "sends 2 numbers for 'walk.velocity', which has 3"}));
  EXPECT_TRUE(says(ending([](RawClient& client) {
                     wire::FromClient message;
                     message.mutable_commands()->set_cycle(7);
                     client.send(message), (void)client.end();
                   }),
                   {of_client, "sends 0 rows of commands, and asked for 1"}));
}

TEST(TcpFaults, IsReadyOrAsksAgain) {
  EXPECT_TRUE(
      says(ending([](RawClient& client) { client.ready(), (void)client.end(); }), {of_client, "is ready twice"}));
  EXPECT_TRUE(says(ending([](RawClient& client) { client.ask_for_velocity(), (void)client.end(); }),
                   {of_client, "asks for a name after it was ready"}));
  EXPECT_TRUE(says(ending([](RawClient& client) { client.hello("right"), (void)client.end(); }),
                   {of_client, "says Hello twice"}));
}

// The effect of any bytes is reported in one line as well: valid messages with some of their bytes changed.
TEST(TcpFaults, SendsChangedMessages) {
  wire::FromClient message;
  message.mutable_commands()->set_cycle(7);
  message.mutable_commands()->add_rows()->mutable_values()->Add(0.1);
  message.mutable_commands()->add_says("a line\nor two");
  const std::string whole = message.SerializeAsString();
  std::mt19937 random(1);
  for (int i = 0; i < 15; ++i) {
    std::string bytes = std::string("\0\0\0", 3) + static_cast<char>(whole.size()) + whole;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    EXPECT_TRUE(says(ending([&](RawClient& client) {
                       client.bytes(bytes);
                       ::shutdown(client.connection.socket().number(), SHUT_WR);
                       (void)client.end();
                     }),
                     {"s: raw at 127.0.0.1:"}))
        << "message " << i;
  }
}

/// In free-running mode until the client is dropped; returns the report.
std::string dropped(const std::function<void(RawClient&)>& error) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] {
    RawClient client(listener.port());
    client.come("right");
    error(client);
  });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.options.mode=free", "right.options.limit=0.3"}));
  scene.simulation().initialize();
  const network::WallTime end = soon();
  while (software(scene, "right").said.empty() && std::chrono::steady_clock::now() < end) scene.simulation().run(50ms);
  EXPECT_EQ(software(scene, "left").ended, "");
  return software(scene, "right").said.empty() ? "not dropped" : software(scene, "right").said[0].text;
}

TEST(FreeTcpFaults, ReadsNothing) {
  EXPECT_TRUE(says(dropped([](RawClient& client) { std::this_thread::sleep_for(1s), (void)client.end(); }),
                   {"raw at", "did not answer in time"}));
}

// It answers a message that it has not read: cycle 1 was sent as well.
TEST(FreeTcpFaults, SendsWithoutEnd) {
  EXPECT_TRUE(says(dropped([](RawClient& client) {
                     (void)client.receive();
                     wire::FromClient message;
                     message.mutable_commands()->set_cycle(1);
                     message.mutable_commands()->add_rows();
                     try {
                       for (int i = 0; i < 10'000'000; ++i) client.send(message);
                     } catch (const network::NetworkError&) {  // dropped
                     }
                   }),
                   {"raw at", "sends more than 20000 messages in a second"}));
}

/// The report about a stranger that makes this error.
std::string told_of(const std::function<void(RawClient&)>& error, double hello_limit = 5) {
  const std::size_t files = open_files();
  std::vector<std::string> lines;
  {
    const Listener listener(hello_limit);
    RawClient client(listener.port());
    error(client);
    lines = listener.lines(1);
  }
  EXPECT_EQ(open_files(), files);
  EXPECT_EQ(lines.size(), 1U);
  return lines.empty() ? "" : lines[0];
}

TEST(TcpStrangers, AreToldOfInOneLineEach) {
  const auto refused = [](const std::string& bytes, const std::string& why) {
    EXPECT_TRUE(says(told_of([&](RawClient& client) { client.bytes(bytes); }),
                     {"client 127.0.0.1:", "was refused: it " + why}));
  };
  refused(std::string("\x40\0\0\0", 4), "announces a message of 1073741824 bytes");
  refused(std::string(100, '\0'), "sends what is no message of this protocol");
  refused("GET / HTTP/1.1\r\n\r\n", "announces a message of 1195725856 bytes");
  refused(std::string("\0\0\0\2\x1a\0", 6), "does not begin with a Hello");
  EXPECT_TRUE(says(told_of([](RawClient& client) { client.hello("left", 2); }),
                   {"speaks version 2 of the protocol, this program 1"}));
  EXPECT_TRUE(says(told_of([](RawClient&) {}, 0.05), {"has sent no greeting in time"}));
  EXPECT_TRUE(says(told_of([](RawClient& client) { const network::Connection gone = std::move(client.connection); }),
                   {"closed the connection"}));
}

// The robots' own software connects in between, and after them.
TEST(TcpStrangers, AHundredAtOnceKeepNobodyOut) {
  const std::size_t files = open_files();
  {
    const Listener listener;
    std::vector<RawClient> strangers;
    for (int i = 0; i < 50; ++i) strangers.emplace_back(listener.port());
    Software left([&] { walk_to_ball("left", listener.port()); });
    for (int i = 0; i < 50; ++i) strangers.emplace_back(listener.port());
    Software right([&] { walk_to_ball("right", listener.port()); });
    {
      scene::Scene scene(to_the_ball_tcp, two_robots(listener));
      scene.simulation().run(1s);
      EXPECT_EQ(software(scene, "left").calls, 20);
      EXPECT_EQ(software(scene, "right").calls, 20);
    }
    EXPECT_EQ(left.error(), "");
    EXPECT_EQ(right.error(), "");
    EXPECT_GE(listener.lines(100 - 64).size(), 100U - 64U);
  }
  EXPECT_EQ(open_files(), files);
}

TEST(TcpServer, SaysThatThePortIsInUse) {
  const Listener listener;
  EXPECT_EQ(error_of([&] { (void)listen_for_software({.address = listener.server->address()}); }),
            fmt::format("cannot listen on 127.0.0.1:{}: the port is in use", listener.port()));
}

TEST(TcpServer, StopsWaitingWhenItIsTold) {
  const auto server = listen_for_software({.stop = [] { return true; }});
  EXPECT_TRUE(says(error_of([&] { scene::Scene(to_the_ball_tcp, {.software = server}); }),
                   {"stopped while waiting for the software of left"}));
}

TEST(TcpServer, DoesNotWaitForEver) {
  const Listener listener;
  const auto build = [&](const std::vector<std::string>& overrides) {
    return error_of([&] { scene::Scene(to_the_ball_tcp, two_robots(listener, overrides)); });
  };
  EXPECT_TRUE(
      says(build({"left.options.wait=0.05"}), {"left: no software has come for it to 127.0.0.1:", "within 0.05 s"}));
  RawClient unready(listener.port());
  unready.hello("left");
  EXPECT_TRUE(says(build({"left.options.wait=0.5"}), {"left: raw at", "did not answer in time before it was ready"}));
}

}  // namespace
}  // namespace murosimf::control_software
