#include "murosimf/league/game_log.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {
namespace {

constexpr std::string_view first_line = "MuRoSimF game log 1";
constexpr std::uintmax_t most_log_bytes = 1'000'000'000;

/// Returns the text up to `separator`, and removes both from `text`; all of it if there is none.
std::string_view cut(std::string_view& text, char separator) {
  const auto end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

std::string bytes_of(std::string_view digits) {
  if (digits.size() % 2 != 0) throw SetupError("half of a byte");
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int high = digit(digits[i]), low = digit(digits[i + 1]);
    if (high < 0 || low < 0) throw SetupError("bytes must be hexadecimal digits, 0 to 9 and a to f");
    bytes.push_back(static_cast<char>(16 * high + low));
  }
  return bytes;
}

Duration time_of(std::string_view text) {
  Duration::rep time = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  if (error != std::errc{} || end != text.data() + text.size() || time < 0) {
    throw SetupError(fmt::format("'{:.30}' is no time in whole nanoseconds", text));
  }
  return Duration(time);
}

}  // namespace

GameLog GameLog::read(const std::filesystem::path& file) {
  return parse(files::read_input_file(file, most_log_bytes), file.string());
}

GameLog GameLog::parse(std::string_view text, const std::string& name) {
  if (cut(text, '\n') != first_line) throw SetupError(fmt::format("{}:1: this is no game log: '{}'", name, first_line));
  GameLog log;
  for (int line = 2; !text.empty(); ++line) {
    std::string_view rest = cut(text, '\n');
    with_context(fmt::format("{}:{}", name, line), [&] {
      const Duration time = time_of(cut(rest, ' '));
      const std::string channel(cut(rest, ' '));
      if (channel.empty()) throw SetupError("a line has a time, its sender and bytes");
      auto& entries = log.channels_[channel];
      if (!entries.empty() && entries.back().time > time) throw SetupError("this is before the line above");
      entries.push_back({time, bytes_of(rest)});
    });
  }
  return log;
}

/// Only the channels of the game: a recording has other input from outside, too.
GameLog GameLog::of(const ExternalInputLog& notes) {
  GameLog log;
  for (const std::string& name : notes.names()) {
    if (name != "game" && !name.starts_with("team:")) continue;
    std::vector<Entry>& entries = log.channels_[name];
    for (const ExternalInput& note : *notes.find(name)) entries.push_back({note.time, note.bytes});
  }
  return log;
}

std::string GameLog::to_text() const {
  std::vector<std::pair<Duration, std::string>> lines;
  for (const auto& [channel, entries] : channels_) {
    for (const Entry& entry : entries) {
      std::string line = fmt::format("{} {} ", entry.time.count(), channel);
      for (const char byte : entry.bytes) line += fmt::format("{:02x}", static_cast<unsigned char>(byte));
      lines.emplace_back(entry.time, std::move(line));
    }
  }
  // stable: lines of one instant stay together by channel
  std::ranges::stable_sort(lines, {}, [](const auto& line) { return line.first; });
  std::string text = fmt::format("{}\n", first_line);
  for (const auto& [time, line] : lines) text += line + "\n";
  return text;
}

std::vector<std::string> RecordedDatagrams::take(Duration now) {
  if (now <= last_) {  // the run has gone back in time, and repeats
    entries_->erase(std::ranges::lower_bound(*entries_, now, {}, &GameLog::Entry::time), entries_->end());
  }
  MUROSIMF_ASSERT(entries_->empty() || entries_->back().time < now);
  last_ = now;
  std::vector<std::string> taken = source_->take(now);
  for (const std::string& bytes : taken) entries_->push_back({now, bytes});
  return taken;
}

std::vector<std::string> NotedDatagrams::take(Duration now) {
  std::vector<std::string> taken = source_->take(now);
  for (const std::string& bytes : taken) notes_->push_back({now, ExternalInput::sent, bytes});
  return taken;
}

/// In a run that is repeated, what was received comes from the memory, at the instants at which it was taken then.
std::vector<std::string> RememberedDatagrams::take(Duration now) {
  if (!memory_->repeats()) {
    std::vector<std::string> taken = source_->take(now);
    for (const std::string& bytes : taken) memory_->write(ExternalInput::sent, bytes);
    return taken;
  }
  std::vector<std::string> taken;
  for (; const ExternalInput* note = memory_->next(); memory_->pass()) taken.push_back(note->bytes);
  return taken;
}

std::vector<std::string> RepeatedDatagrams::take(Duration now) {
  MUROSIMF_ASSERT(period_ > Duration{});
  // half a period of tolerance: a run with other steps gets each datagram at its nearest tick
  std::vector<std::string> taken;
  auto entry = std::ranges::upper_bound(entries_, now - period_ / 2, {}, &GameLog::Entry::time);
  for (; entry != entries_.end() && entry->time <= now + period_ / 2; ++entry) taken.push_back(entry->bytes);
  return taken;
}

}  // namespace murosimf::league
