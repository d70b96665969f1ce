// Messages of a team over TCP: equal to those of libraries, bit for bit, and refused in the same cases.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/network/tcp_fixture.h"
#include "tests/written_scene.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

const std::vector<std::string> robots{"blue1", "blue2", "blue3", "red1", "red2", "red3"};
const std::vector<std::string> unsteady{"start.jitter_position=0",       "red.*.level=kinematic_walking",
                                        "communication.loss=0.2",        "communication.jitter=0.05",
                                        "communication.bandwidth=20000", "communication.messages_per_second=50"};

/// As tests/control_software/radio_controller.cpp, by the client library.
void talk(const std::string& name, std::uint16_t port) {
  client::RobotClient robot({.robot = name, .port = port, .rate = 50});
  robot.use_messages();
  auto& target = robot.command("joint.target");
  const auto head = static_cast<std::size_t>(std::ranges::find(target.labels, "j_head") - target.labels.begin());
  double heard = 0;
  long steps = 0;
  while (robot.next()) {
    if (robot.starts()) {
      EXPECT_TRUE(robot.messages().empty());
      continue;
    }
    for (const client::TeamMessage& message : robot.messages()) {
      heard += static_cast<unsigned char>(message.bytes[0]) + 0.001 * static_cast<double>(message.sender[0]);
      EXPECT_EQ(message.sender.substr(0, 3), name.substr(0, 3));
      EXPECT_LT(message.sent, robot.now());
    }
    target.values[head] = 0.3 * (heard / 50 - std::floor(heard / 50));
    robot.send_message(std::string(8, static_cast<char>('A' + steps++ % 26)));
  }
  EXPECT_GT(heard, 0);
}

TEST(TcpMessages, GiveTheStateOfALibraryThatSendsTheSame) {
  std::vector<std::string> library = unsteady, tcp = unsteady;
  for (const std::string& robot : robots) {
    library.push_back(robot + ".controller=library");
    library.push_back(robot + ".library=" MUROSIMF_CONTROLLERS "/controller_radio.so");
    tcp.push_back(robot + ".controller=tcp");
  }
  scene::Scene inside("three_on_three", {.overrides = library, .cameras = false});
  inside.simulation().run(2s);
  for (const int threads : {1, 3}) {
    const Listener listener;
    std::vector<std::unique_ptr<Software>> all;
    for (const std::string& robot : robots) {
      all.push_back(std::make_unique<Software>([&, robot] { talk(robot, listener.port()); }));
    }
    {
      scene::Scene scene("three_on_three", two_robots(listener, tcp, threads));
      scene.simulation().run(2s);
      EXPECT_EQ(scene.simulation().state_hash(), inside.simulation().state_hash()) << threads << " threads";
      EXPECT_EQ(software(scene, "blue1").messages->sent, software(inside, "blue1").messages->sent);
      EXPECT_EQ(software(scene, "blue1").messages->arrived, software(inside, "blue1").messages->arrived);
    }
    for (const auto& each : all) EXPECT_EQ(each->error(), "");
  }
}

/// One robot of a team of one, with a raw client.
template <class Client>
void alone(const Client& client, const std::string& team = "blue") {
  const Listener listener;
  Software software([&] {
    RawClient raw(listener.port());
    client(raw);
  });
  const auto file =
      ::murosimf::fixtures::write_scene("[[teams]]\nname = 'blue'\n[[robots]]\nname = 'one'\nmodel = 'kid21'\n" +
                                        (team.empty() ? "" : "team = '" + team + "'\n") +
                                        "controller = 'tcp'\ncontrol_rate = 10\noptions = {limit = 5}\n");
  {
    scene::Scene scene(file, two_robots(listener));
    scene.simulation().run(500ms);
  }
  EXPECT_EQ(software.error(), "");
}

wire::FromClient ask_for_messages() {
  wire::FromClient message;
  message.mutable_ask()->set_messages(true);
  return message;
}

TEST(TcpMessages, NeedATeam) {
  alone(
      [](RawClient& client) {
        client.hello("one");
        EXPECT_TRUE(client.receive().has_welcome());
        client.send(ask_for_messages());
        EXPECT_TRUE(says(client.receive().refusal().reason(), {"one is in no team"}));
        client.ready();
        for (;;) {
          const wire::ToClient message = client.receive();
          if (message.has_goodbye()) return;
          wire::FromClient answer;
          answer.mutable_commands()->set_cycle(message.cycle().cycle());
          client.send(answer);
        }
      },
      "");
}

TEST(TcpMessages, AreAskedForFirst) {
  alone([](RawClient& client) {
    client.come("one");
    wire::FromClient answer;
    answer.mutable_commands()->set_cycle(client.receive().cycle().cycle());
    answer.mutable_commands()->add_rows();
    client.send(answer);
    answer.mutable_commands()->set_cycle(client.receive().cycle().cycle());
    answer.mutable_commands()->add_sends("hello");
    client.send(answer);
    EXPECT_EQ(client.end(), "sends messages to its team, and has not asked for them");
  });
}

TEST(TcpMessages, AreRefusedAndCountedIfTooLong) {
  const Listener listener;
  Software software_of_one([&] {
    client::RobotClient robot({.robot = "blue1", .port = listener.port(), .rate = 10});
    robot.use_messages();
    while (robot.next()) robot.send_message(std::string(robot.now() == 0 ? 1401 : 10, 'x'));
  });
  scene::Scene scene("three_on_three", two_robots(listener, {"blue1.controller=tcp"}));
  scene.simulation().run(1s);
  EXPECT_GT(software(scene, "blue1").messages->refused, 0U);
  EXPECT_TRUE(says(software(scene, "blue1").first_refused_message, {"a message has 1401 bytes; 1400 are allowed"}));
}

}  // namespace
}  // namespace murosimf::control_software
