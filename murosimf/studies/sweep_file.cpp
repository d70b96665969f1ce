#include "murosimf/studies/sweep_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/file_lock.h"
#include "murosimf/files/input_file.h"
#include "murosimf/math/assert.h"

namespace murosimf::studies {
namespace {

constexpr std::uintmax_t most_bytes = 2'000'000'000;

[[noreturn]] void refuse_writing(const std::filesystem::path& file) {
  throw SetupError(fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(errno)));
}

/// The numbers of a line; empty if there are others than so many.
std::vector<double> parse_line(std::string_view line, std::size_t results, std::size_t& run) {
  const char* end = line.data() + line.size();
  auto place = std::from_chars(line.data(), end, run);
  std::vector<double> values;
  while (place.ec == std::errc{} && place.ptr != end && *place.ptr == ' ') {
    double value = 0;
    place = std::from_chars(place.ptr + 1, end, value);
    values.push_back(value);
  }
  const bool good = place.ec == std::errc{} && place.ptr == end && values.size() == results;
  return good ? values : std::vector<double>{};
}

std::string head_of(const std::string& what) { return "MuRoSimF sweep 1\n" + what + "\n"; }

/// Lines that are whole.
struct WholeLines {
  FinishedRuns runs;
  std::uintmax_t bytes = 0;
};

/// Throws SetupError: it is of another sweep, or no such file.
WholeLines parse(const std::string& text, const std::string& head, std::size_t results) {
  WholeLines whole;
  if (!text.starts_with(head)) {
    if (head.starts_with(text)) return whole;  // it was killed before its first run
    const bool is_sweep = text.starts_with(head.substr(0, head.find('\n') + 1));
    throw SetupError(is_sweep
                         ? "it is of another sweep: of other options, files or another version of the program; name "
                           "another file, or remove it"
                         : "it is no file of a sweep; name another one");
  }
  whole.bytes = head.size();
  while (whole.bytes < text.size()) {
    const std::size_t end = text.find('\n', whole.bytes);
    if (end == std::string::npos) break;  // the last line was cut off: its run is done again
    std::size_t run = 0;
    const std::string_view line = std::string_view(text).substr(whole.bytes, end - whole.bytes);
    const std::vector<double> values = parse_line(line, results, run);
    if (values.empty()) throw SetupError(fmt::format("byte {}: this is no run of the sweep", whole.bytes));
    whole.runs[run] = values;
    whole.bytes = end + 1;
  }
  return whole;
}

/// With all bits: NaN is not equal to itself.
std::string digits(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, " ")); }

std::vector<std::filesystem::path> text_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::ranges::sort(files);  // the same message whatever the order of the folder
  return files;
}

}  // namespace

SweepFile::SweepFile(std::filesystem::path file, const std::string& what, std::size_t results)
    : file_(std::move(file)) {
  const std::string head = head_of(what);
  std::uintmax_t good_bytes = 0;
  open();
  std::error_code error;
  const bool is_there = std::filesystem::exists(file_, error) && std::filesystem::file_size(file_, error) > 0;
  if (is_there) {
    const std::string text = files::read_input_file(file_, most_bytes);
    WholeLines whole = with_context(file_.string(), [&] { return parse(text, head, results); });
    known_ = std::move(whole.runs);
    good_bytes = whole.bytes;
    std::filesystem::resize_file(file_, good_bytes, error);  // the last line may have been cut off
    if (error) throw SetupError(fmt::format("cannot write '{}': {}", file_.string(), error.message()));
  }
  if (good_bytes > 0) return;
  if (std::fwrite(head.data(), 1, head.size(), stream_.get()) != head.size() || std::fflush(stream_.get()) != 0)
    refuse_writing(file_);
}

/// Locks the file, so that no other sweep continues it meanwhile.
void SweepFile::open() {
  stream_.reset(std::fopen(file_.c_str(), "ab"));
  if (!stream_) refuse_writing(file_);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file_, error) || files::lock_file(::fileno(stream_.get()))) return;
  throw SweepFileBusy(
      fmt::format("cannot write '{}': it is being written by {}", file_.string(), files::who_writes(file_)));
}

void SweepFile::add(std::size_t run, const std::vector<double>& values) {
  MUROSIMF_ASSERT(stream_ != nullptr && !values.empty());
  const std::string line = fmt::format("{} {}\n", run, fmt::join(values, " "));
  if (std::fwrite(line.data(), 1, line.size(), stream_.get()) != line.size() || std::fflush(stream_.get()) != 0)
    refuse_writing(file_);
}

FinishedRuns finished_runs(const std::filesystem::path& folder, const std::string& what, std::size_t results) {
  FinishedRuns all;
  for (const std::filesystem::path& file : text_files(folder)) {
    const std::string text = files::read_input_file(file, most_bytes);
    with_context(file.string(), [&] {
      for (const auto& [run, values] : parse(text, head_of(what), results).runs) {
        const auto [place, is_new] = all.try_emplace(run, values);
        if (is_new || digits(place->second) == digits(values)) continue;
        throw SetupError(fmt::format("run {}: its results are {} here, and {} in another file of this folder", run,
                                     digits(values), digits(place->second)));
      }
    });
  }
  return all;
}

}  // namespace murosimf::studies
