// Supervision over TCP: a run is steered by clients that know the token, what cannot be done is told in one line, and what supervisors do wrong
// disturbs neither the run nor the others.
#include "murosimf/supervise/supervision.h"

#include <gtest/gtest.h>
#include <supervision.pb.h>
#include <sys/socket.h>

#include <cmath>
#include <filesystem>
#include <mutex>
#include <thread>

#include "murosimf/network/connection.h"
#include "tests/fixtures.h"

namespace murosimf::supervise {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;
using wire::FromSupervisor;
using wire::ToSupervisor;

const std::vector<std::string> simplified{"walker.level=simplified_dynamics"};

network::WallTime soon() { return std::chrono::steady_clock::now() + 20s; }

std::uint64_t hash_at(Duration time, std::vector<std::string> events = {}) {
  scene::Scene scene("walk", {.overrides = simplified, .events = std::move(events), .pushable = true});
  scene.simulation().run(time);
  return scene.simulation().state_hash();
}

/// A run that is supervised, in a thread of its own, paused at first.
class SupervisedRun {
 public:
  explicit SupervisedRun(SupervisionOptions options = {})
      : scene("walk", {.overrides = simplified, .pushable = true}), session(scene, {.paused = true}) {
    options.say = [this](const std::string& line) {
      const std::lock_guard lock(mutex_);
      lines_.push_back(line);
    };
    supervision = supervise(session, options);
    thread_ = std::thread([this] { session.run(10s); });
  }
  ~SupervisedRun() { finish(); }

  void finish() {
    session.finish();
    join();
    supervision.reset();
  }
  void join() {
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] std::vector<std::string> lines(std::size_t count) const {
    const network::WallTime end = soon();
    for (;;) {
      {
        const std::lock_guard lock(mutex_);
        if (lines_.size() >= count || std::chrono::steady_clock::now() > end) return lines_;
      }
      std::this_thread::sleep_for(2ms);
    }
  }
  [[nodiscard]] std::uint64_t hash() {
    std::uint64_t hash = 0;
    session.visit([&](scene::Scene& seen) { hash = seen.simulation().state_hash(); }).get();
    return hash;
  }

  scene::Scene scene;
  session::Session session;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;

 public:
  std::unique_ptr<Supervision> supervision;

 private:
  std::thread thread_;
};

class Client {
 public:
  explicit Client(const SupervisedRun& run)
      : connection_(network::Socket::connect(run.supervision->address()), 1 << 26) {}
  Client(const SupervisedRun& run, const std::string& token, unsigned version = 1) : Client(run) {
    FromSupervisor message;
    message.mutable_hello()->set_version(version);
    message.mutable_hello()->set_token(token);
    message.mutable_hello()->set_name("test");
    send(message);
    first = receive();
  }

  void send(const FromSupervisor& message) {
    connection_.send(message.SerializeAsString());
    connection_.flush_until(soon());
  }
  void bytes(std::string_view text) const { (void)connection_.socket().send(text); }
  ToSupervisor receive() {
    ToSupervisor message;
    const std::string_view bytes = connection_.receive_until(soon());
    EXPECT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
    return message;
  }
  template <class Fill>
  ToSupervisor ask(const Fill& fill) {
    FromSupervisor message;
    fill(message);
    send(message);
    return receive();
  }
  ToSupervisor advance(Duration duration) {
    return ask([&](FromSupervisor& m) { m.mutable_advance()->set_duration(duration.count()); });
  }
  ToSupervisor change(const std::string& text) {
    return ask([&](FromSupervisor& m) { m.mutable_change()->add_changes(text); });
  }
  std::vector<double> read(const std::string& pattern) {
    const ToSupervisor answer = ask([&](FromSupervisor& m) { m.mutable_read()->add_patterns(pattern); });
    EXPECT_TRUE(answer.has_numbers()) << answer.refused().reason();
    return {answer.numbers().values().begin(), answer.numbers().values().end()};
  }
  /// Until the simulator closes the connection; the last reason that it gave.
  std::string end() {
    std::string reason = first.refused().reason();
    try {
      for (;;) {
        const ToSupervisor message = receive();
        if (message.has_refused()) reason = message.refused().reason();
      }
    } catch (const network::NetworkError&) {  // closed
    }
    return reason;
  }
  [[nodiscard]] const network::Connection& connection() const { return connection_; }

