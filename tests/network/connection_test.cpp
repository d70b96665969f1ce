// Addresses as users write them, and messages that arrive complete, however the network splits them.
#include "murosimf/network/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::network {
namespace {

using namespace std::chrono_literals;

WallTime soon() { return std::chrono::steady_clock::now() + 5s; }

/// Two ends of a connection.
struct Pair {
  explicit Pair(std::size_t longest = 1000)
      : listener(Socket::listen({})),
        near(Socket::connect(listener.own_address()), longest),
        far(accepted(), longest) {}
  Socket accepted() const {
    (void)listener.wait(soon());
    return listener.accept();
  }
  Socket listener;
  Connection near, far;
};

template <class F>
std::string error_of(const F& f) {
  try {
    f();
  } catch (const NetworkError& error) {
    return error.what();
  }
  return "none";
}

void send_all(const Socket& socket, std::string_view bytes) {
  while (!bytes.empty()) {
    bytes.remove_prefix(socket.send(bytes));
    (void)socket.wait(soon(), true);
  }
}

int option_of(const Socket& socket, int level, int option) {
  int value = -1;
  socklen_t size = sizeof value;
  EXPECT_EQ(::getsockopt(socket.number(), level, option, &value, &size), 0);
  return value;
}

// The effect of this setting needs a cable that can be unplugged.
TEST(Socket, AsksWhetherTheOtherComputerIsStillThere) {
  const Pair pair;
  const Socket& far = pair.far.socket();
  EXPECT_NE(option_of(far, SOL_SOCKET, SO_KEEPALIVE), 0);
  const int until_gone = option_of(far, IPPROTO_TCP, TCP_KEEPIDLE) +
                         option_of(far, IPPROTO_TCP, TCP_KEEPINTVL) * option_of(far, IPPROTO_TCP, TCP_KEEPCNT);
  EXPECT_EQ(until_gone, 60);
  EXPECT_EQ(option_of(far, IPPROTO_TCP, TCP_USER_TIMEOUT), 60'000) << "also while something is on its way";
}

TEST(Address, IsReadAndWritten) {
  EXPECT_EQ(to_text(parse_address("5000")), "127.0.0.1:5000");
  EXPECT_EQ(to_text(parse_address("0.0.0.0:80")), "0.0.0.0:80");
  EXPECT_EQ(to_text(parse_address("[::1]:65535")), "[::1]:65535");
  for (const char* wrong : {"", ":", "host", "host:", ":5000", "65536", "-1", "50x", "1.5", "host:5000x"}) {
    EXPECT_EQ(error_of([&] { (void)parse_address(wrong); }), fmt::format("'{}' is no PORT or HOST:PORT", wrong));
  }
}

TEST(Socket, SaysWhyItCannotListenOrConnect) {
  const Socket first = Socket::listen({});
  const Address address = first.own_address();
  EXPECT_GT(address.port, 0);
  EXPECT_EQ(error_of([&] { (void)Socket::listen(address); }), "the port is in use");
  EXPECT_TRUE(error_of([] { (void)Socket::listen({"no.such.host.invalid", 0}); }).starts_with("no host"));
  Address unused;
  {
    const Socket other = Socket::listen({});
    unused = other.own_address();
  }
  EXPECT_EQ(error_of([&] { (void)Socket::connect(unused); }), "connection refused");
}

TEST(Connection, PutsTheLengthBeforeTheMessageMostSignificantByteFirst) {
  Pair pair;
  pair.near.send(std::string(258, 'x'));
  std::array<char, 300> bytes{};
  (void)pair.far.socket().wait(soon());
  ASSERT_EQ(pair.far.socket().receive(bytes), 262U);
  EXPECT_EQ(std::string(bytes.data(), 5), std::string("\0\0\1\2x", 5));
}

TEST(Connection, GivesMessagesThatComeInPieces) {
  Pair pair;
  const std::string bytes("\0\0\0\3abc\0\0\0\0\0\0\0\1d", 16);
  std::vector<std::string> received;
  for (const char c : bytes) {
    send_all(pair.near.socket(), {&c, 1});
    (void)pair.far.socket().wait(soon());
    while (const auto message = pair.far.receive()) received.emplace_back(*message);
  }
  EXPECT_EQ(received, (std::vector<std::string>{"abc", "", "d"}));
}

TEST(Connection, GivesAllMessagesOfOnePiece) {
  Pair pair(100'000);
  std::vector<std::string> sent, received;
  for (int i = 0; i < 200; ++i)
    sent.push_back(std::string(static_cast<std::size_t>(i * 7), static_cast<char>('a' + i % 26)));
  for (const std::string& message : sent) pair.near.send(message);
  pair.near.flush_until(soon());
  for (std::size_t i = 0; i < sent.size(); ++i) received.emplace_back(pair.far.receive_until(soon()));
  EXPECT_EQ(received, sent);
  EXPECT_FALSE(pair.far.receive());
}

TEST(Connection, RefusesLongMessagesByTheirLengthAlone) {
  Pair pair(1000);
  pair.near.send(std::string(1000, 'x'));
  EXPECT_EQ(pair.far.receive_until(soon()).size(), 1000U);
  send_all(pair.near.socket(), std::string_view("\x40\0\0\0", 4));
  (void)pair.far.socket().wait(soon());
  EXPECT_EQ(error_of([&] { (void)pair.far.receive(); }),
            "announces a message of 1073741824 bytes, the longest may have 1000");
}

TEST(Connection, GivesWhatCameBeforeTheEnd) {
  Pair pair;
  pair.near.send("last words");
  { const Connection gone = std::move(pair.near); }
  EXPECT_EQ(pair.far.receive_until(soon()), "last words");
  EXPECT_EQ(error_of([&] { (void)pair.far.receive_until(soon()); }), "closed the connection");
}

TEST(Connection, KeepsWhatThePeerDoesNotTake) {
  Pair pair(20'000'000);
  pair.near.send(std::string(10'000'000, 'x'));
  EXPECT_FALSE(pair.near.flush());
  EXPECT_EQ(error_of([&] { pair.near.flush_until(std::chrono::steady_clock::now() + 20ms); }),
            "does not take what it is sent");
  std::size_t received = 0;
  while (received == 0) {
    pair.near.flush();
    if (const auto message = pair.far.receive()) received = message->size();
  }
  EXPECT_EQ(received, 10'000'000U);
  EXPECT_TRUE(pair.near.flush());
}

TEST(Connection, DoesNotWaitLongerThanItIsTold) {
  Pair pair;
  EXPECT_EQ(error_of([&] { (void)pair.far.receive_until(std::chrono::steady_clock::now() + 20ms); }),
            "did not answer in time");
}

}  // namespace
}  // namespace murosimf::network
