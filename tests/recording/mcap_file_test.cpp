// What is written is read again, and what is damaged is told.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/compression.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_repair.h"
#include "tests/fixtures.h"
#include "tests/recording/small_recording.h"
#include "tests/sanitizer.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::filesystem::path write_bytes(const std::string& name, const std::string& bytes) {
  const auto file = fixtures::temp_folder() / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::filesystem::path recording_file(const std::string& name, bool closed = true, bool compressed = true) {
  const auto file = fixtures::temp_folder() / name;
  fixtures::write_small_recording(file, closed, compressed);
  return file;
}

/// All messages of a topic by log time [ns].
std::map<std::uint64_t, std::string> messages_of(const McapReader& reader, const std::string& topic) {
  std::map<std::uint64_t, std::string> found;
  for (const ChunkIndex& chunk : reader.contents().chunks) {
    reader.visit_messages(chunk, [&](const Message& message) {
      for (const Channel& channel : reader.contents().channels) {
        if (channel.id == message.channel_id && channel.topic == topic) found[message.log_time] = message.data;
      }
    });
  }
  return found;
}

void expect_all(const McapReader& reader) {
  const McapContents& contents = reader.contents();
  EXPECT_EQ(contents.header.library, "test");
  ASSERT_EQ(contents.schemas.size(), 1U);
  EXPECT_EQ(contents.schemas[0].name, "thing");
  ASSERT_EQ(contents.channels.size(), 2U);
  EXPECT_EQ(contents.channels[0].metadata.at("unit"), "m");
  EXPECT_EQ(contents.statistics.message_count, 550U);
  EXPECT_EQ(contents.statistics.end_time, 4'990'000'000U);
  EXPECT_EQ(contents.statistics.channel_message_counts.at(2), 50U);
  const auto a = messages_of(reader, "/a");
  ASSERT_EQ(a.size(), 500U);
  for (int step = 0; step < 500; ++step)
    EXPECT_EQ(a.at(10'000'000ULL * static_cast<unsigned>(step)), fixtures::small_message(step));
  EXPECT_EQ(messages_of(reader, "/b").size(), 50U);
  ASSERT_EQ(contents.attachments.size(), 1U);
  EXPECT_EQ(contents.attachments[0].data_size, 13U);
  EXPECT_EQ(reader.attachment(contents.attachments[0]).data, "duration = 3\n");
  ASSERT_EQ(contents.metadata.size(), 1U);
  EXPECT_EQ(reader.metadata(contents.metadata[0]).values.at("seed"), "7");
}

TEST(McapFile, IsReadAsItWasWritten) {
  for (const bool compressed : {true, false}) {
    const McapReader reader(recording_file("whole.mcap", true, compressed));
    EXPECT_EQ(reader.contents().damage, "");
    EXPECT_EQ(reader.contents().chunks.front().compression, compressed ? usual_compression() : "");
    EXPECT_EQ(reader.contents().chunks.size(), 10U);  // of 0.5 s
    expect_all(reader);
  }
}

TEST(McapFile, IsReadWithoutSummary) {
  const McapReader reader(recording_file("open.mcap", false));
  EXPECT_NE(reader.contents().damage.find("no summary at its end"), std::string::npos);
  expect_all(reader);
}

TEST(McapFile, LookingThroughFindsWhatTheSummarySays) {
  const auto file = recording_file("both.mcap");
  const McapReader by_summary(file), through_all(file, McapReading::through_all);
  EXPECT_EQ(through_all.contents().damage, "");
  expect_all(through_all);
  ASSERT_EQ(by_summary.contents().chunks.size(), through_all.contents().chunks.size());
  for (std::size_t i = 0; i < by_summary.contents().chunks.size(); ++i) {
    const ChunkIndex& one = by_summary.contents().chunks[i];
    const ChunkIndex& other = through_all.contents().chunks[i];
    EXPECT_EQ(one.offset, other.offset);
    EXPECT_EQ(one.length, other.length);
    EXPECT_EQ(one.uncompressed_size, other.uncompressed_size);
  }
}

TEST(McapFile, MessageIndexesLeadToTheMessages) {
  const auto file = recording_file("indexed.mcap", true, false);
  const std::string bytes = bytes_of(file);
  const McapReader reader(file);
  for (const ChunkIndex& chunk : reader.contents().chunks) {
    EXPECT_EQ(chunk.message_indexes.size(), 2U);
    for (const auto& [channel, offset] : chunk.message_indexes) {
      EXPECT_EQ(bytes.at(offset), static_cast<char>(Opcode::message_index)) << channel;
      EXPECT_GE(offset, chunk.offset + chunk.length);
      EXPECT_LT(offset, chunk.offset + chunk.length + chunk.message_index_length);
    }
  }
}

// Whatever of a file is there, its whole chunks are read: the messages up to 0.5 s before the last that was in it.
TEST(McapFile, CutOffAnywhereGivesItsWholeChunks) {
  const std::string whole = bytes_of(recording_file("cut_off.mcap"));
  const McapReader all(fixtures::temp_folder() / "cut_off.mcap");
  const std::vector<ChunkIndex> chunks = all.contents().chunks;
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t size = std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(random);
    const auto file = write_bytes("cut.mcap", whole.substr(0, size));
    const auto expected =
        std::ranges::count_if(chunks, [&](const ChunkIndex& c) { return c.offset + c.length <= size; });
    try {
      const McapReader reader(file);
      EXPECT_FALSE(reader.contents().damage.empty()) << size;
      EXPECT_EQ(reader.contents().chunks.size(), static_cast<std::size_t>(expected)) << size;
      const std::uint64_t last = expected > 0 ? chunks[static_cast<std::size_t>(expected) - 1].end_time : 0;
      EXPECT_EQ(reader.contents().statistics.end_time, last) << size;
    } catch (const SetupError& error) {
      ++refused;
      EXPECT_EQ(expected, 0) << size << ": " << error.what();
      EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": ", 0), 0U) << error.what();
    }
  }
  EXPECT_LT(refused, 10);  // the header is 0.2 % of the file
}