  ToSupervisor first;

 private:
  network::Connection connection_;
};

TEST(Supervision, HasTheRunGoOnExactlySoFar) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  EXPECT_EQ(client.first.welcome().scene(), run.scene.spec().name);
  EXPECT_EQ(client.first.welcome().tick(), 1'000'000);
  EXPECT_TRUE(client.first.welcome().status().paused());
  for (int i = 1; i <= 10; ++i) {
    const ToSupervisor answer = client.advance(100ms);
    EXPECT_EQ(answer.status().time(), i * 100'000'000);
    EXPECT_TRUE(answer.status().paused());
  }
  EXPECT_EQ(run.hash(), hash_at(1s));
  EXPECT_TRUE(client.ask([](FromSupervisor& m) { m.mutable_step()->set_count(7); }).has_status());
  EXPECT_EQ(client.advance(3ms).status().time() % 1'000'000, 0);
}

TEST(Supervision, PausesAndGoesOnAtAnySpeed) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  EXPECT_EQ(client.ask([](FromSupervisor& m) { m.mutable_speed()->set_factor(0.5); }).status().speed(), 0.5);
  EXPECT_TRUE(
      says(client.ask([](FromSupervisor& m) { m.mutable_speed()->set_factor(-1); }).refused().reason(), {"-1"}));
  client.ask([](FromSupervisor& m) { m.mutable_go_on(); });
  ToSupervisor answer = client.ask([](FromSupervisor& m) { m.mutable_status(); });
  while (answer.status().time() == 0) answer = client.ask([](FromSupervisor& m) { m.mutable_status(); });
  EXPECT_FALSE(answer.status().paused());
  client.ask([](FromSupervisor& m) { m.mutable_pause(); });
  answer = client.ask([](FromSupervisor& m) { m.mutable_status(); });
  EXPECT_TRUE(answer.status().paused());
  EXPECT_EQ(client.ask([](FromSupervisor& m) { m.mutable_status(); }).status().time(), answer.status().time());
}

// The changes are those of events: the same run again.
TEST(Supervision, ChangesPushesAndPlacesAsEventsDo) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(200ms);
  EXPECT_TRUE(client.change("walker.torso.push = [20, 0, 0, 0.1]").has_status());
  client.advance(200ms);
  EXPECT_TRUE(client.change("walker.level = full_dynamics").has_status());
  client.advance(200ms);
  EXPECT_TRUE(client.change("walker.place = [1, -0.5, 0, 0.5]").has_status());
  client.advance(400ms);
  EXPECT_EQ(run.hash(), hash_at(1s, {"0.2:walker.torso.push=[20, 0, 0, 0.1]", "0.4:walker.level=full_dynamics",
                                     "0.6:walker.place=[1, -0.5, 0, 0.5]"}));
  const ToSupervisor events = client.ask([](FromSupervisor& m) { m.mutable_events(); });
  ASSERT_GE(events.events().events_size(), 3);
  EXPECT_EQ(events.events().events(0).time(), 200'000'000);
  const ToSupervisor none = client.ask([](FromSupervisor& m) { m.mutable_events()->set_first(1'000'000); });
  EXPECT_EQ(none.events().events_size(), 0);
}

TEST(Supervision, MakesAllChangesOfARequestOrNone) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(200ms);
  const auto change = [&](const std::vector<std::string>& all) {
    return client.ask([&](FromSupervisor& m) { m.mutable_change()->mutable_changes()->Add(all.begin(), all.end()); });
  };
  const std::uint64_t hash = run.hash();
  const std::string push = "walker.torso.push = [20, 0, 0, 0.1]", place = "walker.place = [1, -0.5, 0, 0.5]";
  const std::string level = "walker.level = full_dynamics", command = "walker.command = [0, 0, 0.5]";
  EXPECT_TRUE(
      says(change({push, place, level, command, "wolker.level = full_dynamics"}).refused().reason(), {"wolker"}));
  EXPECT_TRUE(says(change({place, command, "walker.present = false", push, place}).refused().reason(), {"walker"}));
  EXPECT_EQ(run.hash(), hash);
  EXPECT_EQ(client.read("walker.torso.position"), client.read("walker.torso.position"));
  client.advance(200ms);
  EXPECT_EQ(run.hash(), hash_at(400ms)) << "as without the requests";
  EXPECT_TRUE(change({push, command}).has_status());
  client.advance(200ms);
  EXPECT_EQ(run.hash(), hash_at(600ms, {"0.4:" + push, "0.4:" + command}));
}

