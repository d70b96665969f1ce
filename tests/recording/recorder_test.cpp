// Recordings hold what happened, and change nothing of it.
#include "murosimf/recording/recorder.h"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_repair.h"
#include "murosimf/scene/scene_report.h"
#include "tests/sanitizer.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;

std::filesystem::path run_recorded(const std::string& name, scene::Scene& scene, Duration time,
                                   RecorderOptions options = {}) {
  options.file = fixtures::temp_folder() / name;
  Recorder recorder(scene, options);
  scene.simulation().run(time);
  recorder.finish(make_report(scene));
  EXPECT_EQ(recorder.trouble(), "");
  return options.file;
}

std::map<std::string, int> counts_of(const McapReader& reader) {
  std::map<std::string, int> counts;
  for (const Channel& channel : reader.contents().channels) {
    const auto& all = reader.contents().statistics.channel_message_counts;
    const auto found = all.find(channel.id);
    counts[channel.topic] = found == all.end() ? 0 : static_cast<int>(found->second);
  }
  return counts;
}

TEST(Recorder, ChangesNoResult) {
  for (const std::string name : {"three_on_three", "nudge", "four_levels"}) {
    scene::Scene plain(name, {.threads = 2, .cameras = false}), recorded(name, {.threads = 2, .cameras = false});
    plain.simulation().run(700ms);
    run_recorded("same.mcap", recorded, 700ms, {.what = {recordable().begin(), recordable().end()}});
    EXPECT_EQ(plain.simulation().state_hash(), recorded.simulation().state_hash()) << name;
  }
}

