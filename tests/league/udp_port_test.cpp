// Datagrams over the loopback: sent, answered, refused.
#include "murosimf/league/udp_port.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fixtures.h"
#include "tests/league/until.h"

namespace murosimf::league {
namespace {

using Texts = std::vector<std::string>;

TEST(UdpAddress, IsAPortOfThisMachineOrOfAnother) {
  EXPECT_EQ(UdpAddress::parse("3838"), (UdpAddress{"127.0.0.1", 3838}));
  EXPECT_EQ(UdpAddress::parse("0.0.0.0:3838"), (UdpAddress{"0.0.0.0", 3838}));
  for (const std::string wrong : {"", "x", "1.2.3.4:", "1.2.3.4:70000", "3838x", "-1", "1.2.3.4:5:"}) {
    EXPECT_TRUE(
        fixtures::says(fixtures::error_of([&] { (void)UdpAddress::parse(wrong); }), {"'" + wrong + "' is no place"}));
  }
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)UdpAddress::parse("example.org:1"); }),
                             {"'example.org' is no address of a machine"}));
}

TEST(UdpPort, TakesWhatIsSentInItsOrderAndNotTooMuchAtOnce) {
  UdpPort port({});
  UdpPort sender({.listen = {}, .send_to = UdpAddress{"127.0.0.1", port.port()}});
  EXPECT_EQ(port.take({}), Texts{});  // does not wait
  const std::string large(60'000, 'x');
  sender.give("one");
  sender.give("");
  sender.give(large);
  EXPECT_EQ(all_of(port, 3), (Texts{"one", "", large}));
  for (int i = 0; i < 40; ++i) sender.give("more");
  EXPECT_EQ(until([&] { return port.take({}); }).size(), std::size_t{UdpPort::most_at_once});
}

TEST(UdpPort, AnswersWhoHasSentLast) {
  UdpPort answers({});
  UdpPort port({.answer_port = answers.port()});
  port.give("no receiver");  // goes nowhere
  UdpPort sender({.listen = {}, .send_to = UdpAddress{"127.0.0.1", port.port()}});
  sender.give("hello");
  EXPECT_EQ(all_of(port, 1), Texts{"hello"});
  port.give("you");
  EXPECT_EQ(all_of(answers, 1), Texts{"you"});
}

TEST(UdpPort, SaysWhenAnAddressIsInUse) {
  const UdpPort first({});
  const std::string message = fixtures::error_of([&] { UdpPort({.listen = {"127.0.0.1", first.port()}}); });
  EXPECT_EQ(message, "no datagrams at 127.0.0.1:" + std::to_string(first.port()) + ": Address already in use");
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] {
                               UdpPort({.listen = {"203.0.113.1", 4000}});
                             }),
                             {"no datagrams at 203.0.113.1:4000: Cannot assign requested address"}));
}

TEST(UdpPort, LeavesNoDescriptorOpen) {
  const auto open = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
  };
  const auto before = open();
  for (int i = 0; i < 50; ++i) {
    const UdpPort port({});
    (void)fixtures::error_of([&] { UdpPort({.listen = {"127.0.0.1", port.port()}}); });
  }
  EXPECT_EQ(open(), before);
}

}  // namespace
}  // namespace murosimf::league
