// A service of ROS 2 and two clients by Fast DDS, on 127.0.0.1: each finds the answers to its own requests, as rmw_fastrtps does.
#include "murosimf/dds/ros2/service.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "murosimf/model/error.h"

namespace murosimf::dds::ros2 {
namespace {

using namespace std::chrono_literals;

int own_domain() { return 1 + getpid() % 99; }

class Client {
 public:
  Client()
      : participant_(own_domain()),
        requests_(participant_.writer(
            {.name = "rq/doubleRequest", .type = "test::srv::dds_::Double_Request_", .reliable = true})) {
    participant_.read({.name = "rr/doubleReply", .type = "test::srv::dds_::Double_Response_", .reliable = true}, inbox_,
                      'r');
  }
  [[nodiscard]] bool is_ready() { return requests_.has_readers() && inbox_.writers() > 0; }
  void ask(std::uint32_t number) {
    CdrWriter out;
    requests_.write(out.number(number).bytes());
  }
  std::vector<Arrival> answers() {
    std::vector<Arrival> all = inbox_.take();
    std::erase_if(all, [this](const Arrival& one) { return is_known_ && one.request.writer != own_; });
    return all;
  }
  /// As a client that knows its own writer does.
  void know_own(const SampleIdentity& of) { own_ = of.writer, is_known_ = true; }

 private:
  Inbox inbox_;
  Participant participant_;
  TopicWriter& requests_;
  std::array<std::uint8_t, 16> own_{};
  bool is_known_ = false;
};

TEST(Service, AnswersWithTheIdentityOfTheRequest) {
  Inbox inbox;
  try {
    const Participant any(own_domain());
  } catch (const SetupError& error) {
    GTEST_SKIP() << error.what();
  }
  Participant participant(own_domain());
  Service service(participant, "/double", "test/srv/Double", inbox, 'q');
  Client one, other;
  for (int i = 0; i < 5000 && !(one.is_ready() && other.is_ready()); ++i) std::this_thread::sleep_for(1ms);
  one.ask(21);
  one.ask(22);
  std::vector<Arrival> requests;
  for (int i = 0; i < 5000 && requests.size() < 2; ++i) {
    std::this_thread::sleep_for(1ms);
    for (const Arrival& request : inbox.take()) requests.push_back(request);
  }
  ASSERT_EQ(requests.size(), 2U);
  for (const Arrival& request : requests) {
    ServiceCall call;
    ASSERT_TRUE(open_call(request.message, request.from, call));
    EXPECT_FALSE(call.has_header);
    CdrWriter out;
    service.answer(call, out.number(2 * CdrReader(call.request).number<std::uint32_t>()).bytes());
  }
  one.know_own(requests[0].from);
  std::vector<Arrival> answers;
  for (int i = 0; i < 5000 && answers.size() < 2; ++i) {
    std::this_thread::sleep_for(1ms);
    for (const Arrival& answer : one.answers()) answers.push_back(answer);
  }
  ASSERT_EQ(answers.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(answers[i].request.number, requests[i].from.number);
    EXPECT_EQ(CdrReader(answers[i].message).number<std::uint32_t>(), 42 + 2 * i);
  }
}

}  // namespace
}  // namespace murosimf::dds::ros2