TEST(Recorder, HasAFrameForEachInstantAndOneForTheEnd) {
  scene::Scene scene("nudge", {});
  const McapReader reader(
      run_recorded("frames.mcap", scene, 1234ms, {.rate = 50, .what = {"poses", "joints", "contacts", "hashes"}}));
  auto counts = counts_of(reader);
  EXPECT_EQ(counts["/tf"], 62 + 1);  // 0, 20, ... 1220, and 1234 ms
  EXPECT_EQ(counts["/joints"], 63);
  EXPECT_EQ(counts["/targets"], 63);
  EXPECT_EQ(counts["/contacts"], 63);
  EXPECT_EQ(counts["/state_hash"], 3);  // 0, 1, and 1.234 s
  EXPECT_EQ(reader.contents().statistics.end_time, 1'234'000'000U);
  EXPECT_EQ(counts.count("/sensors/robot/imu"), 0U) << "only if asked for";
}

TEST(Recorder, RecordsOnlyWhatIsAskedFor) {
  scene::Scene scene("nudge", {});
  const McapReader reader(run_recorded("imu.mcap", scene, 100ms, {.what = {"sensors"}}));
  for (const auto& [topic, count] : counts_of(reader)) EXPECT_EQ(topic.rfind("/sensors/robot/", 0), 0U) << topic;
  EXPECT_GT(counts_of(reader)["/sensors/robot/imu"], 10);
}

TEST(Recorder, LastPosesAreThoseOfTheWorld) {
  scene::Scene scene("walk", {});
  const McapReader reader(run_recorded("poses.mcap", scene, 500ms));
  Transformd base;
  std::string parent;
  reader.visit_messages(reader.contents().chunks.back(), [&](const Message& message) {
    if (reader.contents().channels.at(message.channel_id - 1U).topic != "/tf") return;
    ProtobufReader transforms(message.data);
    ASSERT_TRUE(transforms.next());  // the first: the base of the first entity that moves
    for (ProtobufReader in = transforms.message(); in.next();) {
      if (in.field() == 2) parent = in.bytes();
      if (in.field() == 4) base.position = read_vector(in.message());
      if (in.field() == 5) base.orientation = read_rotation(in.message());
    }
  });
  EXPECT_EQ(parent, "world");
  const auto& entity = *scene.moving_entities().front();
  const Vec3d r = entity.find(properties::position)->values[0];
  const Mat3d R = entity.find(properties::orientation)->values[0];
  EXPECT_LT(norm(base.position - r), pose_step);
  EXPECT_LT(norm(base.orientation.x - R.x), 4 * pose_step);
  EXPECT_GT(norm(r), 0.2);
}

TEST(Recorder, SaysEventsWhenTheyHappen) {
  scene::Scene scene("walk", {.events = {"0.2:walker.level=simplified_dynamics"}});
  const McapReader reader(run_recorded("events.mcap", scene, 500ms));
  int found = 0;
  for (const ChunkIndex& chunk : reader.contents().chunks) {
    reader.visit_messages(chunk, [&](const Message& message) {
      if (reader.contents().channels.at(message.channel_id - 1U).topic != "/events") return;
      EXPECT_EQ(message.log_time, 200'000'000U);
      EXPECT_NE(message.data.find("simplified_dynamics"), std::string_view::npos);
      ++found;
    });
  }
  EXPECT_EQ(found, 1);
}

/// A process of its own records a run, and dies at this time of it as by kill -9.
void record_and_die(const std::filesystem::path& file, Duration time) {
  const pid_t child = ::fork();
  if (child == 0) {
    scene::Scene scene("walk", {});
    const Recorder recorder(scene, {.file = file});
    scene.simulation().at(time, [] { ::kill(::getpid(), SIGKILL); });
    scene.simulation().run(time + 1s);
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

// Columns come and go with levels; torques are there only where a level has them.
TEST(Recorder, FollowsAnExchangeOfLevels) {
  const std::vector<std::string> events = {"0.2:walker.level=articulated_dynamics",
                                           "0.4:walker.level=kinematic_walking",
                                           "0.6:walker.level=articulated_dynamics"};
  scene::Scene plain("walk", {.events = events}), scene("walk", {.events = events});
  plain.simulation().run(800ms);
  const McapReader reader(run_recorded("levels.mcap", scene, 800ms));
  EXPECT_EQ(plain.simulation().state_hash(), scene.simulation().state_hash());
  std::map<std::uint64_t, bool> has_torque;  // by time
  for (const ChunkIndex& chunk : reader.contents().chunks) {
    reader.visit_messages(chunk, [&](const Message& message) {
      if (reader.contents().channels.at(message.channel_id - 1U).topic != "/joints") return;
      for (ProtobufReader in(message.data); in.next();) {
        if (in.field() != 2) continue;
        for (ProtobufReader joint = in.message(); joint.next();) {
          if (joint.field() == 5) has_torque[message.log_time] = true;
        }
      }
    });
  }
  for (const auto& [time, expected] : std::map<std::uint64_t, bool>{
           {100'000'000, false}, {300'000'000, true}, {500'000'000, false}, {700'000'000, true}}) {
    EXPECT_EQ(has_torque.contains(time), expected) << time;
  }
}

// As fast as it can: what waits for the disk is lost, too.
TEST(Recorder, LosesAtMostASecondWhenItIsKilled) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Duration time = std::chrono::milliseconds(1000 + random() % 3000);
    const auto file = fixtures::temp_folder() / "killed.mcap", part = fixtures::temp_folder() / "killed.mcap.part";
    if (i == 25) std::ofstream(file) << "an older one";  // which stays
    record_and_die(file, time);
    const auto place = i < 25 ? file : part;
    EXPECT_NE(repair(place, place).damage, "");
    EXPECT_EQ(std::filesystem::file_size(file) == 12, i >= 25);
    const McapReader reader(place);
    EXPECT_EQ(reader.contents().damage, "");
    const Duration last(reader.contents().statistics.end_time);
    EXPECT_GE(last, time - 1s) << seconds(time);
    EXPECT_LE(last, time);
    std::filesystem::remove(place);
  }
}

// Whatever is left of it is made a whole file of all of its chunks that are there; where there is nothing, that is said.
TEST(Recorder, CutOffAnywhereItIsRepaired) {
  scene::Scene scene("walk", {.cameras = false});
  const McapReader whole(run_recorded("whole.mcap", scene, 3s));
  const auto cut = fixtures::temp_folder() / "cut.mcap";
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < fixtures::tries(200); ++i) {
    const std::uintmax_t size = random() % std::filesystem::file_size(whole.file());
    std::filesystem::copy_file(whole.file(), cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, size);
    std::uint64_t end = 0;  // [ns] of what is there
    for (const ChunkIndex& chunk : whole.contents().chunks) {
      if (chunk.offset + chunk.length <= size) end = std::max(end, chunk.end_time);
    }
    try {
      (void)repair(cut, cut);
      const McapReader reader(cut);
      EXPECT_EQ(reader.contents().damage, "") << size;
      EXPECT_EQ(reader.contents().statistics.end_time, end) << size;
    } catch (const SetupError& error) {
      ++refused;
      EXPECT_EQ(end, 0U) << size << ": " << error.what();
    }
  }
  EXPECT_LT(refused, 20);
}