TEST(Supervision, SaysWhatWillNotGoOnAsItWas) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  run.session.visit([](scene::Scene& scene) { scene.parts().outside.memory->expect("the GameController"); }).get();
  client.advance(500ms);
  const auto seek = [&](Duration time) {
    return client.ask([&](FromSupervisor& m) { m.mutable_seek()->set_time(time.count()); }).status().diagnostic();
  };
  EXPECT_EQ(seek(300ms),
            "the GameController keeps its own state: from 0.3 s on this is not the run that was there before");
  EXPECT_EQ(seek(500ms), "");
  EXPECT_NE(seek(100ms), "");
  EXPECT_EQ(client.advance(100ms).status().warnings(), 1U);
}

TEST(Supervision, TellsWhatCannotBe) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  EXPECT_TRUE(says(client.change("wolker.level = full_dynamics").refused().reason(), {"wolker", "walker"}));
  EXPECT_TRUE(says(client.change("walker.level = ful_dynamics").refused().reason(), {"full_dynamics"}));
  EXPECT_TRUE(says(client.change("nonsense").refused().reason(), {"nonsense"}));
  EXPECT_TRUE(says(client.change("walker.torso.push = [nan, 0, 0, 1]").refused().reason(), {"push"}));
  const auto read = [&](const std::string& pattern) {
    return client.ask([&](FromSupervisor& m) { m.mutable_read()->add_patterns(pattern); }).refused().reason();
  };
  EXPECT_TRUE(says(read("walker.imu.gyroskope"), {"did you mean 'gyroscope'"}));
  EXPECT_NE(read(""), "");
  EXPECT_TRUE(says(client.advance(-1s).refused().reason(), {"the duration is -1 s"}));
  const auto seek = [&](std::int64_t time, int branch) {
    return client
        .ask([&](FromSupervisor& m) { m.mutable_seek()->set_time(time), m.mutable_seek()->set_branch(branch); })
        .refused()
        .reason();
  };
  EXPECT_NE(seek(5'000'000'000, 0), "");
  EXPECT_NE(seek(0, 99), "");
  EXPECT_NE(seek(-1, 0), "");
  EXPECT_EQ(client.advance(10ms).status().time(), 10'000'000) << "it goes on";
}

TEST(Supervision, ReadsSensorsAndPropertiesOfOneInstant) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(500ms);
  const std::vector<double> torso = client.read("walker.torso.position");
  ASSERT_EQ(torso.size(), 3U);
  EXPECT_NEAR(torso[2], 0.35, 0.2);
  EXPECT_EQ(client.read("walker.torso.position"), torso) << "as known";
  EXPECT_EQ(client.read("walker.joint_position").size(), 21U);
  const ToSupervisor answer = client.ask([](FromSupervisor& m) { m.mutable_read()->add_patterns("walker.imu.gyro*"); });
  EXPECT_EQ(answer.numbers().time(), 500'000'000);
  EXPECT_TRUE(says(answer.numbers().names(0), {"walker.imu.gyroscope.x [rad/s]"}));
  const ToSupervisor scene = client.ask([](FromSupervisor& m) { m.mutable_describe(); });
  bool found = false;
  for (const wire::SceneEntity& entity : scene.description().entities()) {
    if (entity.name() != "walker") continue;
    found = true;
    EXPECT_EQ(entity.level(), "simplified_dynamics");
    EXPECT_EQ(entity.model(), "kid21");
    EXPECT_GT(entity.objects_size(), 21);
  }
  EXPECT_TRUE(found);
}