TEST(McapFile, MutatedIsReadOrRefusedWithItsName) {
  const std::string whole = bytes_of(recording_file("mutated_from.mcap"));
  std::mt19937 random(2);
  int noticed = 0;
  for (int i = 0; i < fixtures::tries(1000); ++i) {
    std::string bytes = whole;
    const int changes = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < changes; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    const auto file = write_bytes("mutated.mcap", bytes);
    for (const McapReading reading : {McapReading::by_summary, McapReading::through_all}) {
      try {
        const McapReader reader(file, reading);
        messages_of(reader, "/a");
        for (const AttachmentIndex& one : reader.contents().attachments) (void)reader.attachment(one);
        for (const MetadataIndex& one : reader.contents().metadata) (void)reader.metadata(one);
        noticed += reader.contents().damage.empty() ? 0 : 1;
      } catch (const SetupError& error) {
        ++noticed;
        EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": ", 0), 0U) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
  EXPECT_GT(noticed, fixtures::tries(1000));  // every chunk, attachment and summary has a checksum
}

TEST(McapFile, RepairedIsWhole) {
  const auto file = recording_file("open_again.mcap", false);
  const RepairReport report = repair(file, file);
  EXPECT_NE(report.damage, "");
  EXPECT_EQ(report.messages, 550U);
  EXPECT_DOUBLE_EQ(report.last_time, 4.99);
  const McapReader reader(file);
  EXPECT_EQ(reader.contents().damage, "");
  expect_all(reader);
}

TEST(McapFile, RepairLeavesOutOneDamagedChunk) {
  std::string bytes = bytes_of(recording_file("one_bad_chunk.mcap"));
  const auto file = fixtures::temp_folder() / "one_bad_chunk.mcap";
  const ChunkIndex third = McapReader(file).contents().chunks[2];
  bytes[third.offset + third.length - 5] ^= 1;
  write_bytes("one_bad_chunk.mcap", bytes);
  EXPECT_THROW(messages_of(McapReader(file), "/a"), SetupError);
  const auto mended = fixtures::temp_folder() / "mended.mcap";
  const RepairReport report = repair(file, mended);
  EXPECT_NE(report.damage.find("byte " + std::to_string(third.offset)), std::string::npos) << report.damage;
  EXPECT_EQ(report.messages, 550U - 55U);
  EXPECT_EQ(messages_of(McapReader(mended), "/a").size(), 450U);
}

// Behind each other, over each other, and mixed by two writers without locks.
TEST(McapFile, RepairSaysThatItHoldsTwoRuns) {
  const std::string one = bytes_of(recording_file("one.mcap")), cut = bytes_of(recording_file("cut_off.mcap", false));
  const auto third = McapReader(fixtures::temp_folder() / "one.mcap").contents().chunks[2].offset;
  const auto mended = fixtures::temp_folder() / "first.mcap";
  const std::map<std::string, std::string> files{{"behind.mcap", one + one},          // cat one two
                                                 {"behind_cut_off.mcap", cut + one},  // after one that was killed
                                                 {"over.mcap",
                                                  one + cut.substr(one.size() / 2)},  // the first ends sooner
                                                 {"over_later.mcap",
                                                  cut.substr(0, third) + one.substr(third) + cut.substr(third)},
                                                 {"mixed.mcap", cut.substr(0, third) + one.substr(8)}};
  for (const auto& [name, bytes] : files) {
    const auto file = write_bytes(name, bytes);
    EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)repair(file, file); }),
                               {name, "it holds two runs: at byte ", "--out", "nothing is changed"}))
        << name;
    EXPECT_EQ(bytes_of(file), bytes);
    const RepairReport report = repair(file, mended);
    EXPECT_NE(report.other_run, "") << name;
    EXPECT_GE(report.messages, 110U) << name;
    EXPECT_EQ(McapReader(mended).contents().damage, "") << name;
  }
  EXPECT_EQ(McapReader(write_bytes("one_run.mcap", one), McapReading::through_all).contents().other_run, "");
  EXPECT_EQ(McapReader(write_bytes("one_run.mcap", cut)).contents().other_run, "");
}

TEST(McapFile, SaysThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  try {
    fixtures::write_small_recording("/dev/full");
    FAIL() << "the damage was not noticed";
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "cannot write '/dev/full': No space left on device");
  }
}

TEST(McapFile, RefusesWhatIsNone) {
  EXPECT_THROW(McapReader(write_bytes("text.mcap", "time [s],x\n")), SetupError);
  EXPECT_THROW(McapReader(fixtures::temp_folder() / "nothing.mcap"), SetupError);
}

}  // namespace
}  // namespace murosimf