TEST(Recorder, RefusesADiskThatIsFullFromTheBeginning) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  scene::Scene scene("walk", {});
  EXPECT_THROW(Recorder(scene, {.file = "/dev/full"}), SetupError);  // not even a header
}

TEST(Recorder, RefusesImpossibleRates) {
  scene::Scene scene("walk", {});
  for (const double rate : {0.0, -1.0, 2000.0}) {
    EXPECT_THROW(Recorder(scene, {.file = fixtures::temp_folder() / "rate.mcap", .rate = rate}), SetupError) << rate;
  }
}

TEST(RecordingThread, WritesAllInOrderHoweverSlowItIs) {
  std::vector<Duration> written;
  std::atomic<std::size_t> in_flight{0}, most{0};
  {
    RecordingThread thread([&](const RecordingThread::Batch& batch) {
      std::this_thread::sleep_for(2ms);
      for (const RecordedFrame& frame : batch) written.push_back(frame.time);
      --in_flight;
    });
    for (int i = 0; i < 50; ++i) {
      RecordingThread::Batch batch(1);
      batch[0].time = Duration(i);
      thread.push(std::move(batch));
      most = std::max<std::size_t>(most, ++in_flight);
    }
  }
  ASSERT_EQ(written.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(written[static_cast<std::size_t>(i)], Duration(i));
  EXPECT_LE(most, RecordingThread::most_waiting + 2) << "the queue is bounded";
}

TEST(RecordingThread, GivesBackWhatWasWritten) {
  RecordingThread thread([](const RecordingThread::Batch&) {});
  for (int i = 0; i < 4; ++i) thread.push(RecordingThread::Batch(3));
  thread.finish();
  EXPECT_EQ(thread.spent().size(), 3U);
  EXPECT_TRUE(thread.spent().empty()) << "each once";
}

TEST(RecordedFrame, BegunAnewHasNothingOfBefore) {
  RecordedFrame frame;
  frame.of_poses = true;
  frame.present = {1};
  frame.poses.resize(5);
  frame.contacts.resize(2);
  frame.events.emplace_back(1s, "it fell");
  frame.hash = 7;
  frame.state.resize(9);
  const Transformd* memory = frame.poses.data();
  frame.begin_anew(3s);
  EXPECT_EQ(frame.time, 3s);
  EXPECT_FALSE(frame.of_poses || frame.hash);
  EXPECT_TRUE(frame.present.empty() && frame.contacts.empty() && frame.events.empty() && frame.state.empty());
  EXPECT_EQ(frame.poses.data(), memory);
}

TEST(RecordingThread, ThrowsAwayAllAfterTheFirstMistake) {
  int calls = 0;
  RecordingThread thread([&](const RecordingThread::Batch&) {
    ++calls;
    throw SetupError("the disk is full");
  });
  for (int i = 0; i < 20; ++i) thread.push(RecordingThread::Batch(1));
  thread.finish();
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(thread.trouble(), "the disk is full");
}

}  // namespace
}  // namespace murosimf