TEST(Supervision, GoesBackInTimeAndToTheStart) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(1s);
  client.change("walker.command = [0, 0, 0.5]");
  client.advance(1s);
  ToSupervisor answer = client.ask([](FromSupervisor& m) { m.mutable_seek()->set_time(1'000'000'000); });
  EXPECT_EQ(answer.status().time(), 1'000'000'000);
  EXPECT_EQ(answer.status().jumps(), 1U);
  client.advance(1s);
  EXPECT_EQ(run.hash(), hash_at(2s));
  const ToSupervisor branches = client.ask([](FromSupervisor& m) { m.mutable_branches(); });
  ASSERT_EQ(branches.branches().branches_size(), 2);
  EXPECT_EQ(branches.branches().branches(0).commands(0).text(), "walker.command = [0, 0, 0.5]");
  EXPECT_EQ(branches.branches().branches(1).parent(), 0);
  answer = client.ask([](FromSupervisor& m) { m.mutable_reset(); });
  EXPECT_EQ(answer.status().time(), 0);
  client.advance(1s);
  EXPECT_EQ(run.hash(), hash_at(1s));
}

TEST(Supervision, SavesAState) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(500ms);
  const std::string state = client.ask([](FromSupervisor& m) { m.mutable_save(); }).state().content();
  scene::Scene other("walk", {.overrides = simplified, .pushable = true});
  other.load(std::as_bytes(std::span(state)));
  other.simulation().run(500ms);
  EXPECT_EQ(other.simulation().state_hash(), hash_at(1s));
}

/// Sends a state in parts of so many bytes; the last answer.
ToSupervisor load(Client& client, std::string_view state, std::size_t part = 1000) {
  ToSupervisor answer;
  do {
    answer = client.ask([&](FromSupervisor& message) {
      message.mutable_load()->set_content(std::string(state.substr(0, part)));
      state.remove_prefix(std::min(part, state.size()));
      message.mutable_load()->set_last(state.empty());
    });
  } while (!state.empty());
  return answer;
}

// From the state of another run it goes on as that one, on a branch of its own, in which one can go back.
TEST(Supervision, GoesOnFromAStateOfAnotherRun) {
  scene::Scene other("walk", {.overrides = simplified, .pushable = true});
  other.simulation().run(500ms);
  (void)other.post("walker.level = full_dynamics");
  other.simulation().run(500ms);
  const std::vector<std::byte> bytes = other.save();
  const std::string state(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  other.simulation().run(1s);

  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(300ms);
  const ToSupervisor answer = load(client, state);
  ASSERT_TRUE(answer.has_status()) << answer.refused().reason();
  EXPECT_EQ(Duration(answer.status().time()), 1s);
  EXPECT_TRUE(answer.status().paused());
  EXPECT_EQ(answer.status().branch(), 1);
  client.advance(1s);
  EXPECT_EQ(run.hash(), other.simulation().state_hash());
  run.session.seek(1200ms).get();
  client.advance(800ms);
  EXPECT_EQ(run.hash(), other.simulation().state_hash());
}

TEST(Supervision, GoesOnFromNothingThatIsNoState) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  client.advance(300ms);
  const std::uint64_t hash = run.hash();
  EXPECT_TRUE(load(client, "no state at all").has_refused());
  const std::vector<std::byte> bytes = run.scene.save();  // paused
  const std::string state(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_TRUE(load(client, state.substr(0, state.size() / 2)).has_refused()) << "half of one";
  EXPECT_EQ(run.hash(), hash);
  {
    Client gone(run, run.supervision->token());
    (void)gone.ask([&](FromSupervisor& message) { message.mutable_load()->set_content(state.substr(0, 1000)); });
  }
  EXPECT_TRUE(load(client, state).has_status()) << "what others have begun is not its own";
  EXPECT_EQ(run.hash(), hash);
}

TEST(Supervision, TakesNoStateWithoutEnd) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  const std::string part(64'000, 'x');
  const auto send = [&] {
    return client.ask([&](FromSupervisor& message) { message.mutable_load()->set_content(part); });
  };
  std::size_t sent = 0;
  ToSupervisor answer = send();
  while (answer.has_status() && sent < 2 * longest_state) {
    sent += part.size();
    answer = send();
  }
  EXPECT_TRUE(says(answer.refused().reason(), {"a state of more than 268435456 bytes"}));
  EXPECT_GT(sent, longest_state - part.size());
  EXPECT_TRUE(send().has_status()) << "it begins anew";
}

ToSupervisor ask_for_scene(Client& client, const std::string& scene) {
  return client.ask([&](FromSupervisor& message) { message.mutable_load_scene()->set_scene(scene); });
}

// Supervisors stay when another session takes the place of theirs; one that is refused leaves everything as it is.
TEST(Supervision, StaysWhileRunsFollowEachOther) {
  std::string wanted;
  SupervisedRun first({.exchange = [&](const SceneRequest& request) {
    if (request.scene != "nudge") throw SetupError("no such scene");
    wanted = request.scene;
  }});
  Client client(first, first.supervision->token()), other(first, first.supervision->token());
  client.advance(300ms);
  EXPECT_EQ(ask_for_scene(client, "nudje").refused().reason(), "no such scene");
  EXPECT_EQ(Duration(client.advance(100ms).status().time()), 400ms);

  ToSupervisor welcome;
  std::thread asks([&] { welcome = ask_for_scene(client, "nudge"); });
  first.join();
  EXPECT_EQ(wanted, "nudge");
  first.supervision->leave();
  scene::Scene scene("nudge", {.pushable = true});
  session::Session second(scene, {.paused = true});
  first.supervision->steer(second);
  std::thread runs([&] { second.run(10s); });
  asks.join();
  EXPECT_EQ(welcome.welcome().scene(), scene.spec().name);
  EXPECT_EQ(welcome.welcome().status().time(), 0);
  EXPECT_EQ(Duration(other.advance(200ms).status().time()), 200ms) << "the others stay, too";
  EXPECT_FALSE(other.read("robot.torso.position").empty());
  second.finish();
  runs.join();
  first.supervision->leave();
}

TEST(Supervision, RefusesInOneLine) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  const auto answer =
      client.ask([](FromSupervisor& m) { m.mutable_change()->add_changes("a = 1\nwalker.library = b"); });
  EXPECT_TRUE(says(answer.refused().reason(), {"a = 1 walker.library = b"}));
}

TEST(Supervision, KeepsItsSceneWhereNobodyExchangesIt) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  EXPECT_EQ(ask_for_scene(client, "nudge").refused().reason(), "this run keeps its scene");
}

TEST(Supervision, HasNothingRecordedWhereNobodyCanAsk) {
  SupervisedRun run;
  Client client(run, run.supervision->token());
  EXPECT_FALSE(client.ask([](FromSupervisor& m) { m.mutable_status(); }).status().has_recorded());
  EXPECT_TRUE(says(client.ask([](FromSupervisor& m) { m.mutable_record()->set_on(true); }).refused().reason(),
                   {"--record-on asked"}));
}

TEST(Supervision, EndsTheRun) {
  SupervisedRun run;
  Client client(run, run.supervision->token()), other(run, run.supervision->token());
  FromSupervisor finish;
  finish.mutable_finish();
  client.send(finish);
  run.finish();
  ToSupervisor last;
  try {
    for (;;) last = other.receive();
  } catch (const network::NetworkError&) {
  }
  EXPECT_TRUE(last.has_goodbye());
}

TEST(SupervisionFaults, WhoDoesNotKnowTheTokenIsRefused) {
  SupervisedRun run;
  std::string almost = run.supervision->token();
  EXPECT_EQ(almost.size(), 32U);
  almost.back() = almost.back() == '0' ? '1' : '0';
  for (const std::string& token : {std::string(), almost, run.supervision->token() + "0"}) {
    EXPECT_EQ(Client(run, token).end(), "it does not know the token");
  }
  EXPECT_TRUE(says(Client(run, run.supervision->token(), 2).end(), {"speaks version 2 of the protocol"}));
  const std::vector<std::string> lines = run.lines(4);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(says(lines[0], {"supervisor 127.0.0.1:", "was refused: it does not know the token"}));
  const SupervisedRun another;
  EXPECT_NE(another.supervision->token(), run.supervision->token());
  EXPECT_TRUE(says(error_of([] { SupervisedRun({.token = "short"}); }), {"has 5 characters; at least 8 are needed"}));
}

std::size_t open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// A run of a second by another supervisor, while one makes this error; the line that was told, if there is to be one.
template <class Error>
std::string while_somebody(const Error& error, std::size_t lines = 1) {
  const std::size_t files = open_files();
  std::string told;
  {
    SupervisedRun run({.patience = 0.2});
    {
      Client good(run, run.supervision->token());
      Client bad(run, run.supervision->token());
      for (int i = 0; i < 5; ++i) good.advance(100ms);
      error(bad);
      for (int i = 0; i < 5; ++i) good.advance(100ms);
      EXPECT_EQ(run.hash(), hash_at(1s));
      const std::vector<std::string> all = run.lines(lines);
      EXPECT_EQ(all.size(), lines);
      if (!all.empty()) told = all[0];
    }
    run.finish();
  }
  EXPECT_EQ(open_files(), files);
  return told;
}

TEST(SupervisionFaults, GarbageAndTheLike) {
  EXPECT_TRUE(says(while_somebody([](Client& c) { c.bytes(std::string("\x40\0\0\0", 4)); }),
                   {"supervisor test at 127.0.0.1:", "was dropped: it announces a message of 1073741824 bytes"}));
  EXPECT_TRUE(says(while_somebody([](Client& c) { c.bytes(std::string(100, '\0')); }),
                   {"was dropped: it sends what is no message of this protocol"}));
  EXPECT_TRUE(says(while_somebody([](Client& c) {
                     FromSupervisor message;
                     message.mutable_hello();
                     c.send(message);
                   }),
                   {"was dropped: it sends what is no request of this protocol"}));
  EXPECT_EQ(while_somebody([](Client& c) { ::shutdown(c.connection().socket().number(), SHUT_WR); }, 0), "");
  EXPECT_EQ(while_somebody([](Client& c) { c.bytes(std::string("\0\0\0\x20half", 8)); }, 0), "");
}

// What it has asked for does not fit into sockets' buffers.
TEST(SupervisionFaults, ReadsNothing) {
  EXPECT_TRUE(says(while_somebody([](Client& c) {
                     FromSupervisor message;
                     message.mutable_save();
                     try {
                       for (int i = 0; i < 2000; ++i) c.send(message);
                     } catch (const network::NetworkError&) {  // dropped
                     }
                   }),
                   {"was dropped: it does not take what it is sent"}));
}

TEST(SupervisionFaults, GoesWhileItWaits) {
  SupervisedRun run;
  {
    Client client(run, run.supervision->token());
    client.ask([](FromSupervisor& m) { m.mutable_speed()->set_factor(0.001); });
    FromSupervisor message;
    message.mutable_advance()->set_duration(1'000'000'000);
    client.send(message);
  }
  Client other(run, run.supervision->token());
  EXPECT_TRUE(other.ask([](FromSupervisor& m) { m.mutable_pause(); }).has_status());
}

TEST(SupervisionFaults, TooManyAreRefusedAndMakeRoomAgain) {
  SupervisedRun run;
  std::vector<std::unique_ptr<Client>> all;
  for (std::size_t i = 0; i < most_supervisors; ++i) {
    all.push_back(std::make_unique<Client>(run, run.supervision->token()));
    EXPECT_TRUE(all.back()->first.has_welcome());
  }
  EXPECT_TRUE(says(Client(run, run.supervision->token()).end(), {"comes when 8 others are there"}));
  all.pop_back();
  const network::WallTime end = soon();
  bool welcome = false;
  while (!welcome && std::chrono::steady_clock::now() < end) {
    welcome = Client(run, run.supervision->token()).first.has_welcome();
  }
  EXPECT_TRUE(welcome);
}

TEST(SupervisionFaults, AHundredStrangersAtOnceKeepNobodyOut) {
  const std::size_t files = open_files();
  {
    SupervisedRun run;
    std::vector<Client> strangers;
    for (int i = 0; i < 100; ++i) strangers.emplace_back(run);
    Client client(run, run.supervision->token());
    EXPECT_EQ(client.advance(100ms).status().time(), 100'000'000);
    EXPECT_GE(run.lines(100 - 64).size(), 100U - 64U);
  }
  EXPECT_EQ(open_files(), files);
}

TEST(SupervisionFaults, ThePortIsInUse) {
  const SupervisedRun run;
  EXPECT_TRUE(says(error_of([&] { SupervisedRun({.address = run.supervision->address()}); }),
                   {"cannot listen on 127.0.0.1:", "the port is in use"}));
}

}  // namespace
}  // namespace murosimf::supervise
